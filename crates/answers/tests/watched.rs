//! Long work under the eyes of somebody: what is told of it, what changes by that, and what is left of it when it is stopped.

use std::path::{Path, PathBuf};
use std::sync::Mutex;

use standfast_answers::Assessment;
use standfast_answers::design::{BoundaryRequest, DesignBoundary, DesignRequest, Extreme, Spelling};
use standfast_answers::design::{Design, DesignError};
use standfast_answers::motion::{Follow, FollowedMotion, Spectrum, SpectrumError, SpectrumKind};
use standfast_answers::motion::{SpectrumRequest, StrengthAsked};
use standfast_answers::random::{ChanceRequest, Effort, Method, Probability, ProbabilityError};
use standfast_model::CaseFile;
use standfast_motion::MotionError;
use standfast_motion::strength::Factors;
use standfast_watch::{Portion, Watch};

/// Shares as they are told; says stop from one of them on.
struct Told {
    shares: Mutex<Vec<f64>>,
    until: f64,
}

impl Watch for Told {
    fn reached(&self, share: f64) {
        self.shares.lock().unwrap().push(share);
    }

    fn is_stopped(&self) -> bool {
        self.shares.lock().unwrap().last().is_some_and(|share| *share >= self.until)
    }
}

/// Work on a portion, in words: the answer, or that it was stopped.
type Work = Box<dyn Fn(Portion<'_>) -> Option<String>>;

fn file(name: &str) -> CaseFile {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    let folder = path.parent().map(PathBuf::from).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    let beside = |name: &str| std::fs::read_to_string(folder.join(name)).map_err(|error| error.to_string());
    CaseFile::read(name, &text, &beside).unwrap_or_else(|error| panic!("{error}"))
}

/// A probability on one thread, by points that are drawn.
fn chances(name: &'static str, points: u64, over: Option<&'static str>, method: Option<Method>) -> Work {
    Box::new(move |portion| {
        let effort = Effort { points, threads: 1, ..Effort::default() };
        let request = ChanceRequest { effort, method, ..ChanceRequest::default() };
        let over = over.map(|over| over.parse().unwrap());
        match Probability::under(&file(name), request, over.as_ref(), &[], portion) {
            Ok(answer) => {
                Some(format!("{:?} {:?} {:?}", answer.situations, answer.sliding, answer.overturning))
            }
            Err(ProbabilityError::Stopped(_)) => None,
            Err(error) => panic!("{name}: {error}"),
        }
    })
}

fn request(vary: &str, target: &str) -> DesignRequest {
    DesignRequest {
        vary: vary.to_owned(),
        target: target.parse().unwrap(),
        extreme: Extreme::Least,
        from: None,
        to: None,
        spelling: &Spelling::PROGRAM,
    }
}

fn design(name: &'static str, vary: &'static str, target: &'static str) -> Work {
    Box::new(move |portion| match Design::of(&file(name), request(vary, target), portion) {
        Ok(design) => Some(format!("{:?} {:?}", design.stretches, design.sensitivities)),
        Err(DesignError::Stopped(_)) => None,
        Err(error) => panic!("{name}: {error}"),
    })
}

fn boundary() -> Work {
    Box::new(|portion| {
        let design = request("width", "SF_sliding=1.2");
        let request = BoundaryRequest { design, and: "friction".to_owned(), from: None, to: None };
        match DesignBoundary::of(&file("goda-2000.toml"), request, portion) {
            Ok(found) => Some(found.columns.iter().map(|column| format!("{:?}", column.binding())).collect()),
            Err(DesignError::Stopped(_)) => None,
            Err(error) => panic!("{error}"),
        }
    })
}

fn spectrum(name: &'static str, kind: SpectrumKind) -> Work {
    Box::new(move |portion| {
        let case = file(name).motions().unwrap().swap_remove(0);
        match Spectrum::of(&case, &SpectrumRequest::new(kind), portion) {
            Ok(found) => Some(format!("{:?}", found.points)),
            Err(SpectrumError::Stopped(_)) => None,
            Err(error) => panic!("{error}"),
        }
    })
}

fn motion() -> Work {
    Box::new(|portion| {
        let follow = Follow { strength: StrengthAsked::Always(Factors::Rungs), ..Follow::default() };
        match FollowedMotion::of_all(
            file("motion/block-base-pulse.toml").motions().unwrap(),
            &follow,
            portion,
        ) {
            Ok(all) => Some(format!("{:?}", all.iter().map(|of| &of.strength).collect::<Vec<_>>())),
            Err(MotionError::Stopped(_)) => None,
            Err(error) => panic!("{error}"),
        }
    })
}

fn works() -> Vec<(&'static str, Work)> {
    let storm = "goda-2000-storm.toml";
    vec![
        ("storms", chances(storm, 1 << 14, None, None)),
        ("integrals", chances("statue-random.toml", 1 << 14, None, None)),
        ("points", chances("goda-2000-random.toml", 1 << 14, None, Some(Method::Sobol))),
        ("draws", chances("goda-2000-random.toml", 1 << 14, None, Some(Method::MonteCarlo))),
        (
            "a fragility",
            chances("goda-2000-random.toml", 1 << 12, Some("width=18 m..26 m:5"), Some(Method::Sobol)),
        ),
        ("records", chances("probability/column-records.toml", 1 << 12, Some("pga=0.2 g..0.4 g:3"), None)),
        ("a design", design("goda-2000.toml", "width", "SF_sliding=1.2")),
        ("a design by chances", design("statue-random.toml", "width", "p_not_rest=0.1")),
        ("a boundary", boundary()),
        ("blocks", spectrum("motion/block-base-pulse.toml", SpectrumKind::Rocking)),
        ("slides", spectrum("motion/block-base-pulse.toml", SpectrumKind::Newmark)),
        ("a curve", spectrum("motion/block-base-pulse.toml", SpectrumKind::Overturning)),
        ("a motion", motion()),
    ]
}

/// Told on one thread, shares rise from little to the whole, and the answer is the same as without.
#[test]
fn shares_rise_to_the_whole_and_change_nothing() {
    for (name, work) in works() {
        let told = Told { shares: Mutex::default(), until: f64::INFINITY };
        let answer = work(Portion::whole(&told)).unwrap();
        let shares = told.shares.into_inner().unwrap();
        assert!(shares.len() >= 4 && shares[0] < 0.7, "{name}: {shares:?}");
        assert_eq!(shares.last(), Some(&1.0), "{name}");
        assert!(shares.iter().all(|share| (0.0..=1.0).contains(share)), "{name}");
        assert_eq!(answer, work(Portion::UNSEEN).unwrap(), "{name}");
    }
}

/// Stopped at the first word or half-way, no work has an answer, and nothing more is told.
#[test]
fn stopped_work_has_no_answer() {
    for (name, work) in works() {
        for until in [0.0, 0.5] {
            let told = Told { shares: Mutex::default(), until };
            assert_eq!(work(Portion::whole(&told)), None, "{name}");
            let shares = told.shares.into_inner().unwrap();
            assert_eq!(shares.iter().filter(|share| **share >= until).count(), 1, "{name} from {until} on");
        }
    }
}

/// Who asks for a case's answer hears of the chance that its criteria take.
#[test]
fn a_criterion_of_chances_is_told_too() {
    let text = std::fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/goda-2000-random.toml"),
    );
    let text = format!("{}\n[criteria]\np_not_rest = 0.1\n", text.unwrap());
    let file = CaseFile::parse("case.toml", &text).unwrap();
    let told = Told { shares: Mutex::default(), until: f64::INFINITY };
    let answer = Assessment::following(&file, None, Portion::whole(&told)).unwrap();
    assert!(answer.all[0].chances.is_some() && !told.shares.into_inner().unwrap().is_empty());
}
