//! Figures of probabilities: the worked examples, and those of the page of theory.

use std::path::Path;
use std::{fs, io};

use standfast::Diagram;
use standfast::initiation::Chart;
use standfast::wave::Goda;
use standfast_cases::CaseFile;
use standfast_cases::Document;
use standfast_cases::random::{ChanceRequest, Effort, Probability, ValueRange};
use standfast_figures::{
    Chance, ChanceLine, ChanceLines, ChanceMark, DesignPoint, DiagramContent, Figure, LineLook, SpectrumAxis,
    chance_lines, diagram_with,
};
use standfast_probability::form::design_point;
use standfast_probability::law::Law;
use standfast_probability::problem::{Outcomes, Pieces, RandomVector};

use crate::gallery::File;

/// Examples shown: the path in `examples`, without extension, the number along which it is asked, and the number of points.
const EXAMPLES: [(&str, Option<&str>, u64); 4] = [
    ("goda-2000-storm", None, POINTS),
    ("statue-random", Some("earthquake.horizontal=1.5 m/s2..2.75 m/s2:11"), POINTS),
    ("probability/plane-random", None, POINTS),
    ("probability/column-records", Some("pga=0.2 g..1.4 g:7"), 1 << 20),
];
/// Enough lives for a picture, and not too many for a test.
const POINTS: u64 = 1 << 18;

/// An example's name, and its figures.
pub type Example = (String, Vec<File>);

/// The figures of the worked examples, by name.
pub fn examples(root: &Path) -> io::Result<Vec<Example>> {
    let mut all = Vec::new();
    for (name, over, points) in EXAMPLES {
        let path = root.join("examples").join(format!("{name}.toml"));
        let text = fs::read_to_string(&path)?;
        let over = over.map(|over| over.parse::<ValueRange>().map_err(io::Error::other)).transpose()?;
        let request =
            ChanceRequest { effort: Effort { points, ..Effort::default() }, ..ChanceRequest::default() };
        let record = |file: &str| {
            let bytes = fs::read(path.with_file_name(file)).map_err(|error| error.to_string())?;
            Ok(String::from_utf8_lossy(&bytes).into_owned())
        };
        let file = CaseFile::read(name, &text, &record).map_err(io::Error::other)?;
        let answer = Probability::along(&file, request, over.as_ref()).map_err(io::Error::other)?;
        let figures = answer.figures(&()).map_err(io::Error::other)?.into_iter();
        let stem = name.rsplit('/').next().unwrap_or(name);
        let files = figures.map(|f| File::drawn(format!("gallery/chance-{stem}{}.svg", f.suffix), f.figure));
        all.push((name.to_owned(), files.collect()));
    }
    Ok(all)
}

/// The figures of theory/probability.md.
pub fn of_theory(root: &Path) -> io::Result<[(&'static str, Figure); 3]> {
    Ok([
        ("gallery/chance-corner.svg", corner()?),
        ("gallery/chance-kink.svg", kink(root)?),
        ("gallery/chance-years.svg", years()?),
    ])
}

/// The point A, nearest of two regions at once.
fn corner() -> io::Result<Figure> {
    let diagram = Diagram::new(0.8, 0.9167).map_err(io::Error::other)?;
    let chart: Chart = *diagram.chart();
    let point =
        |k: f64, mu: f64, label: &str| DesignPoint { k, mu, label: label.to_owned(), mirrored: false };
    let a = chart.points().into_iter().find(|point| point.name.letter() == "A");
    let a = a.map(|a| point(a.k, a.mu, "nearest point of both"));
    let points: Vec<DesignPoint> = [point(0.35, 0.62, "means")].into_iter().chain(a).collect();
    let window = standfast::diagram::Window { k: 1.2, mu: 1.0 };
    Ok(diagram_with(&diagram.into(), &DiagramContent { window: Some(window), points: &points, cloud: &[] }))
}

/// μ(W' − bU) < b_P P of a sea that is certain.
struct Slides {
    thrust: f64,
    uplift: f64,
    weight: f64,
}

impl Outcomes for Slides {
    fn count(&self) -> usize {
        1
    }
    fn line(&self) -> usize {
        0
    }
    fn along(&self, values: &[f64], pieces: &mut Pieces) {
        pieces.push(f64::NEG_INFINITY, self.limit(values), 0);
    }
    fn at(&self, values: &[f64]) -> u64 {
        u64::from(values[0] < self.limit(values))
    }
}

impl Slides {
    fn limit(&self, values: &[f64]) -> f64 {
        let pressed = self.weight - values[2] * self.uplift;
        if pressed > 0.0 { values[1] * self.thrust / pressed } else { f64::INFINITY }
    }
}

/// Distance of sliding from the medians for each height of the wave in deep water: the least lies at a change of formula.
fn kink(root: &Path) -> io::Result<Figure> {
    let text = fs::read_to_string(root.join("examples/goda-2000.toml"))?;
    let lognormal = |mean: f64, cov: f64| Law::lognormal(mean, cov * mean).map_err(io::Error::other);
    let laws =
        vec![lognormal(0.636, 0.15)?.into(), lognormal(0.91, 0.19)?.into(), lognormal(0.77, 0.25)?.into()];
    let inputs = RandomVector::independent(laws);
    let sea = Law::gumbel_of_mean(4.5, 0.9).map_err(io::Error::other)?;
    let sea = standfast_probability::law::Distribution::truncated(sea, 1.0, f64::INFINITY)
        .map_err(io::Error::other)?;
    let goda_at = |height: f64| -> io::Result<Goda> {
        let text = text.replace("deep_water_height = \"6.3 m\"", &format!("deep_water_height = {height}"));
        let case = CaseFile::parse("kink", &text).and_then(|file| file.case()).map_err(io::Error::other)?;
        Ok(case.goda().ok_or_else(|| io::Error::other("a case with waves"))?.goda.clone())
    };
    let mut heights: Vec<f64> = (0..=60).map(|i| 4.2 + 1.2 * f64::from(i) / 60.0).collect();
    // Changes of formula, on both sides to the last bit.
    for pair in heights.clone().windows(2) {
        let (mut low, mut high) = (pair[0], pair[1]);
        let first = goda_at(low)?.formulas;
        if goda_at(high)?.formulas == first {
            continue;
        }
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if goda_at(middle)?.formulas == first { low = middle } else { high = middle }
        }
        heights.extend([low, high]);
    }
    heights.sort_by(f64::total_cmp);
    let mut points = Vec::new();
    for height in heights {
        let goda = goda_at(height)?;
        let slides = Slides { thrust: goda.force, uplift: goda.uplift, weight: 2_318_640.0 };
        let Some(point) = design_point(&inputs, &slides, 1) else { continue };
        let distance = point.beta.hypot(sea.z(height));
        points.push((height, Chance { value: distance, low: distance, high: distance }));
    }
    let least = points.iter().copied().min_by(|a, b| a.1.value.total_cmp(&b.1.value));
    let least = least.ok_or_else(|| io::Error::other("no point slides"))?;
    let words = format!("β = {:.3} at {:.3} m", least.1.value, least.0);
    let lines =
        [ChanceLine { name: "distance of the nearest sliding point", look: LineLook::Answer, points }];
    let axis = |name, from, to| SpectrumAxis { name, from, to, logarithmic: false };
    Ok(chance_lines(&ChanceLines {
        title: "Why the design point lies on a kink: Goda's caisson",
        caption: "The distance from the medians, in standard normals, of the nearest point at which the caisson slides, if the wave in deep water has one height or another. Where breaking begins to limit the largest wave the force stops rising, and the distance has a corner there: no gradient is zero at the least.",
        across: axis("wave height in deep water (m)", 4.2, 5.4),
        up: axis("distance", 1.6, 2.4),
        lines: &lines,
        marks: &[ChanceMark { at: least.0, words: &words }],
    }))
}

/// A friction drawn once and one drawn each year, over the years of a life.
fn years() -> io::Result<Figure> {
    let lines = ["life", "year"].map(|every| -> io::Result<Vec<(f64, Chance)>> {
        let text = format!(
            "[point]\ngamma = 0.8\nk_prime = 0.9167\n[random]\nmu = {{ lognormal = {{ mean = 0.6, cov = 0.15 }}, every = \"{every}\" }}\n\
             k = {{ gumbel = {{ mean = 0.3, sd = 0.06 }}, lower = 0, every = \"year\" }}\n"
        );
        [1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 50.0, 75.0, 100.0]
            .into_iter()
            .map(|years| {
                let request = ChanceRequest { years: Some(years), ..ChanceRequest::default() };
                let file = CaseFile::parse("years", &text).map_err(io::Error::other)?;
                let answer = Probability::of(&file, request).map_err(io::Error::other)?;
                let life = answer.situations.first().and_then(|chances| chances.life.as_ref());
                let p = life.ok_or_else(|| io::Error::other("a life"))?.not_rest;
                Ok((years, Chance { value: p.value, low: p.value, high: p.value }))
            })
            .collect()
    });
    let [once, yearly] = lines;
    let lines = [
        ChanceLine { name: "friction drawn once", look: LineLook::Answer, points: once? },
        ChanceLine { name: "friction drawn each year", look: LineLook::Other, points: yearly? },
    ];
    let axis = |name, from, to| SpectrumAxis { name, from, to, logarithmic: false };
    Ok(chance_lines(&ChanceLines {
        title: "What is drawn once must not be drawn yearly",
        caption: "A point of the report's plane, γ = 0.8 and k′ = 0.9167, under the largest force of each year. A friction drawn anew each year gives a weak base fifty chances to come; a real one is weak from the first year on, or never.",
        across: axis("years", 0.0, 100.0),
        up: axis("probability that it ever moves", 0.0, 0.4),
        lines: &lines,
        marks: &[ChanceMark { at: 50.0, words: "50 years" }],
    }))
}
