//! The answer as one JSON document, schema 1, at full precision: `docs/answer.schema.json`.
//!
//! Units are SI throughout. Results stand under the names of the [one list](crate::results). `null` says that there is no such
//! thing; a number without bound is the word `infinite`.

use std::borrow::Cow;

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use standfast::ground::impact::EventFound;
use standfast::loads::{self, LoadKind, LoadSource};
use standfast::{Mode, Modes, Motion, Plan, Stage, Verdict, Wrench, section};

use super::holding::{AdhesionEntry, ResistanceEntry};
use super::joints::JointEntries;
use super::made::{MadeLoad, made_loads};
use super::opening::BaseOpeningEntry;
use super::plan::{DirectionEntry, PlanEntry};
use super::{AnyCheck, Assessed, Assessment, AssessmentView, CaseCheck, combination};
use crate::case::{Acting, Case, ChangeBy, Code, Direction, GodaWaves, PointForce};
use crate::json::{CheckEntry, SCHEMA, number_or_word, written};
use crate::key::Key;
use crate::point::{PointDocument, RelationDocument};
use crate::results::{self, ResultName, ResultValue, SeaResult};
use crate::summary::Summary;
use crate::units::Extent;
use standfast_inputs::inputs::LoadFactor;

#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    title: Option<&'a str>,
    note: Option<&'a str>,
    gravity: f64,
    /// Extent of forces, masses and moments: `per-metre` or `whole`.
    extent: &'static str,
    body: Body<'a>,
    weight_counted_as: &'static str,
    water: Option<Water>,
    wave: Option<Wave<'a>>,
    /// What is asked first, in sentences.
    summary: Summary,
    warnings: Vec<Warning>,
    /// True if all criteria are met; null where there is none.
    met: Option<bool>,
    /// Each criterion in the situation that meets it worst, the governing one first.
    criteria: Vec<Criterion<'a>>,
    /// Of a case in time, what is answered of its first instant.
    in_time: Option<&'a str>,
    /// The place of the worst situation.
    governing: usize,
    situations: Vec<Situation<'a>>,
    figures: &'a [String],
}

#[derive(Serialize)]
struct Body<'a> {
    shape: &'static str,
    width: f64,
    height: f64,
    /// Out of the plane; null of a body per metre run, and of a cylinder.
    length: Option<f64>,
    mass: f64,
    weight: f64,
    slenderness: f64,
    #[serde(skip_serializing_if = "is_level")]
    floor_deg: f64,
    friction: f64,
    kinetic_friction: f64,
    added_mass: f64,
    centroid_height: f64,
    heel_distance: f64,
    toe_distance: f64,
    moment_of_inertia: f64,
    /// Empty where the body is of one piece.
    parts: Vec<Part<'a>>,
}

#[derive(Serialize)]
struct Part<'a> {
    name: Option<&'a str>,
    density: f64,
    density_below_water: f64,
    /// Its corners, counter-clockwise: to the right of the origin of the section, and above the base.
    outline: Vec<[f64; 2]>,
}

#[derive(Serialize)]
struct Water {
    left: f64,
    right: f64,
    density: f64,
}

#[derive(Serialize)]
struct Warning {
    name: &'static str,
    message: String,
}

/// Waves by Goda's formulas: their results, and the choices in the formulas behind the angle.
struct Wave<'a>(&'a GodaWaves);

#[derive(Serialize)]
struct Situation<'a> {
    /// The force that acts alone.
    load: Option<Force<'a>>,
    /// The combination whose loads act.
    combination: Option<Combination<'a>>,
    /// The acceleration of the base.
    earthquake: Option<Earthquake>,
    /// The other accelerations that were tried, none of them worse.
    other_earthquakes: Vec<OtherEarthquake>,
    /// The governing criterion first.
    criteria: Vec<Criterion<'a>>,
    #[serde(flatten)]
    results: Results<'a>,
    /// Response of the base; null of a rigid one.
    ground: Option<Ground<'a>>,
    mode_words: Option<&'static str>,
    because: Vec<RelationDocument>,
    /// Of the mode reported: m/s², rad/s², N and m per metre run; relative to the base.
    motion: Option<Motion>,
    wrench: Wrench,
    components: Vec<Component>,
    /// Water under a base that opens.
    #[serde(skip_serializing_if = "Option::is_none")]
    base_opening: Option<BaseOpeningEntry>,
    /// What the base adheres with, where it does.
    #[serde(skip_serializing_if = "Option::is_none")]
    adhesion: Option<AdhesionEntry>,
    /// Forces with a limit, where there are some.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    resistances: Vec<ResistanceEntry>,
    /// Loads that the program makes and that act.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    made_loads: Vec<MadeLoad>,
    path: Vec<PathStage>,
    /// Of a base seen from above.
    #[serde(skip_serializing_if = "Option::is_none")]
    plan: Option<PlanEntry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    directions: Option<Vec<DirectionEntry>>,
    /// Of bodies on joints.
    #[serde(flatten)]
    joints: Option<JointEntries<'a>>,
    report: Option<Report>,
    /// Reason why there is no report.
    no_report: Option<&'static str>,
}

/// The point of the report's diagram.
#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    point: PointDocument,
    /// 1/(k_eff γ |1+k'_eff|), which counts uplift and eccentric weight as a load; the classical factor counts them as less
    /// resistance.
    #[serde(rename = "SF_overturning_effective", serialize_with = "number_or_word")]
    overturning: f64,
}

/// The results of the one list.
struct Results<'a> {
    of: &'a Assessed,
    /// Criteria of the case, which some results are told for alone.
    criteria: &'a [crate::Criterion],
}

impl Serialize for Results<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let is_apart = |result: &ResultName| result.is_of_ground() || result.is_of_plan();
        let told = |result: &&ResultName| !is_apart(result) && result.is_told(self.criteria);
        let mut map = serializer.serialize_map(None)?;
        for result in ResultName::ALL.iter().filter(told) {
            map.serialize_entry(result.name(), &result.of(self.of))?;
        }
        map.end()
    }
}

/// The results of the ground, under their names there, and the events of loads in time.
struct Ground<'a>(&'a Assessed);

#[derive(Serialize)]
struct Event {
    event: &'static str,
    time: Option<f64>,
    #[serde(serialize_with = "number_or_word")]
    load_factor: f64,
}

impl Serialize for Ground<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        let elastic = self.0.ground.as_ref().and_then(|ground| ground.elastic.as_ref());
        let periods = elastic.and_then(|elastic| elastic.periods).map(|[one, two, _]| [one, two]);
        for result in ResultName::ALL {
            match result.in_ground() {
                Some("periods") if *result == ResultName::Period1 => {
                    map.serialize_entry("periods", &periods)?
                }
                Some("periods") | None => {}
                Some(name) => map.serialize_entry(name, &result.of(self.0))?,
            }
        }
        let events = elastic.and_then(|elastic| elastic.impact.as_ref()).map(|impact| &impact.events[..]);
        let event = |found: &EventFound| Event {
            event: results::event(found.event),
            time: found.time,
            load_factor: found.load_factor,
        };
        let events: Vec<_> = events.unwrap_or_default().iter().map(event).collect();
        map.serialize_entry("events", &events)?;
        map.end()
    }
}

#[derive(Serialize)]
struct Force<'a> {
    name: Option<&'a str>,
    /// Null of a couple.
    force: Option<f64>,
    /// Of a couple.
    #[serde(skip_serializing_if = "Option::is_none")]
    moment: Option<f64>,
    elevation: Option<f64>,
    /// To the right of O; null at mid-width.
    distance: Option<f64>,
    /// Null of one that has an angle.
    direction: Option<&'static str>,
    /// Seen from above.
    #[serde(skip_serializing_if = "Option::is_none")]
    direction_deg: Option<f64>,
    /// What it stands on.
    #[serde(skip_serializing_if = "Option::is_none")]
    lever: Option<&'a str>,
}

#[derive(Serialize)]
struct Combination<'a> {
    name: Option<&'a str>,
    factors: Named<'a>,
    /// The code that filled in what it does not write.
    #[serde(skip_serializing_if = "Option::is_none")]
    code: Option<&'a str>,
    /// True if factors act on effects.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    effects: bool,
    #[serde(skip_serializing_if = "Named::is_empty")]
    set: Named<'a>,
    #[serde(skip_serializing_if = "Named::is_empty")]
    scale: Named<'a>,
    #[serde(skip_serializing_if = "Named::is_empty")]
    materials: Named<'a>,
    #[serde(skip_serializing_if = "Named::is_empty")]
    resist: Named<'a>,
    /// Numbers of the case that are others in it, as they are there.
    #[serde(skip_serializing_if = "Named::is_empty")]
    numbers: Named<'a>,
    /// The waves, where they are others in it.
    #[serde(skip_serializing_if = "Option::is_none")]
    wave: Option<Wave<'a>>,
    /// The factors of pairs that are the worst.
    #[serde(skip_serializing_if = "Named::is_empty")]
    factors_used: Named<'a>,
    /// The other factors of pairs that were tried, none of them worse.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    tried: Vec<Tried<'a>>,
}

/// What stands under names, in the order of the alphabet.
struct Named<'a>(Vec<(Cow<'a, str>, NamedValue<'a>)>);

/// A number, the two factors of a pair, or words.
enum NamedValue<'a> {
    Number(f64),
    Pair([f64; 2]),
    Words(&'a str),
}

impl<'a> Named<'a> {
    fn of(mut named: Vec<(Cow<'a, str>, NamedValue<'a>)>) -> Named<'a> {
        named.sort_by(|(one, _), (two, _)| one.cmp(two));
        Named(named)
    }

    fn numbers(named: Vec<(&'a str, f64)>) -> Named<'a> {
        let named = named.into_iter().map(|(name, number)| (Cow::Borrowed(name), NamedValue::Number(number)));
        Named::of(named.collect())
    }

    fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl Serialize for Named<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, value) in &self.0 {
            match value {
                NamedValue::Number(number) => map.serialize_entry(name, number)?,
                NamedValue::Pair(both) => map.serialize_entry(name, both)?,
                NamedValue::Words(words) => map.serialize_entry(name, words)?,
            }
        }
        map.end()
    }
}

/// A way in which a situation was tried.
#[derive(Serialize)]
struct Tried<'a> {
    factors: Named<'a>,
    earthquake: Option<Earthquake>,
    #[serde(flatten)]
    answer: ShortAnswer,
}

/// m/s², to the right and upwards.
#[derive(Serialize)]
struct Earthquake {
    horizontal: f64,
    vertical: f64,
    /// Away from the viewer of the section, where it is not zero.
    #[serde(skip_serializing_if = "Option::is_none")]
    horizontal_z: Option<f64>,
}

#[derive(Serialize)]
struct OtherEarthquake {
    #[serde(flatten)]
    earthquake: Earthquake,
    #[serde(flatten)]
    answer: ShortAnswer,
}

/// What is told of a way that is not the one that is worst.
#[derive(Serialize)]
struct ShortAnswer {
    mode: ResultValue,
    departure: ResultValue,
    load_factor: ResultValue,
    departure_mode: ResultValue,
    #[serde(rename = "SF_sliding")]
    sliding: ResultValue,
    #[serde(rename = "SF_overturning_net")]
    overturning: ResultValue,
    #[serde(flatten)]
    joints: Option<ShortJoints>,
}

/// What is told of its joints.
#[derive(Serialize)]
struct ShortJoints {
    modes: Option<Vec<Mode>>,
    departure_joints: Vec<usize>,
    #[serde(rename = "SF_sliding_joints")]
    sliding: ResultValue,
    #[serde(rename = "SF_overturning_net_joints")]
    overturning: ResultValue,
}

impl ShortJoints {
    fn of(assessed: &Assessed) -> Option<ShortJoints> {
        let joints = assessed.joints.as_ref()?;
        Some(ShortJoints {
            modes: joints.modes().filter(|modes| !modes.is_empty()).map(<[Mode]>::to_vec),
            departure_joints: joints.leaves.joints().iter().map(|joint| joint + 1).collect(),
            sliding: results::least_of_joints(assessed, Assessed::least_sliding),
            overturning: results::least_of_joints(assessed, Assessed::least_overturning),
        })
    }
}

#[derive(Serialize)]
struct Criterion<'a> {
    #[serde(flatten)]
    check: CheckEntry,
    /// The place of the situation.
    situation: usize,
    /// The acceleration of the base that is worst for it.
    earthquake: Option<Earthquake>,
    /// The factors of pairs that are worst for it.
    #[serde(skip_serializing_if = "Named::is_empty")]
    factors_used: Named<'a>,
}

#[derive(Serialize)]
struct Component {
    name: String,
    source: LoadSource,
    counts_as: LoadKind,
    permanent: bool,
    /// The partial factor that the wrench is multiplied by.
    factor: f64,
    #[serde(flatten)]
    wrench: Wrench,
    /// Of a base seen from above.
    #[serde(skip_serializing_if = "Option::is_none")]
    z: Option<f64>,
}

#[derive(Serialize)]
struct PathStage {
    from: f64,
    to: f64,
    mode: Option<Verdict>,
    also: Modes,
}

pub(super) fn render(assessment: &Assessment, view: &AssessmentView, files: &[String]) -> String {
    let case = &assessment.case;
    let governing = assessment.governing();
    written(&Document {
        schema: SCHEMA,
        title: case.title.as_deref(),
        note: case.note.as_deref(),
        gravity: case.gravity,
        extent: case.extent.name(),
        body: Body::of(case),
        weight_counted_as: case.weight_words(),
        water: case.water.map(|water| Water {
            left: water.left(),
            right: water.right(),
            density: water.density(),
        }),
        wave: case.goda().map(Wave),
        summary: super::summary::summary(assessment),
        warnings: case
            .warnings()
            .iter()
            .map(|warning| Warning { name: warning.name(), message: warning.to_string() })
            .collect(),
        met: assessment.met(),
        criteria: assessment.all_checks().iter().map(|check| Criterion::of(assessment, check)).collect(),
        in_time: assessment.in_time.as_ref().map(|in_time| &*in_time.note),
        governing: governing.index,
        situations: assessment.all.iter().map(|assessed| Situation::of(assessment, assessed, view)).collect(),
        figures: files,
    })
}

/// True of a floor of which nothing is told.
#[allow(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
fn is_level(floor_deg: &f64) -> bool {
    *floor_deg == 0.0
}

impl Body<'_> {
    fn of(case: &Case) -> Body<'_> {
        let body = &case.body;
        let (shape, length) = match body.plan() {
            Plan::Rectangle { length } => ("block", Some(length).filter(|_| case.extent == Extent::Whole)),
            _ => ("cylinder", None),
        };
        Body {
            shape,
            length,
            width: body.width(),
            height: body.height(),
            mass: body.mass(),
            weight: body.mass() * case.gravity,
            slenderness: body.slenderness(),
            floor_deg: case.floor_deg,
            friction: case.friction,
            kinetic_friction: case.kinetic_friction,
            added_mass: case.added_mass.mass(),
            centroid_height: body.centroid_height(),
            heel_distance: body.heel_distance(),
            toe_distance: body.toe_distance(),
            moment_of_inertia: body.moment_of_inertia(),
            parts: case.parts().map(|(name, part)| Part::of(name, part)).collect(),
        }
    }
}

impl<'a> Part<'a> {
    fn of(name: Option<&'a str>, part: &section::Part) -> Part<'a> {
        Part {
            name,
            density: part.density(),
            density_below_water: part.density_below_water(),
            outline: part.outline().iter().map(|corner| [corner.x, corner.y]).collect(),
        }
    }
}

impl Serialize for Wave<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Wave(GodaWaves { choices, goda, .. }) = self;
        let mut map = serializer.serialize_map(None)?;
        for result in SeaResult::ALL {
            map.serialize_entry(result.name(), &result.of(goda))?;
            if *result == SeaResult::Angle {
                map.serialize_entry("turn_deg", &choices.turn_deg)?;
                map.serialize_entry("impulsive", &choices.impulsive)?;
                map.serialize_entry("lambda", &choices.lambda)?;
            }
        }
        map.end()
    }
}

impl<'a> Situation<'a> {
    fn of(assessment: &'a Assessment, assessed: &'a Assessed, view: &AssessmentView) -> Situation<'a> {
        let case = &assessment.case;
        let full = &assessed.outcome.full;
        let on_plan = assessed.outcome.plan.is_some();
        let one_body = assessed.joints.is_none() && !on_plan;
        let (plan, directions) = PlanEntry::of(assessed).unzip();
        Situation {
            load: match assessed.acting {
                Acting::Alone(index) => Some(Force::of(&case.forces[index])),
                _ => None,
            },
            combination: match assessed.acting {
                Acting::Combination(index) => Some(Combination::of(case, index, assessed)),
                _ => None,
            },
            earthquake: assessed.earthquake.as_ref().map(Earthquake::of),
            other_earthquakes: assessed
                .others
                .iter()
                .filter(|other| other.trial.second == assessed.trial.second)
                .filter_map(|other| Some(OtherEarthquake::of(other.earthquake.as_ref()?, other)))
                .collect(),
            criteria: assessment
                .checks_in(assessed)
                .iter()
                .map(|check| Criterion::of(assessment, check))
                .collect(),
            results: Results { of: assessed, criteria: case.criteria_of(assessed.acting) },
            ground: assessed.ground.as_ref().map(|_| Ground(assessed)),
            mode_words: assessed.verdict().filter(|_| one_body).map(Verdict::words),
            because: assessed.because().iter().map(RelationDocument::of).collect(),
            motion: assessed.motion().copied().filter(|_| one_body),
            wrench: full.wrench,
            components: assessed
                .components()
                .into_iter()
                .map(|component| Component {
                    name: component.name,
                    source: component.load.source,
                    counts_as: component.load.kind,
                    permanent: component.load.permanent,
                    factor: component.load.factor,
                    wrench: component.wrench,
                    z: on_plan.then(|| assessed.situation.away(&component.load)),
                })
                .collect(),
            base_opening: BaseOpeningEntry::of(assessed),
            adhesion: AdhesionEntry::of(case, assessed),
            resistances: ResistanceEntry::all(case, assessed),
            made_loads: made_loads(case.under(assessed.acting), assessed),
            path: match one_body {
                true => assessed.path_up_to(view.up_to).iter().map(PathStage::of).collect(),
                false => Vec::new(),
            },
            plan,
            directions,
            joints: JointEntries::of(case, assessed, view),
            // The report's ground is rigid.
            report: full.effective.as_ref().filter(|_| one_body && !assessed.is_on_ground()).map(|reduced| {
                Report {
                    point: PointDocument::of_rigid(reduced, full),
                    overturning: reduced.point.safety_against_overturning(),
                }
            }),
            no_report: match () {
                () if on_plan => Some("plan"),
                () if !one_body => Some("joints"),
                () if assessed.is_on_ground() => Some("base-gives-way"),
                () if full.effective.is_none() => Some("no-point"),
                () => None,
            },
        }
    }
}

impl<'a> Force<'a> {
    fn of(force: &'a PointForce) -> Force<'a> {
        let couple = matches!(force.direction, Direction::Turning(_));
        let direction_deg = force.across.as_ref().and_then(|across| across.direction_deg);
        let (magnitude, elevation) = (Some(force.magnitude), Some(force.elevation));
        Force {
            name: force.name.as_deref(),
            force: magnitude.filter(|_| !couple),
            moment: magnitude.filter(|_| couple),
            elevation: elevation.filter(|_| !couple),
            distance: force.distance,
            direction: direction_deg.is_none().then(|| force.direction.word()),
            direction_deg,
            lever: force.lever.as_deref(),
        }
    }
}

impl<'a> Combination<'a> {
    fn of(case: &'a Case, index: usize, assessed: &'a Assessed) -> Combination<'a> {
        let (combination, under) = (&case.combinations[index], case.under(assessed.acting));
        let factors = combination.factors.iter().map(|(name, factor)| {
            let factor = match *factor {
                LoadFactor::One(factor) => NamedValue::Number(factor),
                LoadFactor::Pair(both) => NamedValue::Pair(both),
            };
            (Cow::Borrowed(name.as_str()), factor)
        });
        let [mut set, mut scale, mut materials, mut resist] = [const { Vec::new() }; 4];
        for change in &combination.changes {
            let (to, value) = match &change.by {
                ChangeBy::Set(text) => (&mut set, NamedValue::Words(text.trim_matches(['"', '\'']))),
                ChangeBy::Scale(by) => (&mut scale, NamedValue::Number(*by)),
                ChangeBy::Material(by) => (&mut materials, NamedValue::Number(*by)),
                ChangeBy::Resistance(_) if change.id.key != Key::Friction => continue,
                ChangeBy::Resistance(by) => (&mut resist, NamedValue::Number(*by)),
            };
            to.push((Cow::Borrowed(change.name.as_str()), value));
        }
        let holds = combination.holds.iter();
        resist.extend(holds.map(|(name, by)| (Cow::Borrowed(name.as_str()), NamedValue::Number(*by))));
        if combination.bearing != 1.0 {
            resist.push((Cow::Borrowed("bearing"), NamedValue::Number(combination.bearing)));
        }
        let numbers = case.values_in(index);
        let numbers = numbers.map(|(id, value)| (Cow::Owned(id.to_string()), NamedValue::Number(value)));
        let pairs = |assessed: &Assessed| combination::pairs(case, assessed.acting, assessed.trial);
        let used = pairs(assessed);
        let others = if used.is_empty() { &[][..] } else { &assessed.others };
        Combination {
            name: combination.name.as_deref(),
            factors: Named::of(factors.collect()),
            code: combination.code.as_ref().map(Code::name),
            effects: combination.effects,
            set: Named::of(set),
            scale: Named::of(scale),
            materials: Named::of(materials),
            resist: Named::of(resist),
            numbers: Named::of(numbers.collect()),
            wave: under.goda().filter(|_| under.wave != case.wave).map(Wave),
            tried: others.iter().map(|other| Tried::of(pairs(other), other)).collect(),
            factors_used: Named::numbers(used),
        }
    }
}

impl<'a> Tried<'a> {
    fn of(factors: Vec<(&'a str, f64)>, assessed: &Assessed) -> Tried<'a> {
        Tried {
            factors: Named::numbers(factors),
            earthquake: assessed.earthquake.as_ref().map(Earthquake::of),
            answer: ShortAnswer::of(assessed),
        }
    }
}

impl Earthquake {
    fn of(earthquake: &loads::Earthquake) -> Earthquake {
        let away = earthquake.away();
        Earthquake {
            horizontal: earthquake.horizontal(),
            vertical: earthquake.vertical(),
            horizontal_z: (away != 0.0).then_some(away),
        }
    }
}

impl OtherEarthquake {
    fn of(earthquake: &loads::Earthquake, other: &Assessed) -> OtherEarthquake {
        OtherEarthquake { earthquake: Earthquake::of(earthquake), answer: ShortAnswer::of(other) }
    }
}

impl ShortAnswer {
    fn of(assessed: &Assessed) -> ShortAnswer {
        ShortAnswer {
            mode: ResultName::Mode.of(assessed),
            departure: ResultName::Departure.of(assessed),
            load_factor: ResultName::LoadFactor.of(assessed),
            departure_mode: ResultName::DepartureMode.of(assessed),
            sliding: ResultName::SfSliding.of(assessed),
            overturning: ResultName::SfOverturningNet.of(assessed),
            joints: ShortJoints::of(assessed),
        }
    }
}

impl<'a> Criterion<'a> {
    fn of(assessment: &'a Assessment, check: &AnyCheck<'_>) -> Criterion<'a> {
        let earthquake = match check {
            AnyCheck::Instant(CaseCheck { assessed, .. }) => assessed.earthquake.as_ref().map(Earthquake::of),
            // The base moves as its records say, with no one acceleration.
            AnyCheck::Motion(..) => None,
        };
        let assessed = check.assessed(assessment);
        let pairs = combination::pairs(&assessment.case, assessed.acting, assessed.trial);
        let factors_used = Named::numbers(pairs);
        Criterion { check: CheckEntry::of(check), situation: assessed.index, earthquake, factors_used }
    }
}

impl PathStage {
    fn of(stage: &Stage) -> PathStage {
        PathStage { from: stage.from, to: stage.to, mode: stage.verdict, also: stage.others() }
    }
}
