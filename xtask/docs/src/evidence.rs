//! docs/trust/evidence.md: how far each claim is known. Every number of its first table comes from another file of the repository, which
//! is named beside it; a test asks whether it still stands there.

/// The page without its first table, which stands where its line `{table}` is.
pub const REST: &str = include_str!("evidence.md");

/// A number, the file of the repository that it comes from, and the text there.
type Place = (&'static str, &'static str, &'static str);

/// A row of the table.
struct Row {
    claim: &'static str,
    against: &'static str,
    independent: &'static str,
    count: &'static str,
    result: &'static str,
    repeat: &'static str,
    /// Whether it is held against measurements: the row is bold.
    measured: bool,
    /// Where its numbers come from.
    #[cfg_attr(not(test), allow(dead_code, reason = "a test reads it, the page does not show it"))]
    places: &'static [Place],
}

const EXACTNESS: &str = "crates/standfast/tests/exactness.rs";
const ENUMERATION: &str = "crates/standfast/tests/enumeration.rs";
const STACK: &str = "crates/standfast/tests/stack.rs";
const JOINTS: &str = "crates/cases/tests/joints.rs";
const FOOTPRINT: &str = "crates/standfast/tests/footprint.rs";
const DIRECTIONS: &str = "crates/cases/tests/directions.rs";
const JOINTS_DRAWN: &str = "crates/cases/tests/joints_random.rs";
const COMMON: &str = "crates/standfast/tests/common/mod.rs";
const WAVES: &str = "crates/standfast/tests/waves.rs";
const BEARING: &str = "crates/standfast/tests/ground_bearing.rs";
const MEASURED: &str = "crates/motion/tests/measured.rs";
const ORACLE: &str = "crates/motion/tests/oracle.rs";
const PERFORMANCE: &str = "docs/trust/performance.md";
const PEERS: &str = "docs/trust/peers.md";
const MOTION: &str = "docs/theory/motion.md";

const ROWS: &[Row] = &[
    Row {
        claim: "mode at onset, any γ, k', k, μ",
        against: "the report's inequalities in rational arithmetic",
        independent: "no: the same formulas, another arithmetic",
        count: "1,000,000 random; 100,000 within 3 ulps of each of 15 boundaries",
        result: "0 differ",
        repeat: "`cargo test -p standfast --test exactness`",
        measured: false,
        places: &[
            ("1,000,000", EXACTNESS, "fn a_million_random_points_agree_with_rational_arithmetic()"),
            ("1,000,000", EXACTNESS, "(0..tries(250_000)).for_each(|_| check(random.point()))"),
            ("1,000,000", EXACTNESS, "for seed in 0..4 {"),
            ("100,000", EXACTNESS, "(0..tries(100_000)).for_each(|_| check(boundary.point(&mut random)))"),
            (
                "3",
                EXACTNESS,
                "fn points_within_three_ulps_of_every_boundary_agree_with_rational_arithmetic()",
            ),
            ("15", COMMON, "pub const ALL: [Boundary; 15]"),
            ("0", EXACTNESS, "assert_eq!((ours.mode(), ours.others()), oracle(point)"),
        ],
    },
    Row {
        claim: "mode, uniqueness, the other consistent modes",
        against: "every contact mode tried by the laws of motion",
        independent: "yes: another derivation",
        count: "300,000 random; 20,000 on each of 15 boundaries",
        result: "0 differ",
        repeat: "`cargo test -p standfast --test enumeration`",
        measured: false,
        places: &[
            ("300,000", ENUMERATION, "(0..tries(300_000)).for_each(|_| check(random.point()))"),
            ("20,000", ENUMERATION, "(0..tries(20_000)).for_each(|_| check(boundary.point(&mut random)))"),
            ("15", COMMON, "pub const ALL: [Boundary; 15]"),
            ("0", ENUMERATION, "assert_eq!(closed_form, enumerate(&point)"),
        ],
    },
    Row {
        claim: "any block and wrench: a mode exists, and is the only one below Painlevé's bound",
        against: "the laws of motion, for every mode returned",
        independent: "the theorem is proven on the page of contact; this tests the program",
        count: "200,000 random",
        result: "0 without a mode, 0 with two below the bound",
        repeat: "`cargo test -p standfast --test enumeration`",
        measured: false,
        places: &[
            ("200,000", ENUMERATION, "for _ in 0..tries(200_000) {"),
            (
                "0",
                ENUMERATION,
                "fn the_general_problem_has_an_answer_and_it_is_unique_below_painleves_bound()",
            ),
        ],
    },
    Row {
        claim: "stacks of bodies: a combination of modes exists, the signed count of them is one, and the motion is theirs",
        against: "Lemke's pivots on complementarity at the corners; the equations of each body; the theorem on the count",
        independent: "yes: another formulation; the theorem is proven on the page of joints",
        count: "6,000 and 10,000 and 40,000 random",
        result: "0 differ",
        repeat: "`cargo test -p standfast --test stack`",
        measured: false,
        places: &[
            ("6,000", STACK, "for _ in 0..tries(6_000) {"),
            ("10,000", STACK, "for round in 0..tries(10_000) {"),
            ("40,000", STACK, "for _ in 0..tries(40_000) {"),
            ("0", STACK, "assert_eq!(signed, 1, "),
        ],
    },
    Row {
        claim: "joints of a case: what each carries, which leaves rest first and how, the motion of each body",
        against: "sums block by block; the same bodies and wrenches in pure numbers, as a stack",
        independent: "in part: the sums are added up in the test; the stack is the program's, held by the row above",
        count: "150 and 120 random walls",
        result: "0 differ",
        repeat: "`cargo test -p standfast-cases --test joints`",
        measured: false,
        places: &[
            ("150", JOINTS, "for _ in 0..150 {"),
            ("120", JOINTS, "for _ in 0..120 {"),
            ("0", JOINTS, "assert_eq!(joints.modes().unwrap(), answer.modes(), "),
        ],
    },
    Row {
        claim: "which joint leaves rest first, of drawn numbers",
        against: "the same numbers as a case, decided exactly; two blocks by hand",
        independent: "in part: floating point against exact signs of the same forms",
        count: "150 draws of each of five cases",
        result: "0 differ",
        repeat: "`cargo test -p standfast-cases --test joints_random`",
        measured: false,
        places: &[
            ("150", JOINTS_DRAWN, "Draws::of(&text, None, 150, 3)"),
            ("0", JOINTS_DRAWN, "assert_eq!((first.joint, first.slides), (joint, slides)"),
        ],
    },
    Row {
        claim: "rest and departure on a plan: polygons, feet, discs under forces of any horizontal direction",
        against: "rational arithmetic by another criterion; the plane problem; of cases, where a ray leaves the hull, and records by hand at 4000 places between two points",
        independent: "yes: other criteria; the theorems are proven on the page of directions",
        count: "100,000 random loads, on boundaries and beside them; 40 records",
        result: "0 differ",
        repeat: "`cargo test -p standfast --test footprint`, `cargo test -p standfast-cases --test directions`",
        measured: false,
        places: &[
            ("100,000", FOOTPRINT, "let tries = tries(100_000);"),
            ("40", DIRECTIONS, "for _ in 0..40 {"),
            ("4000", DIRECTIONS, "(0..29 * 4000).find(|step| {"),
            (
                "0",
                FOOTPRINT,
                "assert_eq!(found.rests, expected, \"{points:?} {friction} {wrench:?} {found:?}\");",
            ),
        ],
    },
    Row {
        claim: "the fast kernels, for columns of points",
        against: "exact arithmetic",
        independent: "no: the same formulas, another arithmetic",
        count: "10⁹, of which a fifth within 3 ulps of a boundary",
        result: "0 differ",
        repeat: "`cargo bench -p standfast --bench agreement -- 1000000000`",
        measured: false,
        places: &[
            ("10⁹", PERFORMANCE, "Of 10⁹ points none differed"),
            ("0", PERFORMANCE, "Of 10⁹ points none differed"),
            ("3", PERFORMANCE, "| 200 015 872 | 0 | 114 315 578 | within three ulps of a boundary |"),
        ],
    },
    Row {
        claim: "mode, where one is consistent",
        against: "the physics engines MuJoCo and Rapier, tuned",
        independent: "yes: other codes, made for other ends",
        count: "850",
        result: "96.8 % and 98.6 % agree; more than 5 % from a boundary 97.8 % and 99.2 %",
        repeat: "`python validation/peers/compare.py`",
        measured: false,
        places: &[
            (
                "850",
                PEERS,
                "| all points with one consistent mode | 850 | 48.6 % | 96.8 % | 85.1 % | 98.6 % |",
            ),
            (
                "96.8",
                PEERS,
                "| all points with one consistent mode | 850 | 48.6 % | 96.8 % | 85.1 % | 98.6 % |",
            ),
            (
                "98.6",
                PEERS,
                "| all points with one consistent mode | 850 | 48.6 % | 96.8 % | 85.1 % | 98.6 % |",
            ),
            ("5", PEERS, "| more than 5 % from a boundary | 783 | 49.4 % | 97.8 % | 87.4 % | 99.2 % |"),
            ("97.8", PEERS, "| more than 5 % from a boundary | 783 | 49.4 % | 97.8 % | 87.4 % | 99.2 % |"),
            ("99.2", PEERS, "| more than 5 % from a boundary | 783 | 49.4 % | 97.8 % | 87.4 % | 99.2 % |"),
        ],
    },
    Row {
        claim: "mode, where several are consistent: the one reported",
        against: "the same engines",
        independent: "yes; the answer depends on how contacts give way",
        count: "150",
        result: "0.0 % and 26.0 % agree: not decided",
        repeat: "`python validation/peers/compare.py`, `compliant.py`",
        measured: false,
        places: &[
            (
                "150",
                PEERS,
                "| several consistent modes: the one `standfast` reports | 150 | 0.0 % | 0.0 % | 2.7 % | 26.0 % |",
            ),
            (
                "0.0",
                PEERS,
                "| several consistent modes: the one `standfast` reports | 150 | 0.0 % | 0.0 % | 2.7 % | 26.0 % |",
            ),
            (
                "26.0",
                PEERS,
                "| several consistent modes: the one `standfast` reports | 150 | 0.0 % | 0.0 % | 2.7 % | 26.0 % |",
            ),
        ],
    },
    Row {
        claim: "Goda's pressures, forces, factors",
        against: "the example of his book, second hand; test values of Deltares' coastal structures toolbox",
        independent: "yes: published",
        count: "1; 3",
        result: "1e-4; 3e-4",
        repeat: "`cargo test -p standfast --test waves`",
        measured: false,
        places: &[
            ("1", "validation/goda.toml", "name = \"Goda (2000), worked example\""),
            ("3", "validation/goda.toml", "name = \"vertical wall, base case (no impulsive coefficient)\""),
            ("3", "validation/goda.toml", "name = \"the same, longer and higher waves\""),
            ("3", "validation/goda.toml", "name = \"the same, lower berm\""),
            ("1e-4", WAVES, "assert!(agrees(found, *expected, digits, 1e-4)"),
            ("3e-4", WAVES, "agrees(found, expected, 0.0, 3e-4)"),
        ],
    },
    Row {
        claim: "bearing resistance by `hansen`, without cohesion",
        against: "groundhog",
        independent: "yes: another code of the same formula",
        count: "336",
        result: "1e-8",
        repeat: "`python validation/peers/bearing.py`, `cargo test -p standfast --test ground_bearing`",
        measured: false,
        places: &[
            ("336", BEARING, "assert_eq!(rows, 336)"),
            ("1e-8", BEARING, "assert!((ours / resistance - 1.0).abs() < 1e-8"),
        ],
    },
    Row {
        claim: "a case on a base that gives way",
        against: "a second program, from the formulas",
        independent: "the same rules, another code",
        count: "600 cases, 3800 numbers",
        result: "all agree, within the steps of the second program",
        repeat: "`python validation/peers/base.py 600 PATH/TO/standfast`",
        measured: false,
        places: &[("600", PEERS, "Of 600 cases (seeds 0 to 599"), ("3800", PEERS, "3800 numbers agree")],
    },
    Row {
        claim: "slide under a record, one way",
        against: "pyslammer",
        independent: "yes: another code",
        count: "79",
        result: "0.01 % in the median, 1.1 % at most",
        repeat: "`python validation/peers/newmark.py PATH/TO/standfast`",
        measured: false,
        places: &[
            ("79", PEERS, "79 slides above 1 µm"),
            ("0.01", PEERS, "0.01 % in the median, 0.08 % at 90 %, 1.1 % at most"),
            ("1.1", PEERS, "0.01 % in the median, 0.08 % at 90 %, 1.1 % at most"),
        ],
    },
    Row {
        claim: "events of a motion in time",
        against: "the same rules by scipy's integrator",
        independent: "the same rules, another code",
        count: "300",
        result: "all have the same events, at the same times to 1e-7",
        repeat: "`python validation/peers/motion_events.py PATH/TO/standfast 0 300`",
        measured: false,
        places: &[
            ("300", PEERS, "python motion_events.py PATH/TO/standfast 0 300"),
            ("1e-7", PEERS, "of 300 cases have the same events, at the same times to 1e-7"),
        ],
    },
    Row {
        claim: "motions with rebound",
        against: "the same rules by scipy's integrator",
        independent: "the same rules, another code; bounces followed, not summed",
        count: "322",
        result: "318 have the same events and slides to 4e-9 of B; of the others rounding decides the order of bounces",
        repeat: "`python validation/peers/motion_events.py PATH/TO/standfast 0 400 --rebound`",
        measured: false,
        places: &[
            ("322", PEERS, "322 bounce, 105,500 times in all"),
            ("318", PEERS, "| slide at the end, over B | 318 | 5e-15 | 3e-12 | 4e-9 |"),
            ("4e-9", PEERS, "| slide at the end, over B | 318 | 5e-15 | 3e-12 | 4e-9 |"),
        ],
    },
    Row {
        claim: "rocking under a record: verdict, largest angle, every impact",
        against: "a second program, compiled by numba",
        independent: "the same equation, another method and code",
        count: "4000",
        result: "all verdicts are the same, angles to 6e-11 of that of balance",
        repeat: "`python validation/peers/rocking.py PATH/TO/standfast 4000`",
        measured: false,
        places: &[
            ("4000", PEERS, "The verdicts of 4000 random blocks are all the same"),
            ("6e-11", PEERS, "| largest \\|θ\\|, over α | 2075 | 4e-16 | 2e-14 | 6e-11 |"),
        ],
    },
    Row {
        claim: "a block that must stay at rest does; one that slides once a second",
        against: "MuJoCo; closed form",
        independent: "yes: an engine with regularised friction",
        count: "5 pushes and shakings of 60 s",
        result: "no displacement, where MuJoCo creeps by 52 to 285 mm by its defaults; the slide meets its closed form",
        repeat: "`python validation/peers/creep.py PATH/TO/standfast`",
        measured: false,
        places: &[
            ("52", PEERS, "creeps in MuJoCo by 52 to 285 mm a minute, at its defaults"),
            ("285", PEERS, "creeps in MuJoCo by 52 to 285 mm a minute, at its defaults"),
            ("60", PEERS, "| displacement after 60 s, mm | MuJoCo, defaults |"),
            ("5", PEERS, "| pushed by 0.3, shaken by 0.75 | 213.3 |"),
        ],
    },
    Row {
        claim: "phases of rocking and slide-rocking, each to its end",
        against: "another integrator, in the tests",
        independent: "the same equations, another method",
        count: "300 problems, more than 300 phases",
        result: "1e-9 in time, angle and place",
        repeat: "`cargo test -p standfast-motion --test oracle`",
        measured: false,
        places: &[
            ("300", ORACLE, "for seed in 0..300 {"),
            ("300", ORACLE, "checked.iter().sum::<i32>() > 300"),
            ("1e-9", ORACLE, "assert!((t - end).abs() < 1e-9"),
        ],
    },
    Row {
        claim: "reliability index β",
        against: "OpenTURNS, pystra",
        independent: "yes: other codes",
        count: "3 limit states",
        result: "2 agree where they answer; at the kink of the third none of the other programs ends at the nearest point",
        repeat: "`python validation/peers/reliability.py PATH/TO/standfast`",
        measured: false,
        places: &[
            ("3", PEERS, "| μ − k, normals | 5.1993376 | 5.1993376 | 5.1993376 | 5.1993376 | 5.1993376 |"),
            (
                "3",
                PEERS,
                "| 1 − kγ(1 + k'), Gumbel | 2.0677557 | \"not on the limit state\" | 2.0677557 | 2.0677557 | 2.0677557 |",
            ),
            ("3", PEERS, "| Goda's caisson, four numbers, a kink in H₀' | 1.7807113 |"),
            ("2", PEERS, "At the kink none of the four ends where the nearest point is."),
        ],
    },
    Row {
        claim: "probability of each mode, of Goda's caisson",
        against: "a second program: quadrature, Sobol' points",
        independent: "the same laws, another code and method",
        count: "10 problems of two and three numbers; 7 of four to eight",
        result: "4e-10; inside the interval of 95 %, with the error of the second program",
        repeat: "`python validation/peers/probability.py PATH/TO/standfast`",
        measured: false,
        places: &[
            (
                "10",
                PEERS,
                "| 10 of Goda's caisson, two and three numbers | not rest, SL, other modes above 1e-6 | 4e-10 |",
            ),
            (
                "4e-10",
                PEERS,
                "| 10 of Goda's caisson, two and three numbers | not rest, SL, other modes above 1e-6 | 4e-10 |",
            ),
            ("7", PEERS, "| 7 of the caisson, four to eight numbers"),
            ("95", PEERS, "inside the interval of 95 % and three standard errors of the script"),
        ],
    },
    Row {
        claim: "distance that a cube slides",
        against: "measured slides (ContactNets)",
        independent: "nature, but its friction was fitted on these slides",
        count: "82",
        result: "3.8 % in the median, 14 % at most; fitted on one half, the other is within 4.4 and 3.4 % in the median",
        repeat: "`cargo test -p standfast-motion --test measured`",
        measured: true,
        places: &[
            ("82", MEASURED, "assert_eq!(errors.len(), 82)"),
            ("3.8", MOTION, "3.8 % in the median, 14 % at most"),
            ("14", MOTION, "3.8 % in the median, 14 % at most"),
            ("4.4", MOTION, "is within 4.4 and 3.4 % in the median, 14 % at most"),
            ("3.4", MOTION, "is within 4.4 and 3.4 % in the median, 14 % at most"),
        ],
    },
    Row {
        claim: "where a tossed cube comes to rest",
        against: "measured tosses of the same cube, with the friction of the slides",
        independent: "nature",
        count: "36",
        result: "35 faces right; it travels 0.66 of the measured way in the median, with the reported rebound too",
        repeat: "`cargo test -p standfast-motion --test measured`",
        measured: true,
        places: &[
            ("36", MEASURED, "assert_eq!(all.len(), 36)"),
            ("35", MOTION, "35 final faces right; it travels 0.66 of the way in the median"),
            ("0.66", MOTION, "35 final faces right; it travels 0.66 of the way in the median"),
        ],
    },
    none("a column or block that rocks on a shaking table"),
    none("a caisson in a flume or at sea"),
    none("a footing that is loaded until its ground fails"),
];

/// A claim that no measurement was held against.
const fn none(claim: &'static str) -> Row {
    Row {
        claim,
        against: "measurements",
        independent: "–",
        count: "–",
        result: "none yet",
        repeat: "–",
        measured: false,
        places: &[],
    }
}

/// The table of claims.
pub fn table() -> String {
    let mut table = String::from(
        "| claim | held against | independent? | n | result | how to repeat it |\n|---|---|---|---|---|---|\n",
    );
    for row in ROWS {
        let cells = [row.claim, row.against, row.independent, row.count, row.result];
        for cell in cells {
            let cell = if row.measured { format!("**{cell}**") } else { cell.to_owned() };
            table.push_str(&format!("| {cell} "));
        }
        table.push_str(&format!("| {} |\n", row.repeat));
    }
    table
}

/// The page: the table in its place in the rest.
pub fn page(rest: &str) -> String {
    rest.replace("{table}\n", &table())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    /// The numbers of a cell, without the signs around them.
    fn numbers(cell: &str) -> Vec<&str> {
        cell.split_whitespace()
            .map(|word| word.trim_matches(|c: char| !c.is_alphanumeric()))
            .filter(|word| word.starts_with(|c: char| c.is_ascii_digit()))
            .collect()
    }

    fn stands(file: &str, text: &str) {
        let source =
            fs::read_to_string(crate::root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert!(source.contains(text), "{file} says no longer: {text}");
    }

    #[test]
    fn every_number_of_the_table_stands_where_it_comes_from() {
        for row in ROWS {
            let cells = [row.claim, row.against, row.independent, row.count, row.result];
            let told: Vec<&str> = cells.into_iter().flat_map(numbers).collect();
            for number in &told {
                let known = row.places.iter().any(|(of, _, _)| of == number);
                assert!(known, "{}: {number} comes from nowhere", row.claim);
            }
            for (number, file, text) in row.places {
                assert!(told.contains(number), "{}: {number} is not told", row.claim);
                stands(file, text);
            }
        }
    }

    /// A row or a sentence of the page, and the lines of the output that say so.
    const DECIDED: &[(&str, &[&str])] = &[
        (
            "draws 40,000 vertical\ncaissons under Goda's waves",
            &["caissons under waves: 40000", "statues, racks, columns under an earthquake: 40000"],
        ),
        (
            "| drawn | 24,020 | 15,980 | 40,000 |",
            &["of these, as wide as high or wider: 24020", "of these, higher than wide: 15980"],
        ),
        (
            "| both factors 1.2 or more: it rests | 15,029 of 15,029 | 5012 of 5012 | 9095 of 9095 |",
            &[
                "both factors 1.2 or more: 15029, of which rest 15029",
                "both factors 1.2 or more: 5012, of which rest 5012",
                "both factors 1.2 or more: 9095, of which rest 9095",
            ],
        ),
        (
            "| sliding alone below 1: it slides | 5169 of 5169 | 2285 of 2285 | 1446 of 1446 |",
            &["5169 of 5169, 100.0 %", "2285 of 2285, 100.0 %", "1446 of 1446, 100.0 %"],
        ),
        (
            "| overturning alone below 1: it rocks | none drawn | 68 of 68 | 9854 of 9854 |",
            &["68 of 68, 100.0 %", "9854 of 9854, 100.0 %"],
        ),
        (
            "| both below 1, sliding the lesser: it slides | 1318 of 1318 | 5507 of 5522 | 4177 of 4177 |",
            &["1318 of 1318, 100.0 %", "5507 of 5522, 99.7 %", "4177 of 4177, 100.0 %"],
        ),
        (
            "| both below 1, overturning the lesser: it rocks | none drawn | **221 of 1295** | **9732 of 13,207** |",
            &["221 of 1295, 17.1 %", "9732 of 13207, 73.7 %"],
        ),
        (
            "| the same, but it slide-rocks | – | 839 | 2384 |",
            &["221         839   221 of 1295", "9732        2384   9732 of 13207"],
        ),
        (
            "| the same, but it only slides | – | 235 | 1091 |",
            &["1295     235     221", "13207    1091    9732"],
        ),
        (
            "| overturning below 1, and nothing turns | 1318 of 1318 | 5742 of 6885 | 5268 of 27,238 |",
            &[
                "overturning below 1, and nothing turns: 1318 of 1318",
                "overturning below 1, and nothing turns: 5742 of 6885",
                "overturning below 1, and nothing turns: 5268 of 27238",
            ],
        ),
        ("| the answer is not unique | 0 | 0 | 0 |", &["answer not unique: 0"]),
        ("higher than wide 17.1 % then rock", &["221 of 1295, 17.1 %"]),
        ("statues, racks and columns 73.7 % rock", &["9732 of 13207, 73.7 %"]),
        ("below 1, 86.1 % only slide", &["overturning below 1, and nothing turns: 7060 of 8203, 86.1 %"]),
        (
            "none of these has one",
            &[
                "overturning 1 or more, and yet it turns: 0 of the 15657 that move",
                "overturning 1 or more, and yet it turns: 0 of the 28684 that move",
            ],
        ),
        ("for 98.7 % of the caissons and for all", &["39474 of 40000, 98.7 %", "40000 of 40000, 100.0 %"]),
        (
            "leaves rest at 1.14 to 1.23 times the wave's load, half of them below 1.18",
            &[
                "lesser factor 1.20 to 1.25: 967; they leave rest at 1.14 to 1.23 times the load, half below 1.18",
            ],
        ),
    ];

    /// What the page tells of structures that stand, and the lines of the output of the script.
    const SURVEYED: &[(&str, &[&str])] = &[
        (
            "are asked in 1614 situations, at stated levels of their load, and 42 of them narrowed",
            &[
                "222 structures, 1614 situations",
                "situations                                                         36            28            42",
            ],
        ),
        (
            "in 1140 situations, and 48 of these do not stand**: 46 times the ground gives way, twice a joint moves",
            &[
                "821           200    1140",
                "a joint, the ground or time says otherwise                        2             3            40             1             0             2             0      48",
                "passes both, the ground gives way                                   2             3            40             1             0             0             0      46",
                "passes both, a joint does not                                       0             0             0             0             0             2             0       2",
            ],
        ),
        (
            "in 5 of 42 that pass both.** Narrowed until they just pass, it does in 40 of 42",
            &[
                "  all                                                              24            18            42",
            ],
        ),
        (
            "below 1 in 458 situations; of 446 followed in time 227 hardly move",
            &["72     458", "72     446", "  30 mm and 0.2 of the angle of balance: 227 of 446"],
        ),
        (
            "below 1 in 331 situations, and 145 overturn",
            &[
                "60     331",
                "    overturns                                                       0             0             0             0             0           135            10     145",
            ],
        ),
        (
            "57 of 62 objects below 1.2 m fall",
            &[
                "  0 to 0.6 m              5     2     3        2     0     2        0     0     0        0     0     0",
                "  0.6 to 1.2 m           13     3    10       16     0    16       14     0    14       12     0    12",
            ],
        ),
    ];

    /// The page tells each of these, and the lines stand in the output of the script.
    fn all_stand(told: &[(&str, &[&str])], output: &str) {
        for (words, lines) in told {
            assert!(REST.contains(words), "the page says no longer: {words}");
            for line in *lines {
                stands(output, line);
            }
        }
    }

    #[test]
    fn every_number_of_the_survey_stands_in_the_output_of_the_script() {
        all_stand(SURVEYED, "validation/decision/structures/survey.txt");
    }

    #[test]
    fn every_number_of_the_decisions_stands_in_the_output_of_the_script() {
        all_stand(DECIDED, "validation/decision/decisions.txt");
    }

    #[test]
    fn the_page_has_one_place_for_the_table() {
        assert_eq!(REST.matches("{table}\n").count(), 1);
        assert!(page(REST).contains("| none yet |"));
    }
}
