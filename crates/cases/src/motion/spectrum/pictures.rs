//! The figure of a spectrum.

use crate::layout::significant;
use standfast_answers::motion::{RockingDistance, RockingEdges, Spectrum, SpectrumPoints, rocking_class};
use standfast_figures::{
    ChanceMark, Figure, SpectrumAxis, SpectrumLines, SpectrumMap, spectrum_lines, spectrum_map,
};
use standfast_motion::spectrum::Slid;

/// Words of the classes of blocks.
const CLASSES: [&str; 7] = [
    "does not rock",
    "$|θ| ≤ 0.1 α$",
    "$≤ 0.25 α$",
    "$≤ 0.5 α$",
    "$≤ α$",
    "beyond $α$, and comes back",
    "overturns",
];

/// The figure.
pub(super) fn figure(spectrum: &Spectrum) -> Figure {
    let title = spectrum.title.as_deref().unwrap_or("A shaking");
    let caption = super::text::words(spectrum, 4);
    let metres = |name: &str| if spectrum.si { format!("{name} (m)") } else { name.to_owned() };
    match &spectrum.points {
        SpectrumPoints::Rocking { sizes, slendernesses, blocks, edges } => {
            let mut occurs = [false; CLASSES.len()];
            blocks.iter().for_each(|block| occurs[rocking_class(block)] = true);
            let size = metres("half diagonal $R$");
            spectrum_map(&SpectrumMap {
                title: &format!("{title}: rocking spectrum"),
                caption: &format!("{caption} α is the angle of balance.{}", located(edges.as_ref())),
                across: axis(&size, sizes, true),
                up: axis("height over width", slendernesses, false),
                above: edges.as_ref().map_or(&[], |edges| &edges.above),
                occurs,
                classes: CLASSES,
            })
        }
        SpectrumPoints::Newmark { ratios, slides } => {
            let line = |value: fn(&Slid) -> f64| -> Vec<(f64, f64)> {
                ratios.iter().copied().zip(slides.iter().map(value)).collect()
            };
            let lines = [
                ("to the left only", line(|slid| slid.left)),
                ("to the right only", line(|slid| slid.right)),
                ("on level ground, the largest", line(|slid| slid.both)),
            ];
            let all = lines.iter().flat_map(|(_, line)| line.iter().map(|point| point.1));
            let positive: Vec<f64> = all.filter(|slide| *slide > 0.0).collect();
            let most = positive.iter().copied().fold(0.0, f64::max);
            let most = if most > 0.0 { most } else { 1.0 };
            // Four decades say what matters; what is less is as good as nothing.
            let least = positive.iter().copied().fold(most / 2.0, f64::min).max(1e-4 * most);
            let name = metres("slide");
            spectrum_lines(&SpectrumLines {
                title: &format!("{title}: Newmark spectrum"),
                caption: &format!("{caption}{}", one_sided(ratios, slides)),
                across: axis("yield acceleration over peak", ratios, false),
                up: SpectrumAxis { name: &name, from: least, to: round_above(most), logarithmic: true },
                lines: &lines,
                shaded: (&[], ""),
                marks: &[],
            })
        }
        SpectrumPoints::Overturning { scales, bodies, stretches } => {
            let line: Vec<(f64, f64)> = scales
                .iter()
                .zip(bodies)
                .map(|(scale, body)| (*scale, if body.overturned { f64::INFINITY } else { body.of_balance }))
                .collect();
            let finite = line.iter().map(|point| point.1).filter(|value| value.is_finite());
            let most = 1.08 * finite.fold(0.1, f64::max);
            spectrum_lines(&SpectrumLines {
                title: &format!("{title}: overturning"),
                caption: &caption,
                across: axis("factor on the shaking", scales, false),
                up: SpectrumAxis {
                    name: "largest $|θ|$ over the angle of balance",
                    from: 0.0,
                    to: most,
                    logarithmic: false,
                },
                lines: &[("where it stands", line)],
                shaded: (stretches, "it overturns"),
                marks: &[ChanceMark { at: 1.0, words: "this shaking" }],
            })
        }
    }
}

/// The next round number: 1, 2 or 5 times a power of ten.
fn round_above(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    [1.0, 2.0, 5.0]
        .map(|step| step * decade)
        .into_iter()
        .find(|round| *round >= value)
        .unwrap_or(10.0 * decade)
}

/// Sentence on where a block on level ground slides as far as one that can only slide to a side: there the lines lie on each other.
fn one_sided(ratios: &[f64], slides: &[Slid]) -> String {
    let same = |one: f64, other: f64| (one - other).abs() <= 0.01 * other;
    for side in ["left", "right"] {
        let of = |slid: &Slid| if side == "left" { slid.left } else { slid.right };
        let differs = slides.iter().rposition(|slid| !same(of(slid), slid.both));
        let from = differs.map_or(0, |last| last + 1);
        if slides.get(from).is_some_and(|slid| slid.both > 0.0) {
            let from = significant(ratios[from], 2);
            return format!(
                " From {from} on a block on level ground slides as far as one that can only slide to the {side}."
            );
        }
    }
    String::new()
}

/// Sentences on the edges between classes.
fn located(edges: Option<&RockingEdges>) -> String {
    let Some(RockingEdges { overturning, others, motions, .. }) = edges else { return String::new() };
    let percent = |distance: &RockingDistance| significant(100.0 * (distance.factor - 1.0), 2);
    format!(
        " {motions} more motions locate the edges: that of overturning to {} % of R and {} of height over width, others to {} % and {}. What \
         is narrower than the grid of blocks may be missed.",
        percent(overturning),
        significant(overturning.step, 2),
        percent(others),
        significant(others.step, 2)
    )
}

fn axis<'a>(name: &'a str, values: &[f64], logarithmic: bool) -> SpectrumAxis<'a> {
    SpectrumAxis { name, from: values[0], to: values[values.len() - 1], logarithmic }
}
