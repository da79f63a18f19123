//! The figure of a spectrum.

use standfast_answers::motion::{Spectrum, SpectrumPoints};
use standfast_figures::{Figure, SpectrumAxis, SpectrumLines, SpectrumMap, spectrum_lines, spectrum_map};
use standfast_motion::spectrum::{Rocked, Slid};

/// Classes of the rotation of a block: the greatest share of the angle of balance of each, and its words.
const CLASSES: [(f64, &str); 7] = [
    (0.0, "does not rock"),
    (0.1, "$|θ| ≤ 0.1 α$"),
    (0.25, "$≤ 0.25 α$"),
    (0.5, "$≤ 0.5 α$"),
    (1.0, "$≤ α$"),
    (f64::INFINITY, "beyond $α$, and comes back"),
    (f64::INFINITY, "overturns"),
];

fn class(block: &Rocked) -> usize {
    if block.overturned {
        return CLASSES.len() - 1;
    }
    CLASSES.iter().position(|(most, _)| block.of_balance <= *most).unwrap_or(CLASSES.len() - 2)
}

/// The figure.
pub(super) fn figure(spectrum: &Spectrum) -> Figure {
    let title = spectrum.title.as_deref().unwrap_or("A shaking");
    let caption = super::text::words(spectrum);
    let metres = |name: &str| if spectrum.si { format!("{name} (m)") } else { name.to_owned() };
    match &spectrum.points {
        SpectrumPoints::Rocking { sizes, slendernesses, blocks } => {
            let cells: Vec<usize> = blocks.iter().map(class).collect();
            let classes = CLASSES.map(|(_, words)| words);
            let size = metres("half diagonal $R$");
            spectrum_map(&SpectrumMap {
                title: &format!("{title}: rocking spectrum"),
                caption: &format!("{caption} α is the angle of balance."),
                across: axis(&size, sizes, true),
                up: axis("height over width", slendernesses, false),
                columns: sizes,
                rows: slendernesses,
                cells: &cells,
                classes,
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
                caption: &caption,
                across: axis("yield acceleration over peak", ratios, false),
                up: SpectrumAxis { name: &name, from: least, to: most, logarithmic: true },
                lines: &lines,
                shaded: (&[], ""),
            })
        }
        SpectrumPoints::Overturning { scales, bodies, stretches } => {
            let line: Vec<(f64, f64)> = scales
                .iter()
                .zip(bodies)
                .map(|(scale, body)| (*scale, if body.overturned { f64::INFINITY } else { body.of_balance }))
                .collect();
            let finite = line.iter().map(|point| point.1).filter(|value| value.is_finite());
            let most = finite.fold(1.05, f64::max);
            spectrum_lines(&SpectrumLines {
                title: &format!("{title}: overturning"),
                caption: &caption,
                across: axis("factor on the shaking", scales, false),
                up: SpectrumAxis {
                    name: "largest $|θ|$ over that of balance",
                    from: 0.0,
                    to: most,
                    logarithmic: false,
                },
                lines: &[("where it stands", line)],
                shaded: (stretches, "it overturns"),
            })
        }
    }
}

fn axis<'a>(name: &'a str, values: &[f64], logarithmic: bool) -> SpectrumAxis<'a> {
    SpectrumAxis { name, from: values[0], to: values[values.len() - 1], logarithmic }
}
