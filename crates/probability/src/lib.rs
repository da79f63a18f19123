//! Probabilities of outcomes whose boundaries are known along one of several random inputs.
//!
//! Whoever knows, for given values of all other inputs, on which intervals of one input each outcome holds, need not sample that
//! one: its law gives the probability of an interval. What is left to average over the others is a continuous function, not an
//! indicator, and small probabilities are as quick as large ones. This crate knows no mechanics; it asks for
//! [`Outcomes`](problem::Outcomes) and answers by
//!
//! | module | method | for |
//! |---|---|---|
//! | [`integrate`] | panels between the kinks, two inputs beside the line at most | all digits, where the scan met every kink |
//! | [`sample::sobol`] | scrambled Sobol' points, with an interval | more inputs |
//! | [`sample::importance`] | the same about design points | small probabilities |
//! | [`sample::monte_carlo`] | everything drawn, hits counted | to be believed by anyone |
//! | [`life`] | years drawn, intervals of the line united | at least once in a life |
//! | [`row`] | bodies and years drawn, intervals of the line united | any of several alike |
//! | [`sums`] | means integrated, lives drawn by what adds | sums over many events |
//! | [`lognormal`] | the nearest curve, as of counts the likeliest | fragility along a number |
//! | [`method`] | one of these by its name, or the one that suits | |
//! | [`limit_state`] | a function whose sign tells, scanned along one input | published problems |
//! | [`fit`] | the likeliest parameters, and how sure they are | laws of values that were measured |
//! | [`slopes`] | differences with the same points | what a law’s mean and deviation do |
//! | [`form`] | nearest points, β and α, without gradients | which input matters |
//!
//! Laws ([`law`]) and their correlation by a normal copula ([`copula`]) are accurate in both tails.
//!
//! ```
//! use standfast_probability::law::Law;
//! use standfast_probability::problem::{Outcomes, Pieces, RandomVector};
//! use standfast_probability::{form, integrate::{Within, integrate}};
//!
//! /// Fails where the first input, a resistance, is below the second, a load.
//! struct Fails;
//!
//! impl Outcomes for Fails {
//!     fn count(&self) -> usize { 1 }
//!     fn line(&self) -> usize { 0 }
//!     fn along(&self, values: &[f64], pieces: &mut Pieces) {
//!         pieces.push(f64::NEG_INFINITY, values[1], 0);
//!     }
//!     fn at(&self, values: &[f64]) -> u64 { u64::from(values[0] < values[1]) }
//! }
//!
//! let inputs = RandomVector::independent(vec![Law::normal(0.6, 0.06)?.into(), Law::normal(0.3, 0.08)?.into()]);
//! let failing = 1; // the set of outcome 0
//! let p = integrate(&inputs, &Fails, &[failing], Within::ALL_DIGITS)?.probabilities[0];
//! assert!((p - 0.00135).abs() < 1e-5); // Φ(−3)
//! let point = form::design_point(&inputs, &Fails, failing).unwrap();
//! assert!((point.beta - 3.0).abs() < 1e-9);
//! assert!((point.alpha[0] + 0.6).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod beta;
pub mod copula;
pub mod fit;
pub mod form;
mod fraction;
mod gamma;
mod inputs;
pub mod integrate;
pub mod law;
pub mod legendre;
pub mod life;
pub mod limit_state;
pub mod lognormal;
pub mod method;
pub mod normal;
pub mod points;
pub mod problem;
mod roots;
pub mod row;
pub mod sample;
mod simplex;
pub mod slopes;
pub mod sums;

/// Largest distance looked at in standard normals: beyond ±12 lies 4e-33.
pub(crate) const REACH: f64 = 12.0;
