//! The strip of strengths: which factors on the loads overturn a body.

use crate::Figure;
use crate::number::significant;
use crate::palette::{FAINT, INK, MARK, REST};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

const HEIGHT: f64 = 54.0;
const TOP: f64 = 17.0;
const CELL: f64 = 15.0;
const LABEL: f64 = 12.5;

/// A strip, so wide, of factors that rise, each with whether the body overturns; the loads as they are stand among them under 1.
pub fn strength_strip(tried: &[(f64, bool)], width: f64) -> Figure {
    let mut scene = Scene::themed();
    let left = 8.0;
    let cell = (width - 2.0 * left) / tried.len().max(1) as f64;
    let mut last = f64::NEG_INFINITY;
    for (i, &(factor, overturns)) in tried.iter().enumerate() {
        let x0 = left + cell * i as f64;
        let rect = Rect { x0, y0: TOP, x1: x0 + cell, y1: TOP + CELL };
        scene.fill(&Path::rectangle(&rect), if overturns { MARK } else { REST });
        scene.stroke(&Path::rectangle(&rect), Pen::solid(FAINT, 0.5));
        let (x, _) = rect.centre();
        if factor == 1.0 {
            scene.line((x, TOP - 4.0), (x, TOP + CELL + 4.0), Pen::solid(INK, 2.0));
        }
        // Round factors are named where there is room, and the loads as they are always.
        let is_round =
            (factor * 10.0 - (factor * 10.0).round()).abs() < 1e-9 || i == 0 || i + 1 == tried.len();
        let text = Text::verbatim(&format!("{} ×", significant(factor, 3)), LABEL);
        let from = (x - text.width / 2.0).clamp(0.0, (width - text.width).max(0.0));
        let near = |other: f64| {
            tried.iter().position(|one| one.0 == 1.0).is_some_and(|one| {
                let middle = left + cell * (one as f64 + 0.5);
                other != 1.0 && (x - middle).abs() < text.width + 8.0
            })
        };
        if is_round && from > last + 6.0 && !near(factor) {
            scene.text(&text, from, TOP + CELL + 17.0, INK);
            last = from + text.width;
        }
    }
    let count = tried.iter().filter(|one| one.1).count();
    let words = format!("Of {} factors on the loads {count} overturn it (filled).", tried.len());
    scene.text(&Text::verbatim(&words, LABEL), left, TOP - 6.0, INK);
    let title = "Strength of the loads".to_owned();
    let (svg, labels) = scene.finish(width, HEIGHT, &title, &words);
    Figure { svg, title, caption: String::new(), labels, size: (width, HEIGHT) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each factor that overturns is filled, and the loads as they are have a line.
    #[test]
    fn factors_that_overturn_are_filled() {
        let tried = [(0.5, false), (0.9, false), (1.0, false), (1.1, true), (2.0, true)];
        let strip = strength_strip(&tried, 400.0);
        assert_eq!(strip.svg().matches("fill=\"var(--mark").count(), 2);
        assert!(strip.svg().contains("Of 5 factors on the loads 2 overturn it"));
        let labels: Vec<_> = strip.labels().iter().map(|label| label.text.as_str()).collect();
        assert!(
            labels.contains(&"1 ×") && labels.contains(&"0.5 ×") && labels.contains(&"2 ×"),
            "{labels:?}"
        );
    }
}
