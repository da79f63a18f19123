//! The loop over columns that decides modes; of every instruction set the same codes.

use super::Columns;
use super::instructions::{InstructionSet, Kernel};
use crate::sign::{self, Float, Terms, terms_of_any};

/// Points that the kernel takes at once: few enough that what lies between its passes stays in the first-level cache, with room for what
/// is being fetched.
const LANES: usize = 64;

/// The code of a point that the kernel is not sure of.
pub(super) const UNSURE: u8 = sign::UNSURE as u8;

/// The kernel alone, without the exact second look, on one instruction set; public for tests and benchmarks, which
/// compare them. On a processor that lacks the set, the baseline.
#[doc(hidden)]
pub fn screen_with(set: InstructionSet, columns: Columns<'_>, codes: &mut [u8]) {
    set.run(Screening { columns, codes });
}

struct Screening<'a> {
    columns: Columns<'a>,
    codes: &'a mut [u8],
}

impl Kernel for Screening<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        screen_all(self.columns, self.codes);
    }
}

#[inline(always)]
fn screen_all(columns: Columns<'_>, codes: &mut [u8]) {
    let mut screen = Screen::default();
    // The rest apart, so that the compiler knows how long a block is.
    let (blocks, rest) = codes.as_chunks_mut::<LANES>();
    let in_blocks = LANES * blocks.len();
    for (block, codes) in blocks.iter_mut().enumerate() {
        screen.screen(columns.slice(LANES * block, LANES), codes);
    }
    screen.screen(columns.slice(in_blocks, rest.len()), rest);
}

/// State of the kernel beside the columns.
#[derive(Default)]
struct Screen {
    narrow: Lanes<f32>,
    wide: Lanes<f64>,
    /// Number of coming blocks left to f64, because f32 could not tell much of the last: columns along a boundary, such as a search for it
    /// asks for.
    left: usize,
}

impl Screen {
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

/// The decision without the kernel's bound, of valid points; public for the benchmark that compares the kernels with it.
#[doc(hidden)]
pub fn exactly(columns: Columns<'_>, codes: &mut [u8]) {
    let Columns { gamma, k_prime, k, mu } = columns;
    for (index, code) in codes.iter_mut().enumerate() {
        *code = sign::exact([gamma[index], k_prime[index], k[index], mu[index]]) as u8;
    }
}
