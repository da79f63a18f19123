//! Random numbers of a case as `standfast-probability` takes them: laws, and the modes as intervals along one of them.

use std::cell::RefCell;
use std::sync::atomic::{AtomicU64, Ordering};

use standfast::contact::Block;
use standfast::loads::Earthquake;
use standfast::wave::{Heights, STEEPEST, deep_water_wavelength};
use standfast::{Point, Situation, Wrench};
use standfast_probability::integrate::MOST_DIMENSIONS;
use standfast_probability::life::Life;
use standfast_probability::problem::RandomVector;
use standfast_probability::row::Row;
use standfast_probability::sample::draws;

use super::lines::{Line, Lines};
use super::mechanics::{Components, Mechanics, Quick};
use super::outcome;
use super::quantity::{Bias, FrictionOf, Quantity, RandomInput};
use super::resolve::{LEVELS, Names, Resolve, WATER_LEVEL, other_level};
use super::storm::{SlidingError, StormPart};
use crate::case::{Acting, Biases, Case, ChangeBy, Shaking, Trial, Waves};
use crate::couple::{Variable, vary};
use crate::digits::digits;
use crate::error::{CaseError, Fault, Problem};
use crate::inputs::Inputs;
use crate::key::{Id, Key, Table};
use standfast::ground::Base;
use standfast_inputs::random::{Lifetime, Random, Rate, ReadResult};
use standfast_model::CaseFile;

/// A case, its random numbers, and the loads that act.
#[derive(Debug, Clone)]
pub struct ChanceProblem {
    id: u64,
    model: Model,
    random: Vec<RandomInput>,
    laws: RandomVector,
    lifetime: Lifetime,
    /// The reliability index for which design values are asked.
    pub(super) target_beta: Option<f64>,
    /// True if it is asked what means and deviations of the laws do.
    pub(super) sensitivities: bool,
    lines: Lines,
    /// The water level, where the case has one.
    level: Option<Variable>,
    /// Of each number a value that it has as good as never more than.
    reaches: Vec<f64>,
    /// Number of problems of the same case, itself among them.
    count: usize,
    pub(super) line: Line,
}

/// Model that the numbers are of.
#[derive(Debug, Clone)]
enum Model {
    /// A case, the loads of it that act, and how the base is shaken.
    Case {
        inputs: Box<Inputs>,
        case: Box<Case>,
        acting: Acting,
        /// By what its acceleration of the base is multiplied; none where no earthquake acts.
        shaking: Option<Shaking>,
        /// Shortcut where of the case's numbers wave heights alone are random.
        quick: Option<Box<Quick>>,
    },
    /// A point of the report's plane: γ, k', k, μ.
    Point([f64; 4]),
}

/// Of each number the value beyond which no method looks, twelve deviations from the median.
fn reaches(laws: &RandomVector) -> Vec<f64> {
    const FAR: f64 = 12.0;
    let count = laws.laws().len();
    let mut reaches: Vec<f64> = laws.laws().iter().map(|law| law.value(FAR)).collect();
    if !laws.has_given() {
        return reaches;
    }
    // A law that depends on others reaches farther for other values of theirs: of any one, or at the ends of all.
    let is_parent: Vec<usize> = (0..count).filter(|place| laws.is_parent(*place)).collect();
    let mut tried: Vec<Vec<f64>> = Vec::new();
    for place in &is_parent {
        tried.extend((-24..=24).map(|step| {
            let mut z = vec![0.0; count];
            z[*place] = 0.5 * f64::from(step);
            z
        }));
    }
    for signs in 0..1u32 << is_parent.len().min(6) {
        let mut z = vec![0.0; count];
        for (bit, place) in is_parent.iter().enumerate().take(6) {
            z[*place] = if signs >> bit & 1 == 1 { FAR } else { -FAR };
        }
        tried.push(z);
    }
    for z in tried {
        let values = laws.values_of(&z);
        for (place, reach) in reaches.iter_mut().enumerate() {
            if !laws.parents(place).is_empty() {
                *reach = reach.max(laws.law_at(place, &values).value(FAR));
            }
        }
    }
    reaches
}

/// An |α| below which a number hardly matters.
const NEGLIGIBLE: f64 = 0.02;

/// Refuses more joints than there are outcomes for, and adhesion on ground that fails, which no closed form has together.
fn is_answerable(case: &Case) -> Result<(), Fault> {
    let joints = case.joints.len();
    if joints >= outcome::MOST_JOINTS {
        let most = outcome::MOST_JOINTS - 1;
        return Err(Fault::new(Problem::JointsOfChance { joints, most }, Table::Joint));
    }
    match case.adhesion.filter(|_| case.gives_way()) {
        Some(_) => {
            let what = "the probability of a body on ground that fails";
            Err(Fault::new(Problem::HoldsNot { holds: "`adhesion`".to_owned(), what }, Key::Adhesion))
        }
        None => Ok(()),
    }
}

/// Refuses a combination whose numbers are not those of the case, where they are random; partial factors stand for chance.
fn by_chance(case: &Case, acting: Acting, random: &[RandomInput]) -> Result<(), Fault> {
    let Acting::Combination(index) = acting else { return Ok(()) };
    if let Some(at) = case.pairs_in(acting) {
        return Err(Fault::new(Problem::Pairs { of: "a probability" }, at));
    }
    let combination = &case.combinations[index];
    for change in &combination.changes {
        let at = Id::new(change.by.key(), index);
        if matches!(change.by, ChangeBy::Material(_) | ChangeBy::Resistance(_)) {
            return Err(Fault::new(Problem::PartialFactor { name: change.name.clone() }, at));
        }
        let is_of = |variable: &Variable| variable.id() == change.id;
        if random.iter().any(|input| input.variable().or(input.rise_of()).is_some_and(is_of)) {
            return Err(Fault::new(Problem::SetAndRandom { name: change.name.clone() }, at));
        }
    }
    if let Some((name, _)) = combination.holds.first() {
        let problem = Problem::PartialFactor { name: name.clone() };
        return Err(Fault::new(problem, Id::new(Key::CombinationResist, index)));
    }
    if combination.bearing != 1.0 {
        let problem = Problem::PartialFactor { name: "bearing".to_owned() };
        return Err(Fault::new(problem, Id::new(Key::CombinationResist, index)));
    }
    Ok(())
}

impl ChanceProblem {
    /// The problems of a case file, which is of this case, with a `[random]` table: one for each set of loads that act together and each acceleration of
    /// the base that is tried. `moving` are the inputs in time of a case whose motion is followed, some of whose numbers may be random.
    ///
    /// # Errors
    /// If the values of the case do not go together, or a name, a law or a correlation is wrong.
    pub fn of(
        file: &CaseFile,
        case: Case,
        random: &Random,
        years: Option<f64>,
        moving: Option<&Inputs>,
    ) -> Result<Vec<ChanceProblem>, CaseError> {
        let wrong = |(problem, span)| file.random_error(problem, span);
        let random = &Random { lifetime: random.lifetime.with_years(years), ..random.clone() };
        let (inputs, laws) = Resolve(Names::Case(file, &case, moving)).all(random).map_err(wrong)?;
        is_answerable(&case).map_err(|fault| file.error(fault))?;
        if let Some(plan) = case.plan.as_ref().filter(|_| inputs.iter().any(RandomInput::is_bias)) {
            return Err(file.error(plan.not_for("a bias that is random")));
        }
        let lines = Lines::of(&inputs, Some(&case));
        let line = lines.first(&inputs, &laws, |_| true).unwrap_or(Line::Scan(0));
        let level = Variable::find(WATER_LEVEL, file.inputs()).ok();
        let mut unnamed = file.inputs().clone();
        [Key::Title, Key::Note].into_iter().for_each(|key| unnamed.remove(key.into()));
        let is_random = |key| inputs.iter().any(|input| input.is_key(key));
        let moved = [Key::Horizontal, Key::Vertical, Key::HorizontalZ].map(is_random);
        let mut problems = Vec::new();
        for acting in case.acting() {
            by_chance(&case, acting, &inputs).map_err(|fault| file.error(fault))?;
            let shakings = case.under(acting).shakings_if(acting, moved);
            let each: Vec<Option<Shaking>> =
                if shakings.is_empty() { vec![None] } else { shakings.into_iter().map(Some).collect() };
            for shaking in each {
                let trial = Trial::shaken(shaking);
                let (inputs_of_case, case) = (Box::new(unnamed.clone()), Box::new(case.clone()));
                let quick = (case.joints.is_empty() && only_heights(&inputs))
                    .then(|| Quick::of(&case, acting, trial))
                    .flatten();
                let quick = quick.map(Box::new);
                problems.push(ChanceProblem {
                    id: unique(),
                    model: Model::Case { inputs: inputs_of_case, case, acting, shaking, quick },
                    random: inputs.clone(),
                    laws: laws.clone(),
                    lifetime: random.lifetime,
                    target_beta: random.target_beta,
                    sensitivities: random.sensitivities,
                    lines,
                    level: level.clone(),
                    reaches: reaches(&laws),
                    count: 1,
                    line,
                });
            }
        }
        let count = problems.len();
        problems.iter_mut().for_each(|problem| problem.count = count);
        Ok(problems)
    }

    /// The problem of a point of the report's plane with random numbers.
    ///
    /// # Errors
    /// If a name, a law or a correlation is wrong.
    pub(super) fn of_point(
        point: [f64; 4],
        random: &Random,
        years: Option<f64>,
    ) -> ReadResult<ChanceProblem> {
        let (inputs, laws) = Resolve(Names::Point(point)).all(random)?;
        let lines = Lines::of(&inputs, None);
        let line = lines.first(&inputs, &laws, |_| true).unwrap_or(Line::Scan(0));
        let lifetime = random.lifetime.with_years(years);
        let model = Model::Point(point);
        let reaches = reaches(&laws);
        Ok(ChanceProblem {
            id: unique(),
            model,
            random: inputs,
            laws,
            lifetime,
            target_beta: random.target_beta,
            sensitivities: random.sensitivities,
            lines,
            level: None,
            reaches,
            count: 1,
            line,
        })
    }

    /// Random numbers, in the order of the file.
    pub fn random(&self) -> &[RandomInput] {
        &self.random
    }

    /// The case, if it is one, and the loads of it that act.
    pub(super) fn case(&self) -> Option<(&Case, Acting)> {
        match &self.model {
            Model::Case { case, acting, .. } => Some((case, *acting)),
            Model::Point(_) => None,
        }
    }

    /// The laws of the random numbers and how they are correlated.
    pub fn laws(&self) -> &RandomVector {
        &self.laws
    }

    /// Loads that act, and the shaking of the base, in words; none where the case leaves no choice.
    pub fn situation(&self) -> Option<String> {
        let Model::Case { case, acting, shaking, .. } = &self.model else { return None };
        let name = case.acting_name(*acting);
        let is_random = |key| self.random.iter().any(|input| input.is_key(key));
        let [sideways, upwards] = [Key::Horizontal, Key::Vertical].map(is_random);
        // Of a case that is not shaken itself, the sign tells.
        let towards = |value: f64, sign: f64| if value == 0.0 { sign } else { value };
        let turned = |(earthquake, shaking): (Earthquake, Shaking)| {
            let [side, way, _] = shaking.signs.map(f64::from);
            let is_turned = case.plan.as_ref().is_some_and(|plan| plan.is_one_direction);
            let is_drawn = sideways || is_turned && is_random(Key::EarthquakeDirection);
            if is_drawn || upwards {
                let way = match towards(earthquake.vertical(), way) {
                    _ if earthquake.vertical() == 0.0 && !upwards => "",
                    down if down < 0.0 => " and downwards",
                    _ => " and upwards",
                };
                // The side that a direction has in the case would mislead.
                if is_turned {
                    let side = if side < 0.0 { "against" } else { "in" };
                    return format!("body pushed {side} the direction given{way}");
                }
                let side = if towards(earthquake.horizontal(), side) < 0.0 { "left" } else { "right" };
                return format!("base shaken to the {side}{way}");
            }
            let part = |value: f64, [below, above]: [&str; 2]| {
                let way = if value < 0.0 { below } else { above };
                (value != 0.0).then(|| format!("{} m/s² {way}", digits(value.abs())))
            };
            let parts = [
                part(earthquake.horizontal(), ["to the left", "to the right"]),
                part(earthquake.vertical(), ["downwards", "upwards"]),
                part(earthquake.away(), ["towards the viewer", "away from the viewer"]),
            ];
            format!("base acceleration {}", parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
        };
        let earthquake = shaking.and_then(|shaking| Some((case.shaken(shaking)?, shaking)));
        match (name, earthquake.map(turned)) {
            (Some(name), Some(shaken)) => Some(format!("{name}, {shaken}")),
            (name, shaken) => name.or(shaken),
        }
    }

    /// The years of the life that is asked for, where one is.
    pub fn years(&self) -> Option<f64> {
        self.lifetime.years
    }

    /// The life that is asked for, as it is written.
    pub fn lifetime(&self) -> Lifetime {
        self.lifetime
    }

    /// The life that is asked for, where one is.
    pub(super) fn life(&self) -> Option<Life> {
        let yearly = self.random.iter().map(|input| input.every != Rate::Life).collect();
        let clock = self.random.iter().position(|input| input.rise_of().is_some());
        self.lifetime.years.map(|years| Life { years, yearly, events: self.lifetime.events_per_year, clock })
    }

    /// The row that the body is one of, where there is one.
    pub(super) fn row(&self) -> Option<Row> {
        let own = self.random.iter().map(|input| input.own).collect();
        self.lifetime.bodies.map(|bodies| Row { bodies, own })
    }

    /// Problem along a number that is drawn yearly, as a life needs it; none if there is no such number.
    pub(super) fn along_yearly(&self) -> Option<ChanceProblem> {
        self.along_one(|input| input.every != Rate::Life)
    }

    /// Problem along a number that each body of a row has of its own; none if there is no such number.
    pub(super) fn along_own(&self) -> Option<ChanceProblem> {
        self.along_one(|input| input.own)
    }

    fn along_one(&self, among: impl Fn(&RandomInput) -> bool) -> Option<ChanceProblem> {
        let line = self.lines.first(&self.random, &self.laws, |place| among(&self.random[place]))?;
        Some(ChanceProblem { line, ..self.clone() })
    }

    /// Problem along the number that matters more, by the nearest point at which the body does not rest (α of each number): where friction
    /// hardly matters, or is certain, that number of those in which the wrench is linear that has the largest |α|. None if it is the number
    /// already.
    pub(super) fn along_what_matters(&self, alpha: &[f64]) -> Option<ChanceProblem> {
        let own = match self.line {
            Line::Friction(place) | Line::Load(place) if alpha[place].abs() < NEGLIGIBLE => {
                alpha[place].abs()
            }
            Line::Friction(_) | Line::Scan(_) => return None,
            Line::Load(place) => alpha[place].abs(),
        };
        if !self.lines.loads {
            return None;
        }
        let may_be = |place: &usize| self.random[*place].is_linear() && !self.laws.is_parent(*place);
        let linear = (0..self.random.len()).filter(may_be);
        let best = linear.max_by(|a, b| alpha[*a].abs().total_cmp(&alpha[*b].abs()).then(b.cmp(a)))?;
        let line = Line::Load(best);
        (line != self.line && alpha[best].abs() > own).then(|| ChanceProblem {
            line,
            id: unique(),
            ..self.clone()
        })
    }

    /// True if a number is friction that is put in beside what everything else makes: not where friction to slip has a law of its own.
    pub(super) fn is_apart(&self, place: usize) -> bool {
        self.lines.friction && self.friction_of(place).is_some()
    }

    /// The joint whose friction a number is, from the base, which is zero; `None` of any other number.
    pub(super) fn friction_of(&self, place: usize) -> Option<usize> {
        match self.random[place].friction_of()? {
            FrictionOf::Base => Some(0),
            FrictionOf::Joint(index) => {
                let (case, _) = self.case()?;
                Some(1 + case.joints.iter().position(|joint| joint.index == index)?)
            }
        }
    }

    /// True if the body stands on joints of its own, of which it is answered which leaves rest first.
    pub fn has_joints(&self) -> bool {
        self.joints() > 0
    }

    /// True if its base is seen from above: it is answered whether the body rests, and what ends rest, not in which mode it then moves.
    pub fn is_on_plan(&self) -> bool {
        self.case().is_some_and(|(case, _)| case.plan.is_some())
    }

    /// True if what happens is told without modes of the report's plane.
    pub fn is_without_modes(&self) -> bool {
        self.has_joints() || self.is_on_plan()
    }

    /// True if the base may crush, or the ground fail: modes on it are not those of the report's plane.
    pub fn gives_way(&self) -> bool {
        self.case().is_some_and(|(case, _)| case.gives_way())
    }

    /// Number of joints, the base among them; none of one body.
    fn joints(&self) -> usize {
        match self.case().map_or(0, |(case, _)| case.joints.len()) {
            0 => 0,
            above => above + 1,
        }
    }

    /// Number of outcomes.
    pub(super) fn outcomes(&self) -> usize {
        outcome::count(self.joints())
    }

    /// The outcomes that exclude each other and add up to one.
    pub(super) fn exclusive(&self) -> impl Iterator<Item = usize> + use<> {
        let (joints, on_plan) = (self.joints(), self.is_on_plan());
        let of_joints = (joints > 0).then(|| outcome::of_joints(joints, self.gives_way()));
        let of_plan = on_plan.then(outcome::on_plan);
        let of_one = (joints == 0 && !on_plan).then(|| outcome::exclusive(self.gives_way()));
        of_joints
            .into_iter()
            .flatten()
            .chain(of_plan.into_iter().flatten())
            .chain(of_one.into_iter().flatten())
    }

    /// Those of them that are not rest.
    pub(super) fn moving(&self) -> impl Iterator<Item = usize> + use<> {
        self.exclusive().filter(|outcome| *outcome != outcome::REST)
    }

    /// A value that a number has as good as never more than.
    pub(super) fn reach(&self, place: usize) -> f64 {
        self.reaches[place]
    }

    /// True if the number along which modes are known has to be scanned.
    pub(super) fn is_scanned(&self) -> bool {
        matches!(self.line, Line::Scan(_))
    }

    /// The most random numbers over which is integrated unless it is asked for: over directions boundaries have a kink at every corner of the
    /// base, at each of which an integral is refined, and of several sets of loads each has its own.
    pub(super) fn most_integrated(&self) -> usize {
        if self.is_on_plan() || self.count > 1 { MOST_DIMENSIONS } else { MOST_DIMENSIONS + 1 }
    }

    /// What the modes along its line cost, in decisions, in powers of ten or so.
    pub(super) fn cost(&self) -> u64 {
        if self.is_scanned() { 64 } else { 1 }
    }

    /// Name of the number that is integrated, and true if in closed form, as friction and loads are.
    pub(super) fn line_name(&self) -> (&str, bool) {
        let (place, exact) = match self.line {
            Line::Friction(place) | Line::Load(place) => (place, true),
            Line::Scan(place) => (place, false),
        };
        (&self.random[place].name, exact)
    }

    /// The contact problem with these values, one for each random number; none if they do not go together.
    pub(super) fn mechanics(&self, values: &[f64]) -> Option<Mechanics> {
        if self.is_of_plane() {
            return self.at_point(values);
        }
        Some(self.mechanics_of(&self.components(values)?, values))
    }

    /// The contact problem of components, with these values of the numbers that are put in beside them.
    pub(super) fn mechanics_of(&self, components: &Components, values: &[f64]) -> Mechanics {
        let mut mechanics = components.mechanics(&|bias| self.bias(bias, values));
        for place in (0..self.random.len()).filter(|place| self.is_apart(*place)) {
            let block = match self.friction_of(place) {
                None => continue,
                Some(0) => &mut mechanics.block,
                Some(joint) => &mut mechanics.above[joint - 1].block,
            };
            let ratio = if block.mu_s > 0.0 { block.mu_k / block.mu_s } else { 1.0 };
            (block.mu_s, block.mu_k) = (values[place], values[place] * ratio);
        }
        mechanics
    }

    /// Mechanics on the way to the full load: of the report's force, at any size, only the elevation counts.
    pub(super) fn departing(&self, values: &[f64]) -> Option<Mechanics> {
        let mut mechanics = self.mechanics(values)?;
        if let Some(point) = self.point_with(values).filter(|point| point.k() > 0.0) {
            mechanics.variable = Wrench { x: -1.0, p: 0.0, m: point.k_prime() * point.gamma() };
        }
        Some(mechanics)
    }

    /// A number that no other problem has.
    pub(super) fn id(&self) -> u64 {
        self.id
    }

    pub(super) fn bias(&self, bias: Bias, values: &[f64]) -> Option<f64> {
        let place = self.random.iter().position(|input| input.quantity == Quantity::Bias(bias));
        place.map(|place| values[place])
    }

    /// Components of the loads, unbiased, with these values of all numbers but friction; those of the last two calls if they are the same.
    pub(super) fn components(&self, values: &[f64]) -> Option<Components> {
        let slow = |place: &usize| {
            let input = &self.random[*place];
            input.is_beside_keys() || input.variable().is_some() && !self.is_apart(*place)
        };
        let keys: Vec<f64> = (0..self.random.len()).filter(slow).map(|place| values[place]).collect();
        let is_of = |(id, of, _): &Assembled| *id == self.id && *of == keys;
        let known = LAST.with_borrow(|last| {
            let found = last.iter().flatten().find(|assembled| is_of(assembled));
            found.map(|(.., components)| components.clone())
        });
        known.unwrap_or_else(|| {
            let components = self.assembled(values);
            LAST.with_borrow_mut(|last| {
                last.swap(0, 1);
                last[0] = Some((self.id, keys, components.clone()));
            });
            components
        })
    }

    fn assembled(&self, values: &[f64]) -> Option<Components> {
        let Model::Case { quick, .. } = &self.model else { return None };
        if let Some(quick) = quick {
            return quick.components(self.heights(values)?, &self.biases_of_case(values));
        }
        self.components_of(&self.case_with(values)?)
    }

    /// Components of the loads on a case that was made with values of the numbers.
    pub(super) fn components_of(&self, case: &Case) -> Option<Components> {
        let Model::Case { acting, shaking, .. } = &self.model else { return None };
        let trial = Trial::shaken(*shaking);
        let situation = case.situation(*acting, trial).ok()?;
        let of = case.under(*acting);
        let formulas = of.wave.as_ref().map_or(0, Waves::branches);
        let whole = Components::of(&situation, of.ground.as_ref(), formulas).ok()?;
        let above = (0..of.joints.len()).map(|place| {
            let situation = case.above_joint(place, *acting, trial).ok()?;
            Components::of(&situation, None, formulas).ok()
        });
        Some(Components { above: above.collect::<Option<_>>()?, ..whole })
    }

    /// The body with its loads with these values of all numbers; none if they do not go together.
    pub(super) fn situation_with(&self, values: &[f64]) -> Option<Situation> {
        let Model::Case { acting, shaking, .. } = &self.model else { return None };
        self.case_with(values)?.situation(*acting, Trial::shaken(*shaking)).ok()
    }

    /// The case with these values of all numbers but friction; none if they do not go together.
    pub(super) fn case_with(&self, values: &[f64]) -> Option<Case> {
        self.case_in(values, &StormPart::PEAK)
    }

    /// The case in a part of a storm, with these values of all numbers but friction; none if they do not go together.
    pub(super) fn case_in(&self, values: &[f64], part: &StormPart) -> Option<Case> {
        let Model::Case { inputs, case, quick, .. } = &self.model else { return None };
        if let Some(quick) = quick.as_ref().filter(|_| *part == StormPart::PEAK) {
            return quick.case(case, self.heights(values)?, &self.biases_of_case(values));
        }
        let mut named: Vec<(&Variable, f64)> = self
            .random
            .iter()
            .zip(values)
            .enumerate()
            // A friction of zero would leave no ratio of slip to stick.
            .filter(|(place, _)| !self.is_apart(*place))
            .filter_map(|(_, (input, value))| Some((input.variable()?, *value)))
            // At the first instant numbers of the motion have no part.
            .filter(|(variable, _)| {
                !variable.id().table.is_of_motion() || inputs.get(variable.id()).is_some()
            })
            .collect();
        let of_level = self.level.as_ref().map(|level| (level, part.rise)).filter(|(_, rise)| *rise != 0.0);
        let rises =
            self.random.iter().zip(values).filter_map(|(input, rise)| Some((input.rise_of()?, *rise)));
        for (level, rise) in rises.chain(of_level) {
            match named.iter_mut().find(|(variable, _)| *variable == level) {
                Some((_, drawn)) => *drawn += rise,
                None => named.push((level, level.value(inputs, case) + rise)),
            }
        }
        let mut biases = self.biases_of_case(values);
        if part.height != 1.0 {
            let Model::Case { acting, .. } = &self.model else { return None };
            let is_deep = matches!(case.under(*acting).goda()?.heights, Heights::DeepWater(_));
            let bias = if is_deep { Bias::DeepWaterHeight } else { Bias::Height };
            biases.set(bias, part.height * biases.get(bias).unwrap_or(1.0));
        }
        let case = Case::of(&vary(inputs, case, &named)).ok()?.biased(biases).ok()?;
        match case.goda().filter(|waves| waves.share_of_steepest().is_some_and(|share| share > 1.0)) {
            Some(waves) => Some(case.with_goda(waves.clone().broken()?)),
            None => Some(case),
        }
    }

    /// The share of all draws in which the sea is steeper than waves in deep water can be.
    pub(super) fn share_of_steep_seas(&self) -> f64 {
        /// So many draws tell a share that is worth a word.
        const DRAWS: u64 = 1 << 14;
        let Some((case, _)) = self.case() else { return 0.0 };
        let Some(waves) = case.goda() else { return 0.0 };
        let place = |key: Key| self.random.iter().position(|input| input.is_key(key));
        let of_bias = Quantity::Bias(Bias::DeepWaterHeight);
        let bias = self.random.iter().position(|input| input.quantity == of_bias);
        let [height, period] = [Key::DeepWaterHeight, Key::Period].map(place);
        // A steepness that is given is none that waves can't have.
        let is_drawn = waves.steepness.is_none() && height.or(period).or(bias).is_some();
        let (Heights::DeepWater(own), true) = (waves.heights, is_drawn) else {
            return 0.0;
        };
        let mut steep = 0u64;
        draws(&self.laws, 1, DRAWS, |values| {
            let value = |place: Option<usize>, own: f64| place.map_or(own, |place| values[place]);
            let height = value(height, own) * value(bias, 1.0);
            let steepest = STEEPEST * deep_water_wavelength(value(period, waves.sea.period), case.gravity);
            steep += u64::from(height > steepest);
        });
        steep as f64 / DRAWS as f64
    }

    /// The biases among these values that change the case itself.
    fn biases_of_case(&self, values: &[f64]) -> Biases {
        let mut biases = Biases::default();
        for (input, value) in self.random.iter().zip(values) {
            match input.quantity {
                Quantity::Bias(bias) if bias.is_of_case() => biases.set(bias, *value),
                _ => {}
            }
        }
        biases
    }

    /// The wave heights of the case, with these values of those that are random.
    fn heights(&self, values: &[f64]) -> Option<Heights> {
        let Model::Case { case, .. } = &self.model else { return None };
        let mut heights = case.goda()?.heights;
        for (input, value) in self.random.iter().zip(values) {
            let key = input.variable().map(|variable| variable.id().key);
            match (&mut heights, key) {
                (Heights::DeepWater(height), Some(Key::DeepWaterHeight)) => *height = *value,
                (Heights::Local { significant, .. }, Some(Key::H13)) => *significant = *value,
                (Heights::Local { maximum, .. }, Some(Key::Hmax)) => *maximum = *value,
                _ => {}
            }
        }
        Some(heights)
    }

    /// The point of the report's plane with these values; `None` of a case, or where they make no point.
    pub(super) fn point_with(&self, values: &[f64]) -> Option<Point> {
        let Model::Point(mut point) = self.model else { return None };
        for (input, value) in self.random.iter().zip(values) {
            if let Quantity::Point(coordinate) = input.quantity {
                point[coordinate as usize] = *value;
            }
        }
        let [gamma, k_prime, k, mu] = point;
        Point::new(gamma, k_prime, k, mu).ok()
    }

    /// The report's problem with these values: X = −k, M = k k' γ.
    fn at_point(&self, values: &[f64]) -> Option<Mechanics> {
        let point = self.point_with(values)?;
        let (gamma, k) = (point.gamma(), point.k());
        let permanent = Wrench { x: 0.0, p: 1.0, m: 0.0 };
        let variable = Wrench { x: -k, p: 0.0, m: k * point.k_prime() * gamma };
        let block = Block::uniform(gamma, point.mu());
        Some(Mechanics { block, base: Base::Rigid, permanent, variable, formulas: 0, above: Vec::new() })
    }

    /// Refuses parts of a storm with other levels where the case has none, or a combination sets it.
    pub(super) fn can_rise(&self) -> Result<(), SlidingError> {
        let (Some(level), Some((case, acting))) = (&self.level, self.case()) else {
            return Err(SlidingError::NoLevel);
        };
        if let Some(other) = other_level(&self.random, level) {
            return Err(SlidingError::OtherLevel { name: other.name.clone() });
        }
        let Acting::Combination(index) = acting else { return Ok(()) };
        match case.combinations[index].changes.iter().find(|change| LEVELS.contains(&change.id.key)) {
            Some(change) => Err(SlidingError::SetLevel { name: change.name.clone() }),
            None => Ok(()),
        }
    }

    /// True if this is a point of the report's plane.
    pub(super) fn is_of_plane(&self) -> bool {
        matches!(self.model, Model::Point(_))
    }
}

/// A problem's number, the values, and what was assembled; none if they do not go together.
type Assembled = (u64, Vec<f64>, Option<Components>);

thread_local! {
    /// Last assemblies, the latest first: two, as along a load the components are taken where it is zero and where it is one.
    static LAST: RefCell<[Option<Assembled>; 2]> = const { RefCell::new([None, None]) };
}

/// A number that no other problem has.
fn unique() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(0);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

/// True if of a case's numbers, beside friction, only heights of waves are random.
fn only_heights(inputs: &[RandomInput]) -> bool {
    let heights = [Key::DeepWaterHeight, Key::H13, Key::Hmax];
    let is_other =
        |input: &RandomInput| input.quantity == Quantity::Bias(Bias::Bearing) || input.rise_of().is_some();
    if inputs.iter().any(is_other) {
        return false;
    }
    let of_case =
        inputs.iter().filter(|input| input.friction_of().is_none()).filter_map(RandomInput::variable);
    of_case.into_iter().all(|variable| heights.contains(&variable.id().key))
}
