//! Loops compiled for several instruction sets. All of them do the same operations, rounded alike, and give the same numbers.

/// A loop, to be compiled once for every instruction set.
pub(super) trait Kernel {
    type Output;

    /// Runs the loop. It and what it calls are to be inlined always and to have no closures, which would be compiled for the baseline.
    fn run(self) -> Self::Output;
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::Kernel;

    pub(super) fn has_avx512() -> bool {
        is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512bw")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("avx512vl")
    }

    pub(super) fn has_avx2() -> bool {
        is_x86_feature_detected!("avx2")
    }

    #[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl")]
    pub(super) fn run_avx512<K: Kernel>(kernel: K) -> K::Output {
        kernel.run()
    }

    #[target_feature(enable = "avx2")]
    pub(super) fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
        kernel.run()
    }
}

/// An instruction set the kernels are compiled for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[doc(hidden)]
pub enum InstructionSet {
    Avx512,
    Avx2,
    Baseline,
}

impl InstructionSet {
    /// All, the best first.
    pub const ALL: [InstructionSet; 3] =
        [InstructionSet::Avx512, InstructionSet::Avx2, InstructionSet::Baseline];

    /// The best that this processor has.
    pub(super) fn best() -> InstructionSet {
        let set = InstructionSet::ALL.into_iter().find(|set| set.is_available());
        set.expect("every processor has the baseline")
    }

    /// True if this processor has it.
    pub fn is_available(self) -> bool {
        match self {
            InstructionSet::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            InstructionSet::Avx512 => x86::has_avx512(),
            #[cfg(target_arch = "x86_64")]
            InstructionSet::Avx2 => x86::has_avx2(),
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// Runs a kernel as it is compiled for this set; on a processor that lacks the set, for the baseline.
    pub(super) fn run<K: Kernel>(self, kernel: K) -> K::Output {
        match self {
            // SAFETY: in both, the processor has the instructions the function is compiled for.
            #[cfg(target_arch = "x86_64")]
            #[expect(
                unsafe_code,
                reason = "the only way to call code compiled for a detected instruction set"
            )]
            InstructionSet::Avx512 if self.is_available() => unsafe { x86::run_avx512(kernel) },
            #[cfg(target_arch = "x86_64")]
            #[expect(
                unsafe_code,
                reason = "the only way to call code compiled for a detected instruction set"
            )]
            InstructionSet::Avx2 if self.is_available() => unsafe { x86::run_avx2(kernel) },
            _ => kernel.run(),
        }
    }
}
