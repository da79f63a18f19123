//! Draws of a body, against `assess` of the same case with the drawn numbers typed in: for every kind of number that can be
//! random, some hundred draws each. Nothing is taken from the tables of what goes with a number: the text says it by hand.

use std::collections::BTreeMap;

use standfast::{Mode, Verdict};
use standfast_cases::random::{Draws, Happening, ProbabilityError};
use standfast_cases::{Assessment, CaseFile};

/// A case as text, by its random numbers; what they are where they are not random; their names and laws.
struct Family {
    name: &'static str,
    text: fn(&[f64]) -> String,
    random: &'static [(&'static str, f64, &'static str)],
    /// Outcomes that have to be among the draws.
    seen: &'static [&'static str],
}

const DRAWS: u64 = 600;

/// The verdicts of `assess`, by acting loads and accelerations of the base; none where the numbers do not go together.
fn typed(text: &str) -> Option<Vec<String>> {
    let case = CaseFile::parse("case.toml", text).ok()?.case().ok()?;
    let assessment = Assessment::of(&case).ok()?;
    let mut all = Vec::new();
    for (place, acting) in case.acting().into_iter().enumerate() {
        let shakings = case.shakings(acting);
        let each: Vec<_> = match shakings.is_empty() {
            true => vec![None],
            false => shakings.into_iter().map(|signs| case.shaken(signs)).collect(),
        };
        for earthquake in each {
            let assessed = assessment.all.iter().find(|assessed| assessed.index == place).unwrap();
            let found = assessed.tried().find(|tried| tried.earthquake == earthquake).unwrap();
            all.push(found.verdict().map_or("no mode".to_owned(), |verdict| verdict.to_string()));
        }
    }
    Some(all)
}

fn check(family: &Family) {
    let Family { name, text, random, seen } = family;
    let nominal: Vec<f64> = random.iter().map(|(_, nominal, _)| *nominal).collect();
    let laws: String = random.iter().map(|(name, _, law)| format!("\"{name}\" = {law}\n")).collect();
    let whole = format!("{}\n[random]\n{laws}", text(&nominal));
    let draws = |situation: Option<&str>| {
        Draws::of(&CaseFile::parse("case.toml", &whole).unwrap(), situation, DRAWS, 3)
    };
    let refused = |error: ProbabilityError| -> String {
        format!("{name}: {}\n{whole}", standfast_cases::report(&error))
    };
    let situations: Vec<Option<String>> = match draws(None) {
        Err(ProbabilityError::Situation { known, .. }) => known.into_iter().map(Some).collect(),
        Ok(_) => vec![None],
        Err(error) => panic!("{}", refused(error)),
    };
    let mut counts: BTreeMap<String, u32> = BTreeMap::new();
    for (place, situation) in situations.iter().enumerate() {
        let found = draws(situation.as_deref()).unwrap_or_else(|error| panic!("{}", refused(error)));
        for (row, drawn) in found.drawn.iter().enumerate() {
            let values: Vec<f64> = found.values.iter().map(|column| column[row]).collect();
            let text = text(&values);
            let expected = typed(&text).map_or("not a body".to_owned(), |all| all[place].clone());
            assert_eq!(
                drawn.happens.name(),
                expected,
                "{name}, {situation:?}, draw {row}: {values:?}\n{text}"
            );
            *counts.entry(expected).or_default() += 1;
        }
    }
    for outcome in *seen {
        assert!(counts.get(*outcome).is_some_and(|count| *count >= 5), "{name}: {outcome} of {counts:?}");
    }
}

const NORMAL: &str = "{ normal = { cov = 0.1 } }";
const WIDE: &str = "{ normal = { cov = 0.3 } }";

/// A caisson in air on a base that is said elsewhere.
fn on(ground: &str, friction: f64, force: f64) -> String {
    pushed_at(11.5, ground, friction, force)
}

fn pushed_at(elevation: f64, ground: &str, friction: f64, force: f64) -> String {
    format!(
        "[body]\nwidth = 15\nheight = 12\nmass = 378e3\nfriction = {friction}\n[ground]\n{ground}\n[[load]]\nname = \"push\"\n\
         force = {force}\nelevation = {elevation}\n"
    )
}

#[test]
fn on_a_base_that_crushes() {
    check(&Family {
        name: "strength",
        text: |v| pushed_at(9.0, &format!("strength = {}", v[2]), v[0], v[1]),
        random: &[
            ("friction", 0.6, NORMAL),
            ("load.push.force", 2.2e6, "{ normal = { cov = 0.15 } }"),
            ("ground.strength", 6e5, "{ lognormal = { cov = 0.6 } }"),
        ],
        seen: &["RE", "SL", "RO", "SRO-", "BF"],
    });
    check(&Family {
        name: "strength and stiffness, friction to slip",
        text: |v| {
            let text = pushed_at(10.3, &format!("strength = {}\nstiffness = {}", v[2], v[3]), v[0], v[1]);
            text.replace("\n[ground]", &format!("\nkinetic_friction = {}\n[ground]", v[0] * 0.75))
        },
        random: &[
            ("friction", 0.6, NORMAL),
            ("load.push.force", 2.2e6, "{ normal = { cov = 0.15 } }"),
            ("ground.strength", 3e6, "{ lognormal = { cov = 0.4 } }"),
            ("ground.stiffness", 5e7, "{ lognormal = { cov = 0.4 } }"),
        ],
        seen: &["RE", "SL", "RO"],
    });
}

#[test]
fn on_ground_that_fails() {
    for law in ["ec7", "hansen"] {
        let text = |v: &[f64]| {
            let keys = ["friction_angle_deg", "unit_weight", "surcharge", "cohesion"];
            let lines: String = keys.iter().zip(&v[2..]).map(|(key, v)| format!("{key} = {v}\n")).collect();
            on(&lines, v[0], v[1])
        };
        let text = match law {
            "ec7" => text,
            _ => |v: &[f64]| {
                let keys = ["friction_angle_deg", "unit_weight", "surcharge", "cohesion"];
                let lines: String =
                    keys.iter().zip(&v[2..]).map(|(key, v)| format!("{key} = {v}\n")).collect();
                on(&format!("law = \"hansen\"\n{lines}"), v[0], v[1])
            },
        };
        check(&Family {
            name: law,
            text,
            random: &[
                ("friction", 0.5, NORMAL),
                ("load.push.force", 1.6e6, WIDE),
                ("ground.friction_angle_deg", 38.0, "{ normal = { sd = 2 } }"),
                ("ground.unit_weight", 1e4, NORMAL),
                ("ground.surcharge", 3e4, WIDE),
                ("ground.cohesion", 2e4, WIDE),
            ],
            seen: &["RE", "SL", "BF"],
        });
    }
    check(&Family {
        name: "envelope",
        text: |v| {
            let ground = format!(
                "law = \"envelope\"\ncentric_resistance = {}\nt_h = {}\nt_m = {}\nC = {}",
                v[2], v[3], v[4], v[5]
            );
            on(&ground, v[0], v[1])
        },
        random: &[
            ("friction", 0.35, NORMAL),
            ("load.push.force", 1.2e6, WIDE),
            ("ground.centric_resistance", 2e7, WIDE),
            ("ground.t_h", 0.6, NORMAL),
            ("ground.t_m", 0.4, NORMAL),
            ("ground.C", 0.3, "{ normal = { sd = 0.3 } }"),
        ],
        seen: &["RE", "SL", "BF"],
    });
}

/// An elastic base bears everything: the modes are those on a rigid one, whatever its stiffness.
#[test]
fn on_an_elastic_base() {
    check(&Family {
        name: "stiffness",
        text: |v| on(&format!("stiffness = {}\ntangential_stiffness = {}", v[2], v[3]), v[0], v[1]),
        random: &[
            ("friction", 0.6, NORMAL),
            ("load.push.force", 2.4e6, "{ normal = { cov = 0.15 } }"),
            ("ground.stiffness", 5e7, "{ lognormal = { cov = 0.5 } }"),
            ("ground.tangential_stiffness", 2e7, "{ lognormal = { cov = 0.5 } }"),
        ],
        seen: &["RE", "SL", "RO"],
    });
}

/// Goda's caisson on sand: the wave's uplift takes of what presses the ground.
#[test]
fn under_waves_on_sand() {
    check(&Family {
        name: "goda on sand",
        text: |v| {
            let goda = include_str!("../../../examples/goda-2000.toml");
            let text = goda.replace("friction = 0.6", &format!("friction = {}", v[0]));
            let text =
                text.replace("deep_water_height = \"6.3 m\"", &format!("deep_water_height = {}", v[1]));
            let text = text.replace("period = \"11.4 s\"", &format!("period = {}", v[2]));
            format!("{text}\n[ground]\nunit_weight = 1e4\nfriction_angle_deg = {}\n", v[3])
        },
        random: &[
            ("friction", 0.6, NORMAL),
            ("wave.deep_water_height", 6.3, "{ normal = { cov = 0.15 } }"),
            ("wave.period", 11.4, NORMAL),
            ("ground.friction_angle_deg", 37.0, "{ normal = { sd = 3 } }"),
        ],
        seen: &["RE", "SL", "BF"],
    });
}

/// Friction to stick and to slip with a law each, or one that goes with the other; a friction to slip above that to stick is not a body.
#[test]
fn two_frictions() {
    let text = |v: &[f64]| {
        format!(
            "[body]\nwidth = 4\nheight = 8\nmass = 60e3\nfriction = {}\nkinetic_friction = {}\n[[load]]\nname = \"push\"\n\
             force = {}\nelevation = 5\n",
            v[0], v[1], v[2]
        )
    };
    check(&Family {
        name: "both",
        text,
        random: &[
            ("friction", 0.4, NORMAL),
            ("body.kinetic_friction", 0.36, NORMAL),
            ("load.push.force", 2.3e5, "{ normal = { cov = 0.2 } }"),
        ],
        seen: &["RE", "SL", "not a body"],
    });
    check(&Family {
        name: "friction to slip alone",
        text: |v| {
            format!(
                "[body]\nwidth = 4\nheight = 8\nmass = 60e3\nfriction = 0.42\nkinetic_friction = {}\n[[load]]\nname = \"push\"\n\
                 force = {}\nelevation = 3\n",
                v[0], v[1]
            )
        },
        random: &[("body.kinetic_friction", 0.36, NORMAL), ("load.push.force", 2.3e5, WIDE)],
        seen: &["RE", "SL", "not a body"],
    });
    check(&Family {
        name: "in proportion",
        text: |v| {
            format!(
                "[body]\nwidth = 4\nheight = 8\nmass = 60e3\nfriction = {}\nkinetic_friction = {}\n[[load]]\nname = \"push\"\n\
                 force = {}\nelevation = 6\n",
                v[0],
                v[0] * 0.8,
                v[1]
            )
        },
        random: &[("friction", 0.4, WIDE), ("load.push.force", 2.0e5, WIDE)],
        seen: &["RE", "SL", "RO"],
    });
}

/// Earthquakes to both sides, up and down, with random accelerations.
#[test]
fn earthquakes() {
    check(&Family {
        name: "both ways",
        text: |v| {
            format!(
                "[body]\nwidth = 3\nheight = 7\nmass = 50e3\nfriction = {}\ncentroid_offset = {}\n[earthquake]\nhorizontal = \"{} m/s2\"\n\
                 vertical = \"{} m/s2\"\n",
                v[0], v[3], v[1], v[2]
            )
        },
        random: &[
            ("friction", 0.5, NORMAL),
            ("earthquake.horizontal", 4.2, WIDE),
            ("earthquake.vertical", 1.5, WIDE),
            ("body.centroid_offset", 0.1, WIDE),
        ],
        seen: &["RE", "SL", "SL+", "RO", "RO'"],
    });
    check(&Family {
        name: "on ground that fails",
        text: |v| {
            format!(
                "[body]\nwidth = 10\nheight = 7\nmass = 150e3\nfriction = {}\n[earthquake]\nhorizontal = \"{} m/s2\"\n[ground]\n\
                 friction_angle_deg = {}\nunit_weight = 1e4\n",
                v[0], v[1], v[2]
            )
        },
        random: &[
            ("friction", 0.3, NORMAL),
            ("earthquake.horizontal", 2.5, WIDE),
            ("ground.friction_angle_deg", 32.0, "{ normal = { sd = 3 } }"),
        ],
        seen: &["RE", "SL", "SL+", "BF"],
    });
}

/// An acceleration in a law has its unit, as behind its key.
#[test]
fn accelerations_in_laws_have_their_unit() {
    let law = |law: &str| {
        let text = format!(
            "[body]\nwidth = 3\nheight = 4\nmass = 50e3\nfriction = 0.3\n[earthquake]\nhorizontal = \"0.25 g\"\n[random]\n\
             earthquake.horizontal = {law}\n"
        );
        let request = standfast_cases::random::ChanceRequest::default();
        let found =
            standfast_cases::random::Probability::of(&CaseFile::parse("case.toml", &text).unwrap(), request)
                .unwrap();
        found.situations[0].not_rest.value
    };
    // It slides beyond 0.3 g: Φ(−1).
    let by_hand = standfast_probability::normal::above(1.0);
    let own = "{ normal = { sd = \"0.05 g\" } }";
    let shares = "{ normal = { mean = \"0.25 g\", sd = \"0.05 g\" } }";
    let said = "{ normal = { mean = \"2.4525 m/s2\", sd = \"0.4905 m/s2\" } }";
    for law in [own, shares, said].map(law) {
        assert!((law / by_hand - 1.0).abs() < 1e-9, "{law} {by_hand}");
    }
}

/// A shaking that is random goes to both sides, also where the case's own is zero: about the nearer edge the body begins to rock beyond
/// (b − e)/h = 1.2/3.5 of g, which the lognormal law exceeds as often as its logarithm tells.
#[test]
fn a_random_shaking_goes_to_both_sides() {
    let answer = |own: &str| {
        let text = format!(
            "[body]\nwidth = 3\nheight = 7\nmass = 50e3\nfriction = 0.9\ncentroid_offset = 0.3\n[earthquake]\nhorizontal = {own}\n\
             [random]\nearthquake.horizontal = {{ lognormal = {{ mean = \"0.3 g\", cov = 0.3 }} }}\n"
        );
        let request = standfast_cases::random::ChanceRequest::default();
        let found =
            standfast_cases::random::Probability::of(&CaseFile::parse("case.toml", &text).unwrap(), request)
                .unwrap();
        assert_eq!(found.situations.len(), 2);
        found.situations.into_iter().map(|chances| (chances.situation.unwrap(), chances.not_rest.value))
    };
    let variance = 0.09f64.ln_1p();
    let by_hand = |share: f64| {
        standfast_probability::normal::above(((share / 0.3).ln() + 0.5 * variance) / variance.sqrt())
    };
    for own in ["0", "\"0.3 g\""] {
        for ((situation, found), (expected, side)) in
            answer(own).zip([(by_hand(1.2 / 3.5), "left"), (by_hand(1.8 / 3.5), "right")])
        {
            assert_eq!(situation, format!("base shaken to the {side}"));
            assert!((found / expected - 1.0).abs() < 1e-9, "{own} {side}: {found} {expected}");
        }
    }
}

/// Parts, a polygon among them, still water and uplift; the friction angle of what is piled on top is none of the body's.
#[test]
fn bodies_of_parts_in_water() {
    check(&Family {
        name: "crown wall",
        text: |v| {
            let wall = include_str!("../../../examples/crown-wall.toml");
            let text = wall.replace("friction = 0.6", &format!("friction = {}", v[0]));
            let text = text.replacen("density = \"2400 kg/m3\"", &format!("density = {}", v[1]), 1);
            let text = text.replace("density = \"1700 kg/m3\"", &format!("density = {}", v[2]));
            let text = text.replace("right = \"30 kPa\"", &format!("right = {}", v[3]));
            text.replace("force = \"105 kN/m\"", &format!("force = {}", v[4]))
        },
        random: &[
            ("friction", 0.6, NORMAL),
            ("part[1].density", 2400.0, NORMAL),
            ("part[3].density", 1700.0, NORMAL),
            ("uplift.right", 3e4, WIDE),
            ("load[1].force", 1.05e5, WIDE),
        ],
        seen: &["RE", "SL"],
    });
    check(&Family {
        name: "quay",
        text: |v| {
            let quay = include_str!("../../../examples/quay.toml");
            let text = quay.replace("friction = 0.6", &format!("friction = {}", v[0]));
            let text = text.replace("left = \"9 m\"", &format!("left = {}", v[1]));
            text.replace("force = \"40 kN/m\"", &format!("force = {}", v[2]))
        },
        random: &[
            ("friction", 0.3, NORMAL),
            ("water.left", 9.0, "{ normal = { sd = 0.3 } }"),
            ("load.bollard.force", 2e5, WIDE),
        ],
        seen: &["RE", "SL"],
    });
}

/// Forces that act one by one, off the middle, on a body that is not uniform; of an object of a given length.
#[test]
fn several_loads_on_an_eccentric_body() {
    check(&Family {
        name: "two pushes",
        text: |v| {
            format!(
                "[body]\nwidth = 5\nheight = 9\nlength = 4\nmass = 300e3\nfriction = {}\nmoment_of_inertia = {}\nbase_left = {}\n\
                 base_right = 4.6\n[[load]]\nname = \"left\"\nforce = {}\nelevation = 8\n[[load]]\nname = \"right\"\nforce = {}\n\
                 elevation = 4\ndirection = \"right\"\n",
                v[0], v[1], v[2], v[3], v[4]
            )
        },
        random: &[
            ("friction", 0.4, NORMAL),
            ("body.moment_of_inertia", 3e6, NORMAL),
            ("body.base_left", 0.5, WIDE),
            ("load.left.force", 7e5, WIDE),
            ("load.right.force", 1.1e6, WIDE),
        ],
        seen: &["RE", "SL+", "RO"],
    });
}

/// Friction, integrated in closed form, against all drawn; first departures too; over a life and along a number.
#[test]
fn integrated_on_a_base_that_gives_way_is_what_is_drawn() {
    use standfast_cases::random::{ChanceRequest, Effort, Method, Probability};
    let laws = "[random]\nyears = 20\nfriction = { normal = { cov = 0.1 } }\n\
                \"load.push.force\" = { normal = { cov = 0.2 }, every = \"year\" }\n";
    let stone = pushed_at(10.8, "strength = 1.5e6", 0.58, 1.9e6);
    let sand = pushed_at(7.0, "friction_angle_deg = 34\nunit_weight = 1e4\ncohesion = 5e3", 0.4, 1.4e6);
    for (text, expected) in [(stone, &["RE", "SL", "RO"][..]), (sand, &["RE", "SL", "BF"])] {
        let of = |method| {
            let effort = Effort { points: 1 << 17, precision: 1e-4, ..Effort::default() };
            let request = ChanceRequest { method: Some(method), effort, ..ChanceRequest::default() };
            let over = "load.push.elevation=4..10:3".parse().unwrap();
            let over = (method == Method::Integrate).then_some(&over);
            let found = Probability::along(
                &CaseFile::parse("case.toml", &format!("{text}{laws}")).unwrap(),
                request,
                over,
            );
            found.unwrap_or_else(|error| panic!("{}", standfast_cases::report(&error)))
        };
        let (integrated, drawn) = (of(Method::Integrate), of(Method::MonteCarlo));
        let [one, other] = [&integrated, &drawn].map(|found| &found.situations[0]);
        assert_eq!(one.method, Method::Integrate);
        let pairs = one.modes.iter().zip(&other.modes);
        let departures = one.first_departure.modes.iter().zip(&other.first_departure.modes);
        for ((happening, p), (_, shares)) in pairs.chain(departures) {
            // Half as wide again as the 95 % interval, as there are many.
            let (low, high) = (1.5 * shares.low - 0.5 * shares.value, 1.5 * shares.high - 0.5 * shares.value);
            assert!(low <= p.value && p.value <= high, "{text}{happening:?}: {p:?} {shares:?}");
        }
        for name in expected {
            let of = one.modes.iter().find(|(happening, _)| happening.name() == *name).unwrap();
            assert!(of.1.value > 0.01, "{name}: {of:?}");
        }
        let sum: f64 = one.modes.iter().map(|(_, p)| p.value).sum();
        assert!((sum - 1.0).abs() < 1e-9, "{sum}");
        let life = one.life.as_ref().unwrap().not_rest.value;
        let not_rest = one.not_rest.value;
        assert!(life > not_rest && life < 1.0 - (1.0 - not_rest).powi(20) + 1e-9, "{life} {not_rest}");
        let points = integrated.fragility.unwrap().points;
        assert!(
            points
                .iter()
                .all(|point| (point.modes.iter().map(|(_, p)| p.value).sum::<f64>() - 1.0).abs() < 1e-9)
        );
        assert!(points.windows(2).all(|pair| pair[0].not_rest.value < pair[1].not_rest.value));
    }
}

/// Storms on a base that gives way, and on one that is elastic.
#[test]
fn storms_are_answered_on_a_base_that_gives_way() {
    use standfast_cases::random::{ChanceRequest, Probability};
    let goda = include_str!("../../../examples/goda-2000.toml");
    let laws = "[random]\nfriction = { normal = { cov = 0.1 } }\n[storm]\nwaves = 10\ntau0 = 1\n";
    let of = |ground: &str, follow: bool| {
        let text = format!("{goda}\n[ground]\n{ground}\n{laws}");
        let request = ChanceRequest { follow, ..ChanceRequest::default() };
        Probability::of(&CaseFile::parse("case.toml", &text).unwrap(), request)
            .map(|_| ())
            .map_err(|error| error.to_string())
    };
    assert_eq!(of("strength = 1e6", false), Ok(()));
    assert_eq!(of("stiffness = 5e7", true), Ok(()));
    // A rotation on a base that crushes under it is none that is followed.
    assert!(of("strength = 1e6", true).unwrap_err().contains("[ground] that crushes or fails"));
}

/// A drawn verdict is one of the contact problem's modes, or that the ground fails.
#[test]
fn the_ground_s_failure_has_a_name() {
    assert_eq!(Happening::Decided(Verdict::BearingFailure).name(), Verdict::BearingFailure.symbol());
    assert_eq!(Happening::Decided(Verdict::BearingFailure).mode(), None);
    assert_eq!(Happening::REST.mode(), Some(Mode::Rest));
}
