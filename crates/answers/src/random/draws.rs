//! Draws: values of the random numbers, and what each set of them makes of the body.

use standfast::Mode;
use standfast_probability::sample;

use super::answer::{Happening, Probability};
use super::error::ProbabilityError;
use super::mechanics::Mechanics;
use super::problem::ChanceProblem;
use super::quantity::{Quantity, RandomInput};
use super::stack::Asked;
use super::subject::ChanceSubject;
use crate::units::Dimension;
use standfast_model::CaseFile;
use standfast_probability::method::Method;

/// Draws of the random numbers of a case, with the mode under each: those of plain Monte Carlo with the same seed, the first of
/// them for any count.
#[derive(Debug, Clone, PartialEq)]
pub struct Draws {
    /// Random numbers: names, and the units of values, where they have one.
    pub inputs: Vec<(String, Option<&'static str>)>,
    /// The values of each, one for each draw.
    pub values: Vec<Vec<f64>>,
    /// Outcome of each draw for the body.
    pub drawn: Vec<Draw>,
    /// Outcomes that there are where no modes are told: of bodies on joints, and on a base seen from above.
    outcomes: Vec<Happening>,
}

/// Outcome of a draw for the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Draw {
    /// |X|/V and −M/(X H) of a body that the report's plane is of; none of any other, or where no force acts or nothing presses it
    /// on its base.
    pub effective: Option<[f64; 2]>,
    /// The mode.
    pub happens: Happening,
}

impl Draws {
    /// So many draws of a file with a `[random]` table. `situation` says which loads act where the case leaves a choice.
    ///
    /// # Errors
    /// As [`Probability::of`](super::Probability::of); or if the case has several situations and none of them is named.
    pub fn of(
        file: &CaseFile,
        situation: Option<&str>,
        count: u64,
        seed: u64,
    ) -> Result<Draws, ProbabilityError> {
        let problem = one(ChanceSubject::of(file, None)?.problems(None)?, situation)?;
        let mut values: Vec<Vec<f64>> = problem.random().iter().map(|_| Vec::new()).collect();
        let mut drawn = Vec::new();
        sample::draws(problem.laws(), seed, count, |draw| {
            values.iter_mut().zip(draw).for_each(|(column, value)| column.push(*value));
            drawn.push(problem.drawn(draw));
        });
        let inputs = problem.random().iter().map(|input| (input.name.clone(), input.unit())).collect();
        let outcomes =
            problem.exclusive().filter(|_| problem.is_without_modes()).map(Happening::of).collect();
        Ok(Draws { inputs, values, drawn, outcomes })
    }

    /// The names of what may happen to bodies on joints, or on a base seen from above; `None` of a body with modes.
    pub fn of_joints(&self) -> Option<Vec<String>> {
        (!self.outcomes.is_empty()).then(|| self.outcomes.iter().map(|outcome| outcome.name()).collect())
    }
}

/// Draws of an answer, each as likely as the others, with their weights: what each mode has of all weights is its share of the draws, and
/// by plain Monte Carlo its probability.
#[derive(Debug, Clone, PartialEq)]
pub struct WeighedDraws {
    /// Random numbers: names, and the units of values, where they have one.
    pub inputs: Vec<(String, Option<&'static str>)>,
    /// The values of each, one for each draw.
    pub values: Vec<Vec<f64>>,
    /// Index of the [situation](Self::situations) of each.
    pub of: Vec<usize>,
    /// The weight of each, in its situation.
    pub weights: Vec<f64>,
    /// Outcome of each for the body.
    pub happens: Vec<Happening>,
    /// The sets of loads, as an answer has them; none where there is only one.
    pub situations: Vec<Option<String>>,
}

/// So many draws go with an answer for which not everything is drawn.
const DRAWS: u64 = 1 << 16;

impl WeighedDraws {
    /// The draws of the answer to this file: all that plain Monte Carlo counted. Other methods integrate a number or take other points; of
    /// them it is as many draws as their points allow, 65 536 at most, drawn independently by the laws with the same seed.
    ///
    /// # Errors
    /// If it is another file, or of a storm without a body.
    pub fn of(file: &CaseFile, answer: &Probability) -> Result<WeighedDraws, ProbabilityError> {
        let asked = ChanceSubject::of(file, answer.request.years)?;
        let problems = asked.problems(None)?;
        let mut all = WeighedDraws {
            inputs: Vec::new(),
            values: vec![Vec::new(); problems[0].random().len()],
            of: Vec::new(),
            weights: Vec::new(),
            happens: Vec::new(),
            situations: answer.situations.iter().map(|chances| chances.situation.clone()).collect(),
        };
        all.inputs = problems[0].random().iter().map(|input| (input.name.clone(), input.unit())).collect();
        for (place, chances) in answer.situations.iter().enumerate() {
            let same = |problem: &&ChanceProblem| problem.situation() == chances.situation;
            let problem = problems.iter().find(same).ok_or(ProbabilityError::NoRandom)?;
            let count = match chances.method {
                Method::MonteCarlo => chances.points,
                _ => answer.request.effort.points.clamp(1, DRAWS),
            };
            let weight = 1.0 / count as f64;
            sample::draws(problem.laws(), answer.request.effort.seed, count, |draw| {
                all.values.iter_mut().zip(draw).for_each(|(column, value)| column.push(*value));
                all.of.push(place);
                all.weights.push(weight);
                all.happens.push(problem.drawn(draw).happens);
            });
        }
        Ok(all)
    }
}

/// The problem of the situation that is named, or the only one.
fn one(problems: Vec<ChanceProblem>, situation: Option<&str>) -> Result<ChanceProblem, ProbabilityError> {
    let known: Vec<String> = problems.iter().filter_map(ChanceProblem::situation).collect();
    let several = problems.len() > 1;
    let mut found = problems.into_iter().filter(|problem| match situation {
        None => !several,
        Some(asked) => problem.situation().as_deref() == Some(asked),
    });
    found.next().ok_or_else(|| ProbabilityError::Situation { asked: situation.map(str::to_owned), known })
}

impl ChanceProblem {
    /// Outcome for the body of one set of values.
    pub fn drawn(&self, values: &[f64]) -> Draw {
        if self.is_on_plan() {
            let happens = Happening::reported(self.on_plan(values, Asked::Full));
            return Draw { effective: None, happens };
        }
        let Some(mechanics) = self.mechanics(values) else {
            return Draw { effective: None, happens: Happening::NotABody };
        };
        Draw { effective: mechanics.effective(), happens: Happening::reported(mechanics.outcomes()) }
    }
}

/// A draw in the report's plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawInPlane {
    /// γ, k, k' and μ, effective coordinates.
    pub at: [f64; 4],
    /// True if the force acts to the right, where modes are those of a mirror.
    pub right: bool,
}

impl ChanceProblem {
    /// Place of a draw in the report's plane, where that is of the body.
    pub fn in_plane(&self, values: &[f64]) -> Option<DrawInPlane> {
        let mechanics = self.mechanics(values).filter(|_| !self.is_on_plan())?;
        let [k, k_prime] = mechanics.effective()?;
        let block = &mechanics.block;
        Some(DrawInPlane { at: [block.d, k, k_prime, block.mu_s], right: mechanics.wrench().x > 0.0 })
    }
}

impl Mechanics {
    /// The point of the report's plane, k and k', as [`Situation::effective`](standfast::Situation::effective) has it.
    fn effective(&self) -> Option<[f64; 2]> {
        let (block, wrench) = (&self.block, self.wrench());
        // A uniform body in air with one friction. Lengths are in B, so that only rounding parts them from 1.
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b;
        let uniform =
            near(block.b1, 1.0) && near(block.b2, 1.0) && near(block.rho2, (1.0 + block.d * block.d) / 3.0);
        let ordinary = self.above.is_empty() && uniform && block.m_x == 1.0 && block.mu_s == block.mu_k;
        let point = [wrench.x.abs() / wrench.p, -wrench.m / (wrench.x * block.d)];
        (ordinary && wrench.p > 0.0 && wrench.x != 0.0 && point.iter().all(|x| x.is_finite()))
            .then_some(point)
    }
}

impl Happening {
    /// The one of the outcomes that hold which excludes the others.
    fn reported(outcomes: u64) -> Happening {
        super::outcome::exclusive(true)
            .chain(super::outcome::of_joints(super::outcome::MOST_JOINTS, false))
            .chain(super::outcome::on_plan())
            .find(|outcome| outcomes >> outcome & 1 == 1)
            .map_or(Happening::NotABody, Happening::of)
    }

    /// The mode, where it is one.
    pub fn mode(self) -> Option<Mode> {
        match self {
            Happening::Decided(verdict) => verdict.mode(),
            Happening::First(_) | Happening::OnPlan { .. } | Happening::NoMode | Happening::NotABody => None,
        }
    }
}

impl RandomInput {
    /// The SI unit of its values.
    pub fn unit(&self) -> Option<&'static str> {
        self.dimension().map(Dimension::si)
    }

    /// The dimension of its values.
    pub fn dimension(&self) -> Option<Dimension> {
        let of = match &self.quantity {
            Quantity::Key(variable) | Quantity::Rise(variable) => variable,
            Quantity::Storm(field) => return field.dimension(),
            Quantity::Fitted { of, has_dimension: true, .. } => match &**of {
                Quantity::Key(variable) => variable,
                Quantity::Storm(field) => return field.dimension(),
                _ => return None,
            },
            _ => return None,
        };
        of.dimension()
    }
}
