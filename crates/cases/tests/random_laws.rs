//! Laws of case files, as they are written: a body that slides where k is above 0.5, so that what does not rest is the law's share above 0.5,
//! in a closed form written out here; and everything that is refused of them.

use standfast_cases::CaseFile;
use standfast_cases::random::{ChanceRequest, Method, Probability, ProbabilityError};

const LOW: &str = "[point]\ngamma = 0.5\nk_prime = 0\nmu = 0.5\nk = 0.3\n[random]\n";

fn try_answer(random: &str, method: Option<Method>) -> Result<f64, ProbabilityError> {
    let text = format!("{LOW}{random}\n");
    let request = ChanceRequest { method, ..ChanceRequest::default() };
    let found = CaseFile::parse("case.toml", &text).map_err(ProbabilityError::from);
    found.and_then(|file| Probability::of(&file, request)).map(|found| found.situations[0].not_rest.value)
}

fn not_rest(random: &str) -> f64 {
    try_answer(random, None).unwrap_or_else(|error| panic!("{random}\n{}", standfast_cases::report(&error)))
}

fn assert_close(what: &str, value: f64, expected: f64, relative: f64) {
    assert!((value / expected - 1.0).abs() <= relative, "{what}: {value} where {expected} is expected");
}

/// Each law by each way to write it.
#[test]
fn each_law_has_the_share_above_the_boundary() {
    // Of shape 2 the gamma law's tail is (1 + y) e^(−y); mean and deviation 2 s and √2 s.
    let gamma = |y: f64| (1.0 + y) * (-y).exp();
    // I_y(2, 3) = 6y² − 8y³ + 3y⁴ from 0.1 to 0.9, with the mean 0.42 and the variance 0.64 · 6/150.
    let beta = |y: f64| 1.0 - (6.0 * y * y - 8.0 * y.powi(3) + 3.0 * y.powi(4));
    let deviation = (0.64f64 * 0.04).sqrt();
    // The normal share beyond one deviation, as tables have it.
    let beyond_one = 0.158_655_253_931_457_05;
    for (law, expected) in [
        ("{ gamma = { scale = 0.1, shape = 2 } }".to_owned(), gamma(5.0)),
        ("{ gamma = { mean = 0.2, sd = 0.14142135623730951 } }".to_owned(), gamma(5.0)),
        ("{ gamma = { mean = 0.3, sd = 0.14142135623730951, location = 0.1 } }".to_owned(), gamma(4.0)),
        ("{ beta = { alpha = 2, beta = 3, from = 0.1, to = 0.9 } }".to_owned(), beta(0.5)),
        (format!("{{ beta = {{ mean = 0.42, sd = {deviation}, from = 0.1, to = 0.9 }} }}"), beta(0.5)),
        // The mean is the case's, 0.3.
        ("{ exponential = {} }".to_owned(), (-0.5f64 / 0.3).exp()),
        ("{ exponential = { mean = 0.2, location = 0.1 } }".to_owned(), (-4.0f64).exp()),
        ("{ exponential = { scale = 0.1, location = 0.1 } }".to_owned(), (-4.0f64).exp()),
        ("{ gpd = { location = 0.1, scale = 0.1, shape = 0.25 } }".to_owned(), 2f64.powi(-4)),
        ("{ gpd = { location = 0.1, scale = 0.1, shape = 0 } }".to_owned(), (-4.0f64).exp()),
        ("{ discrete = { values = [0.6, 0.2, 0.5], probabilities = [0.125, 0.5, 0.375] } }".to_owned(), 0.125),
        ("{ sample = [0.2, 0.6, 0.7, 0.6, 0.1] }".to_owned(), 0.6),
        ("{ quantiles = { normals = [-1, 1], values = [0.48, 0.5] } }".to_owned(), beyond_one),
        ("{ quantiles = { probabilities = [0.1, 0.5, 0.99], values = [0.46, 0.48, 0.5] } }".to_owned(), 0.01),
        (
            "{ mixture = [{ probability = 0.9, exponential = { mean = 0.1 } }, { probability = 0.1, uniform = { from = 0.4, to = 0.8 } }] }"
                .to_owned(),
            0.9 * (-5.0f64).exp() + 0.1 * 0.75,
        ),
        // The part is cut before it is mixed, the whole after.
        (
            "{ mixture = [{ probability = 0.5, exponential = { mean = 0.1 }, lower = 0.3 }, { probability = 0.5, sample = [0.1] }], upper = 0.9 }"
                .to_owned(),
            {
                let share = |x: f64| 0.5 * (-(x - 0.3) / 0.1f64).exp();
                (share(0.5) - share(0.9)) / (1.0 - share(0.9))
            },
        ),
        ("{ max_of = { count = 3, sample = [0.2, 0.6, 0.1, 0.3] } }".to_owned(), 1.0 - 0.75f64.powi(3)),
        (
            "{ max_of = { count = 2, mixture = [{ probability = 0.5, sample = [0.1] }, { probability = 0.5, exponential = { mean = 0.1 } }] } }"
                .to_owned(),
            1.0 - (1.0 - 0.5 * (-5.0f64).exp()).powi(2),
        ),
    ] {
        assert_close(&law, not_rest(&format!("k = {law}")), expected, 1e-10);
    }
}

/// All methods take them, also as the number that is integrated, and beside others.
#[test]
fn all_methods_take_steps() {
    let random = "mu = { discrete = { values = [0.4, 0.5, 0.6], probabilities = [0.2, 0.5, 0.3] } }\n\
                  k = { sample = [0.3, 0.35, 0.45, 0.55] }\n\
                  k_prime = { uniform = { from = -0.1, to = 0.1 } }";
    // By pairs: 0.45 slides on 0.4, 0.55 on 0.4 and 0.5; the elevation does not matter.
    let expected = 0.25 * 0.2 + 0.25 * 0.7;
    for method in [Method::Integrate, Method::Sobol, Method::MonteCarlo] {
        let found = try_answer(random, Some(method)).unwrap_or_else(|error| panic!("{error}"));
        let allowed = if method == Method::Integrate { 1e-9 } else { 0.05 };
        assert_close(&format!("{method:?}"), found, expected, allowed);
    }
}

/// A matrix is its pairs.
#[test]
fn a_matrix_is_its_pairs() {
    let laws = "k = { normal = { mean = 0.3, sd = 0.04 } }\nmu = { normal = { mean = 0.5, sd = 0.05 } }\n\
                k_prime = { uniform = { from = -0.1, to = 0.1 } }\n[[random.correlation]]\n";
    let matrix =
        "rank = [[1, -0.5, 0.2], [-0.5, 1, 0], [0.2, 0, 1]]\nbetween = [\"k\", \"mu\", \"k_prime\"]\n";
    let pairs = "between = [\"k\", \"mu\"]\nrank = -0.5\n[[random.correlation]]\nbetween = [\"k_prime\", \"k\"]\nrank = 0.2\n";
    let [one, two] = [matrix, pairs].map(|correlation| not_rest(&format!("{laws}{correlation}")));
    assert_eq!(one.to_bits(), two.to_bits());
    // Two normal numbers: k − μ is normal.
    let laws = "k = { normal = { mean = 0.3, sd = 0.04 } }\nmu = { normal = { mean = 0.5, sd = 0.05 } }\n";
    let found = not_rest(&format!(
        "{laws}[[random.correlation]]\nbetween = [\"k\", \"mu\"]\nlinear = [[1, -0.5], [-0.5, 1]]\n"
    ));
    let sd = (0.0016f64 + 0.0025 + 2.0 * 0.5 * 0.04 * 0.05).sqrt();
    assert_close("linear", found, standfast_probability::normal::above(0.2 / sd), 1e-8);
}

/// What is wrong is shown with its value, and what is expected.
#[test]
fn wrong_laws_are_refused() {
    for (random, expected) in [
        ("k = { gamma = { mean = 0.3 } }", "the law gamma of `k` lacks `sd`, a standard deviation, or `cov`"),
        ("k = { gamma = { shape = 2 } }", "the law gamma of `k` lacks scale"),
        ("k = { beta = { mean = 0.3, sd = 0.1 } }", "the law beta of `k` lacks from"),
        (
            "k = { beta = { mean = 0.3, sd = 0.5, from = 0, to = 1 } }",
            "`sd` of the law beta of `k` is 0.5; expected less than √((mean − from)(to − mean))",
        ),
        (
            "k = { exponential = { mean = 0.3, scale = 0.1 } }",
            "has both `mean` and `scale`; expected one of them",
        ),
        (
            "k = { exponential = { rate = 3 } }",
            "the law exponential of `k` has no `rate`; expected mean, scale, location",
        ),
        ("k = { discrete = { values = [0.3, 0.4] } }", "lacks `values` and `probabilities`, two lists"),
        (
            "k = { discrete = { values = [0.3, 0.4], probabilities = [0.3, 0.4] } }",
            "the law discrete of `k`: the probabilities add up to 0.7; expected 1",
        ),
        (
            "k = { discrete = { values = 0.3, probabilities = [1] } }",
            "`values` of the law discrete of `k` is a number; expected a list of numbers",
        ),
        (
            "k = { sample = 0.3 }",
            "the law sample of `k` is a number; expected its values in a list, as [4.1, 4.5, 3.9]",
        ),
        ("k = { sample = [] }", "the law sample of `k`: no values; expected one or more"),
        (
            "k = { sample = [0.3, true] }",
            "a value of the law sample of `k` is true or false; expected a number",
        ),
        (
            "k = { sample = [0.3, \"0.4 m\"] }",
            "`values` of `k` is \"0.4 m\"; expected a number without unit or quotes",
        ),
        ("k = { sample = [0.3, -0.4] }", "0.5 of the law of `k` lies where it is negative"),
        (
            "k = { quantiles = { probabilities = [0.5, 1], values = [0.3, 0.4] } }",
            "a probability of the law quantiles of `k` is 1; expected more than 0 and less than 1",
        ),
        (
            "k = { quantiles = { probabilities = [0.5, 0.9], values = [0.4, 0.3] } }",
            "the law quantiles of `k`: values 0.4 and 0.3 follow each other; expected numbers that rise",
        ),
        (
            "k = { mixture = [{ normal = { mean = 0.3, sd = 0.05 } }] }",
            "the law mixture of `k` lacks `probability` of each part",
        ),
        (
            "k = { mixture = [{ probability = 0.4, sample = [0.3] }, { probability = 0.4, sample = [0.4] }] }",
            "the law mixture of `k`: the probabilities add up to 0.8; expected 1",
        ),
        (
            "k = { mixture = [{ probability = 0.4, mixture = [] }] }",
            "a part of the mixture of `k` has no `mixture`",
        ),
        (
            "k = { mixture = { probability = 0.4 } }",
            "the law mixture of `k` is a table; expected a list of laws, as [{ probability = 0.9",
        ),
        ("k = { max_of = { count = 3 } }", "`k` has no law in `max_of`; expected one law of normal"),
        (
            "k = { paretto = { scale = 1, shape = 2 } }",
            "`k` has no `paretto`; expected normal, lognormal, gumbel",
        ),
        (
            "k = { sample = [0.3, 0.4] }\nmu = { sample = [0.5, 0.6] }\n[[random.correlation]]\nbetween = [\"k\", \"mu\"]\nrank = [[1, 0.3], [0.2, 1]]",
            "row 1 and column 2 of `rank` is 0.3; expected 0.2, as in row 2 and column 1: both sides of the diagonal alike",
        ),
        (
            "k = { sample = [0.3, 0.4] }\nmu = { sample = [0.5, 0.6] }\n[[random.correlation]]\nbetween = [\"k\", \"mu\"]\nrank = [[1, 0.3], [0.3, 0.9]]",
            "row 2 and column 2 of `rank` is 0.9; expected 1, as of every number with itself",
        ),
        (
            "k = { sample = [0.3, 0.4] }\nmu = { sample = [0.5, 0.6] }\n[[random.correlation]]\nbetween = [\"k\", \"mu\"]\nrank = [[1, 0.3]]",
            "`rank` is a list; expected a matrix of 2 rows with 2 numbers each, as many as there are names",
        ),
        (
            "k = { sample = [0.3, 0.4] }\n[[random.correlation]]\nbetween = [\"k\"]\nrank = 0.3",
            "`between` is a list; expected two names or more in a list",
        ),
    ] {
        let error = try_answer(random, None).expect_err(random);
        assert!(error.to_string().contains(expected), "{random}\n{error}\n{expected}");
        let said = standfast_cases::report(&error);
        assert!(said.contains("case.toml:"), "{said}");
    }
}
