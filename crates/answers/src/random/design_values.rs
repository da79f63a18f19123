//! Values of the numbers for which a design by them has a target index, and the partial factors that they are: EN 1990, Annex C.
//!
//! With α at the nearest point at which the body does not rest, the design value of a number is F⁻¹(Φ(αβ)). A partial factor is that over the
//! characteristic value, here the fractile of 95 % of what is unfavourable where it is high, or that of 5 % over it of what is so where it is low.

use standfast_probability::form::FormPoint;
use standfast_probability::problem::RandomVector;

/// Design values at a target index.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignValues {
    /// The index.
    pub beta: f64,
    /// That of each number, in their order.
    pub numbers: Vec<DesignValue>,
}

/// The design value of a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DesignValue {
    /// Its cosine at the nearest point, with the sign of what is unfavourable.
    pub alpha: f64,
    /// The value.
    pub value: f64,
    /// The share of the law below the characteristic value: 0.95 of what is unfavourable where it is high, else 0.05.
    pub fractile: f64,
    /// The characteristic value; of a law that depends on other numbers that at their medians.
    pub characteristic: f64,
    /// The partial factor; `None` where one of both is not above zero.
    pub factor: Option<f64>,
}

/// The shares of a law below its characteristic values: of what is unfavourable where it is low, and where it is high.
const FRACTILES: [f64; 2] = [0.05, 0.95];

impl DesignValues {
    /// Those of random numbers whose nearest point this is.
    pub(super) fn of(laws: &RandomVector, point: &FormPoint, beta: f64) -> DesignValues {
        let u: Vec<f64> = point.alpha.iter().map(|alpha| alpha * beta).collect();
        let z = laws.copula().correlated(&u);
        let values = laws.values_of(&z);
        let numbers = laws.laws().iter().zip(z).zip(values).map(|((law, z), value)| {
            let is_load = z > 0.0;
            let fractile = FRACTILES[usize::from(is_load)];
            let characteristic = law.value_of_chance(fractile);
            let [over, under] = if is_load { [value, characteristic] } else { [characteristic, value] };
            let factor = (over > 0.0 && under > 0.0).then(|| over / under);
            DesignValue { alpha: z / beta, value, fractile, characteristic, factor }
        });
        DesignValues { beta, numbers: numbers.collect() }
    }
}
