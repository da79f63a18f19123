//! Draws over a picture for a screen: dots, ellipses of one and two standard deviations, and whiskers of one.

use crate::palette::MARK;
use crate::scene::{Path, Pen, Scene};
use crate::screen::Picture;

/// So many draws are dots: enough for the eye.
const DOTS: usize = 260;
/// Corners of an ellipse.
const CORNERS: usize = 96;

/// Draws over a picture, in its colours, as an SVG document of its size; ellipses and whiskers are those of the draws' means and deviations.
/// Dots stand in a group of the class `sf-draws`. Empty without draws.
pub fn draws_over(picture: &Picture, draws: &[(f64, f64)]) -> String {
    let Some(moments) = Moments::of(draws) else { return String::new() };
    let axes = picture.axes();
    let shows = |(x, y): (f64, f64)| axes.across.shows(x) && axes.up.shows(y);
    let mut scene = Scene::themed();
    scene.open("class=\"sf-draws\"");
    let mut dots = Path::default();
    for (x, y) in draws.iter().take(DOTS).filter(|draw| shows(**draw)).map(|(x, y)| axes.at(*x, *y)) {
        dots.move_to(x, y);
        dots.line_to(x + 0.1, y);
    }
    scene.stroke(&dots, Pen { colour: MARK, width: 3.4, dashes: "0 9" });
    scene.close();
    for deviations in [1.0, 2.0] {
        // Beyond the plot there is nothing to see.
        let mut path = Path::default();
        let mut is_inside = false;
        for i in 0..=CORNERS {
            let place = moments.at(deviations, std::f64::consts::TAU * i as f64 / CORNERS as f64);
            let (x, y) = axes.at(place.0, place.1);
            match (shows(place), is_inside) {
                (true, true) => path.line_to(x, y),
                (true, false) => path.move_to(x, y),
                (false, _) => {}
            }
            is_inside = shows(place);
        }
        scene.stroke(&path, Pen::solid(MARK, 1.1));
    }
    let Moments { x, y, sd, .. } = moments;
    for [from, to] in [[(x - sd.0, y), (x + sd.0, y)], [(x, y - sd.1), (x, y + sd.1)]] {
        let (from, to) = (axes.held(from.0, from.1), axes.held(to.0, to.1));
        scene.line(from, to, Pen::solid(MARK, 1.6));
    }
    let (width, height) = picture.figure.size();
    let description =
        format!("{} draws as dots, with ellipses of one and two standard deviations.", draws.len().min(DOTS));
    scene.finish(width, height, "Draws", &description).0
}

/// Means, standard deviations and covariance.
struct Moments {
    x: f64,
    y: f64,
    sd: (f64, f64),
    covariance: f64,
}

impl Moments {
    /// None of fewer than two places.
    fn of(draws: &[(f64, f64)]) -> Option<Moments> {
        let count = draws.len() as f64;
        let mean =
            |of: &dyn Fn(&(f64, f64)) -> f64, less: f64| draws.iter().map(of).sum::<f64>() / (count - less);
        let (x, y) = (mean(&|draw| draw.0, 0.0), mean(&|draw| draw.1, 0.0));
        let variance = |of: &dyn Fn(f64, f64) -> f64| mean(&|draw| of(draw.0 - x, draw.1 - y), 1.0);
        let sd = (variance(&|a, _| a * a).sqrt(), variance(&|_, b| b * b).sqrt());
        let covariance = variance(&|a, b| a * b);
        (draws.len() > 1 && [x, y, sd.0, sd.1].iter().all(|number| number.is_finite())).then_some(Moments {
            x,
            y,
            sd,
            covariance,
        })
    }

    /// The place on an ellipse of so many deviations at an angle.
    fn at(&self, deviations: f64, angle: f64) -> (f64, f64) {
        let Moments { x, y, sd, covariance } = *self;
        // The lower triangle of the covariance matrix's root.
        let lean = if sd.0 > 0.0 { covariance / sd.0 } else { 0.0 };
        let rest = (sd.1 * sd.1 - lean * lean).max(0.0).sqrt();
        let (sin, cos) = angle.sin_cos();
        (x + deviations * sd.0 * cos, y + deviations * (lean * cos + rest * sin))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of draws that lean, places on the ellipse of one deviation have a distance of one by their covariance.
    #[test]
    fn ellipses_are_those_of_the_covariance() {
        let draws: Vec<(f64, f64)> = (0..400)
            .map(|i| {
                let (a, b) = ((i * 37 % 400) as f64 / 400.0 - 0.5, (i * 91 % 400) as f64 / 400.0 - 0.5);
                (0.5 + 0.1 * a, 0.6 + 0.3 * a + 0.2 * b)
            })
            .collect();
        let moments = Moments::of(&draws).unwrap();
        let (xx, yy, xy) = (moments.sd.0.powi(2), moments.sd.1.powi(2), moments.covariance);
        for i in 0..12 {
            let (x, y) = moments.at(2.0, f64::from(i));
            let (a, b) = (x - moments.x, y - moments.y);
            let squared = (yy * a * a - 2.0 * xy * a * b + xx * b * b) / (xx * yy - xy * xy);
            assert!((squared - 4.0).abs() < 1e-9, "{squared}");
        }
        assert!((moments.sd.0 - 0.1 / 12f64.sqrt()).abs() < 1e-3);
        assert!(Moments::of(&draws[..1]).is_none());
    }
}
