//! Points in the unit cube: scrambled Sobol' sequences, and streams of random numbers.
//!
//! Both can be entered anywhere: the point with number i, the numbers of block b. So work can be shared out among any number of
//! threads, and more points begin with the ones already taken.

mod numbers;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use numbers::DIRECTIONS;

/// The most coordinates a Sobol' point can have.
pub const MOST_COORDINATES: usize = DIRECTIONS.len() + 1;

/// A number in (0, 1), neither end of it, from 53 bits.
fn open(bits: u64) -> f64 {
    const STEP: f64 = 1.0 / (1u64 << 53) as f64;
    ((bits >> 11) as f64 + 0.5) * STEP
}

/// A Sobol' sequence in base 2 with the direction numbers of Joe and Kuo (SIAM Journal on Scientific Computing 30, 2008; set
/// D6), scrambled as Owen does: each bit is turned or not by chance that depends on all bits before it. A scrambled point is
/// uniform, and the points of one sequence still fill the cube evenly, so that the mean over several scrambles has an honest
/// interval.
#[derive(Debug, Clone)]
pub struct Sobol {
    /// Of each coordinate: the numbers that the bits of an index add, and the key of its scramble.
    coordinates: Vec<([u64; 64], u64)>,
}

impl Sobol {
    /// The sequence with so many coordinates, in the scramble with this number of this seed.
    ///
    /// # Panics
    /// For more than [`MOST_COORDINATES`].
    pub fn new(coordinates: usize, seed: u64, scramble: u64) -> Sobol {
        assert!(
            coordinates <= MOST_COORDINATES,
            "{coordinates} coordinates, at most {MOST_COORDINATES} can be had"
        );
        let key = mixed(mixed(seed).wrapping_add(scramble));
        let coordinate = |i: usize| (directions(i), mixed(key.wrapping_add(i as u64)));
        Sobol { coordinates: (0..coordinates).map(coordinate).collect() }
    }

    /// The coordinates of the point with number `index`, each in (0, 1).
    pub fn point(&self, index: u64) -> impl Iterator<Item = f64> {
        self.coordinates.iter().map(move |(directions, key)| {
            let (mut bits, mut rest) = (0, index);
            while rest != 0 {
                bits ^= directions[rest.trailing_zeros() as usize];
                rest &= rest - 1;
            }
            open(scrambled(bits, *key))
        })
    }
}

/// The direction numbers of one coordinate, the first bit of the fraction leftmost.
fn directions(coordinate: usize) -> [u64; 64] {
    if coordinate == 0 {
        return std::array::from_fn(|bit| 1 << (63 - bit));
    }
    let (polynomial, first) = DIRECTIONS[coordinate - 1];
    let degree = first.len();
    let mut v = [0u64; 64];
    for bit in 0..64 {
        v[bit] = if bit < degree {
            first[bit] << (63 - bit)
        } else {
            let last = v[bit - degree];
            (1..degree)
                .filter(|k| polynomial >> (degree - 1 - k) & 1 == 1)
                .fold(last ^ (last >> degree), |sum, k| sum ^ v[bit - k])
        };
    }
    v
}

/// Number of bits turned one by one. Points that agree in all of these come after 2³² others; what follows in them is
/// turned at once.
const NESTED: u32 = 32;

fn scrambled(bits: u64, key: u64) -> u64 {
    let mut turns = 0;
    for level in 0..NESTED {
        // The bits before this one, with a 1 in front that tells how many they are.
        let before = (1 << level) | bits.unbounded_shr(64 - level);
        turns |= mixed(key ^ before.wrapping_mul(GOLDEN)) >> 63 << (63 - level);
    }
    let before = (1 << NESTED) | bits >> (64 - NESTED);
    bits ^ (turns | mixed(key ^ before.wrapping_mul(GOLDEN)) >> NESTED)
}

const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// A number that looks unlike the one given (Steele, Lea and Flood's SplitMix64, OOPSLA 2014).
fn mixed(x: u64) -> u64 {
    let x = x.wrapping_add(GOLDEN);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// Random numbers in (0, 1): ChaCha with eight rounds, by seed and stream.
#[derive(Debug, Clone)]
pub struct Stream(ChaCha8Rng);

impl Stream {
    /// The stream with this number of this seed.
    pub fn new(seed: u64, stream: u64) -> Stream {
        let mut generator = ChaCha8Rng::seed_from_u64(seed);
        generator.set_stream(stream);
        Stream(generator)
    }

    /// The next number, in (0, 1).
    pub fn draw(&mut self) -> f64 {
        open(self.0.next_u64())
    }

    /// The next numbers, each in (0, 1).
    pub fn fill(&mut self, numbers: &mut [f64]) {
        const WIDTH: usize = size_of::<u64>();
        let mut bytes = [0; 64 * WIDTH];
        for run in numbers.chunks_mut(64) {
            let bytes = &mut bytes[..WIDTH * run.len()];
            self.0.fill_bytes(bytes);
            for (number, bytes) in run.iter_mut().zip(bytes.as_chunks::<WIDTH>().0) {
                *number = open(u64::from_le_bytes(*bytes));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Unscrambled bits of a coordinate.
    fn plain(sobol: &Sobol, coordinate: usize, index: u64) -> u64 {
        let directions = &sobol.coordinates[coordinate].0;
        (0..64).filter(|bit| index >> bit & 1 == 1).fold(0, |sum, bit| sum ^ directions[bit])
    }

    /// Each coordinate is a (0, 1)-sequence: of any aligned 2ᵐ points one lies in each of 2ᵐ equal cells, scrambled too. Each pair
    /// of the first two is a (0, 2)-sequence: one in each cell of any 2ᵃ by 2ᵐ⁻ᵃ.
    #[test]
    fn points_fill_cells_evenly() {
        for (seed, scramble) in [(1, 0), (1, 1), (77, 5)] {
            let sobol = Sobol::new(MOST_COORDINATES, seed, scramble);
            for block in [0u64, 3, 1 << 20] {
                let points: Vec<Vec<f64>> =
                    (0..256).map(|i| sobol.point(block * 256 + i).collect()).collect();
                for coordinate in 0..MOST_COORDINATES {
                    let mut cells: Vec<u32> = points.iter().map(|p| (p[coordinate] * 256.0) as u32).collect();
                    cells.sort_unstable();
                    assert!(
                        cells.iter().enumerate().all(|(i, &cell)| i as u32 == cell),
                        "coordinate {coordinate}"
                    );
                }
                for a in 0..=8 {
                    let (wide, high) = (f64::from(1 << a), f64::from(256 >> a));
                    let mut cells: Vec<u32> =
                        points.iter().map(|p| ((p[0] * wide) as u32) << 8 | (p[1] * high) as u32).collect();
                    cells.sort_unstable();
                    cells.dedup();
                    assert_eq!(cells.len(), 256, "2^{a} by 2^{}", 8 - a);
                }
            }
        }
    }

    /// Direction numbers begin with a 1 at their own bit, so that the first 2ᵐ points differ in m bits; the first points of the
    /// second and third coordinate are 0, ½, ¼, ¾ and 0, ½, ¾, ¼ (in the order without Gray's code).
    #[test]
    fn first_points_are_those_of_the_tables() {
        let sobol = Sobol::new(3, 1, 0);
        let points = |coordinate| [0u64, 1, 2, 3].map(|i| plain(&sobol, coordinate, i) >> 62);
        assert_eq!(points(0), [0, 2, 1, 3]);
        assert_eq!(points(1), [0, 2, 3, 1]);
        for coordinate in 0..MOST_COORDINATES {
            assert!(
                directions(coordinate)
                    .iter()
                    .enumerate()
                    .all(|(bit, v)| v.trailing_zeros() as usize == 63 - bit)
            );
        }
    }

    /// A scramble is a permutation that keeps common beginnings of the same length, and turns each bit half of the time.
    #[test]
    fn scrambles_are_nested_and_fair() {
        let pairs = [(0u64, 1 << 63), (5 << 50, 4 << 50), (u64::MAX, u64::MAX << 30)];
        for key in 0..200u64 {
            for (a, b) in pairs {
                let common = (a ^ b).leading_zeros();
                assert_eq!((scrambled(a, key) ^ scrambled(b, key)).leading_zeros(), common);
            }
        }
        for bit in 0..64 {
            let turned = (0..4000).filter(|&key| scrambled(0, mixed(key)) >> bit & 1 == 1).count();
            assert!((1850..2150).contains(&turned), "bit {bit}: {turned} of 4000");
        }
    }

    /// A stream can be taken up again, and streams of one seed differ.
    #[test]
    fn streams_are_counted() {
        let take = |seed, stream| {
            let mut numbers = Stream::new(seed, stream);
            [numbers.draw(), numbers.draw(), numbers.draw()]
        };
        assert_eq!(take(1, 0), take(1, 0));
        assert_ne!(take(1, 0), take(1, 1));
        assert_ne!(take(1, 0), take(2, 0));
        let (mut one, mut many) = (Stream::new(5, 2), Stream::new(5, 2));
        for count in [1, 3, 64, 65, 300] {
            let mut numbers = vec![0.0; count];
            many.fill(&mut numbers);
            assert!(numbers.iter().all(|number| *number == one.draw()), "{count} at once");
        }
        let mut numbers = Stream::new(3, 9);
        let mean = (0..100_000).map(|_| numbers.draw()).sum::<f64>() / 1e5;
        assert!((mean - 0.5).abs() < 4.0 / 12f64.sqrt() / 1e5f64.sqrt());
    }
}
