//! The loop over columns, compiled for several instruction sets. All of them do the same operations, rounded alike, and give the same codes.

use super::Columns;
use crate::sign::{self, Float, Terms, terms_of_any};

/// Points that the kernel takes at once: few enough that what lies between its passes stays in the first-level cache, with room for what
/// is being fetched.
const LANES: usize = 64;

/// The code of a point that the kernel is not sure of.
pub(super) const UNSURE: u8 = sign::UNSURE as u8;

/// The kernel, to be compiled once for every instruction set: hence no closure, which would be compiled for the baseline.
#[inline(always)]
fn screen_all(columns: Columns<'_>, codes: &mut [u8]) {
    let mut kernel = Kernel::default();
    // The rest apart, so that the compiler knows how long a block is.
    let (blocks, rest) = codes.as_chunks_mut::<LANES>();
    let in_blocks = LANES * blocks.len();
    for (block, codes) in blocks.iter_mut().enumerate() {
        kernel.screen(columns.slice(LANES * block, LANES), codes);
    }
    kernel.screen(columns.slice(in_blocks, rest.len()), rest);
}

/// State of the kernel beside the columns.
#[derive(Default)]
struct Kernel {
    narrow: Lanes<f32>,
    wide: Lanes<f64>,
    /// Number of coming blocks left to f64, because f32 could not tell much of the last: columns along a boundary, such as a search for it
    /// asks for.
    left: usize,
}

impl Kernel {
    /// Screens up to [`LANES`] points.
    #[inline(always)]
    fn screen(&mut self, columns: Columns<'_>, codes: &mut [u8]) {
        if self.left == 0 {
            let unsure = self.narrow.screen(columns, codes);
            if unsure == 0 {
                return;
            }
            self.left = if unsure < LANES / 8 { 1 } else { 64 };
        }
        self.left -= 1;
        self.wide.screen(columns, codes);
    }
}

/// Up to [`LANES`] points between the passes of the kernel: their terms, and the codes of their modes.
struct Lanes<F> {
    terms: Terms<[F; LANES]>,
    codes: [u32; LANES],
}

impl<F: Float> Default for Lanes<F> {
    fn default() -> Lanes<F> {
        Lanes { terms: [[F::default(); LANES]; 4], codes: [0; LANES] }
    }
}

impl<F: Float> Lanes<F> {
    /// Screens up to [`LANES`] points, and counts those it is not sure of. In passes, each over numbers of one width, because only of
    /// these the compiler makes vectors as long as they can be.
    #[inline(always)]
    fn screen(&mut self, columns: Columns<'_>, codes: &mut [u8]) -> usize {
        let count = codes.len();
        let Columns { gamma, k_prime, k, mu } = columns.slice(0, count);
        let [γ, arm, surplus, μ] = self.terms.each_mut().map(|term| &mut term[..count]);
        for i in 0..count {
            [γ[i], arm[i], surplus[i], μ[i]] = terms_of_any([gamma[i], k_prime[i], k[i], mu[i]]);
        }
        for i in 0..count {
            self.codes[i] = sign::screen([γ[i], arm[i], surplus[i], μ[i]]);
        }
        let mut unsure = 0;
        for (code, wide) in codes.iter_mut().zip(&self.codes) {
            *code = *wide as u8;
            unsure += *code / UNSURE;
        }
        usize::from(unsure)
    }
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{Columns, screen_all};

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
    pub(super) fn screen_avx512(columns: Columns<'_>, codes: &mut [u8]) {
        screen_all(columns, codes);
    }

    #[target_feature(enable = "avx2")]
    pub(super) fn screen_avx2(columns: Columns<'_>, codes: &mut [u8]) {
        screen_all(columns, codes);
    }
}

/// An instruction set the kernel is compiled for.
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
}

/// The kernel alone, without the exact second look, on one instruction set; public for tests and benchmarks, which
/// compare them. On a processor that lacks the set, the baseline.
#[doc(hidden)]
pub fn screen_with(set: InstructionSet, columns: Columns<'_>, codes: &mut [u8]) {
    match set {
        // SAFETY: in both, the processor has the instructions the function is compiled for.
        #[cfg(target_arch = "x86_64")]
        #[expect(unsafe_code, reason = "the only way to call code compiled for a detected instruction set")]
        InstructionSet::Avx512 if set.is_available() => unsafe { x86::screen_avx512(columns, codes) },
        #[cfg(target_arch = "x86_64")]
        #[expect(unsafe_code, reason = "the only way to call code compiled for a detected instruction set")]
        InstructionSet::Avx2 if set.is_available() => unsafe { x86::screen_avx2(columns, codes) },
        _ => screen_all(columns, codes),
    }
}

/// The decision without the kernel's bound, of valid points; public for the benchmark that compares the kernels with it.
#[doc(hidden)]
pub fn exactly(columns: Columns<'_>, codes: &mut [u8]) {
    let Columns { gamma, k_prime, k, mu } = columns;
    for (index, code) in codes.iter_mut().enumerate() {
        *code = sign::exact([gamma[index], k_prime[index], k[index], mu[index]]) as u8;
    }
}
