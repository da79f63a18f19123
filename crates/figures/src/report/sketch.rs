//! Figs. 2.1 and 4.1: the block, its base, the force and the reactions.

use crate::Figure;
use crate::margins;
use crate::palette::{FAINT, INK, MARK, PUSH, REST};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

const WIDTH: f64 = 496.0;
const BASE: f64 = 336.0;
/// Half width and half height of the block on the page.
const B: f64 = 78.0;
const H: f64 = 128.0;
/// The centre of mass.
const C: (f64, f64) = (226.0, BASE - H);
const THIN: Pen = Pen::solid(INK, 0.8);
const CENTRE: Pen = Pen { colour: FAINT, width: 0.7, dashes: "9 2.5 2 2.5" };

/// The sketch, with the force above or below the centre of mass.
pub(super) fn figure(heading: &str, caption: &str, above: bool, mut scene: Scene) -> Figure {
    block(&mut scene);
    axes(&mut scene);
    dimensions(&mut scene);
    force(&mut scene, above);
    reactions(&mut scene);
    let mut words = vec![Text::verbatim(heading, 13.0)];
    words.extend(margins::words(caption, 13.0));
    let below = margins::paragraph(&mut scene, &words, (16.0, WIDTH - 16.0), BASE + 84.0, 13.0);
    let (place, sign) = if above { ("above", "h = k′H") } else { ("below", "|h| = |k′|H") };
    let description = format!(
        "A rectangular block, 2B wide and 2H high, on a rough base. Its lower corners are O, left, and O′, right. \
         The horizontal force F points left and acts at {sign} {place} the centre of mass C. The axes at C are x to \
         the right, y upwards, θ counter-clockwise. The base reacts with f_x to the right and f_y upwards, ξ to the \
         right of C."
    );
    let size = (WIDTH, (below + 10.0).ceil());
    let title = format!("{} {caption}", heading.trim());
    let (svg, labels) = scene.finish(size.0, size.1, &title, &description);
    Figure { svg, title, caption: String::new(), labels, size }
}

fn label(scene: &mut Scene, markup: &str, x: f64, y: f64) {
    let text = Text::new(markup, 15.0);
    scene.text_in(&text, &Rect::around(x, y, text.width, text.height()), INK);
}

fn block(scene: &mut Scene) {
    let (left, right, top) = (C.0 - B, C.0 + B, BASE - 2.0 * H);
    let mut body = Path::through(&[(left, BASE), (left, top), (right, top), (right, BASE)]);
    body.close();
    scene.fill(&body, REST);
    scene.line((60.0, BASE), (420.0, BASE), Pen::solid(INK, 1.4));
    let mut ground = Path::default();
    for i in 0..45 {
        let x = 66.0 + 8.0 * f64::from(i);
        ground.move_to(x, BASE);
        ground.line_to(x - 8.0, BASE + 8.0);
    }
    scene.stroke(&ground, Pen::solid(FAINT, 0.7));
    scene.stroke(&body, Pen::solid(INK, 1.6));
    label(scene, "$O$", left - 14.0, BASE - 11.0);
    label(scene, "$O′$", right + 15.0, BASE - 11.0);
}

fn axes(scene: &mut Scene) {
    let (x, y) = C;
    scene.line((x - B - 14.0, y), (x + B + 14.0, y), CENTRE);
    scene.line((x, y - H - 14.0), (x, y + H), CENTRE);
    scene.arrow(C, (x + 50.0, y), Pen::solid(INK, 1.1));
    scene.arrow(C, (x, y - 50.0), Pen::solid(INK, 1.1));
    scene.dot(C, 2.8, INK, None);
    label(scene, "$C$", x - 11.0, y + 12.0);
    label(scene, "$x$", x + 54.0, y + 11.0);
    label(scene, "$y$", x - 11.0, y - 48.0);
    // A quarter of a circle, counter-clockwise, as one cubic.
    let (r, c) = (27.0, 27.0 * 0.5523);
    let mut arc = Path::default();
    arc.move_to(x + r, y - 3.0);
    arc.cubic_to(x + r, y - c, x + c + 3.0, y - r + 2.0, x + 8.0, y - r + 1.0);
    scene.stroke(&arc, Pen::solid(INK, 1.0));
    scene.arrowhead((x + 3.0, y - r + 1.2), (-1.0, 0.06), INK);
    label(scene, "$θ$", x + 31.0, y - 28.0);
}

fn dimensions(scene: &mut Scene) {
    let (left, right, top) = (C.0 - B, C.0 + B, BASE - 2.0 * H);
    let (above, beside) = (top - 40.0, left - 52.0);
    for x in [left, right] {
        scene.line((x, top - 5.0), (x, above - 5.0), Pen::solid(FAINT, 0.6));
    }
    for y in [top, BASE] {
        let from = if y == BASE { left - 26.0 } else { left - 5.0 };
        scene.line((from, y), (beside - 5.0, y), Pen::solid(FAINT, 0.6));
    }
    scene.arrow((C.0 + 16.0, above), (right, above), THIN);
    scene.arrow((C.0 - 16.0, above), (left, above), THIN);
    label(scene, "$2B$", C.0, above);
    scene.arrow((beside, C.1 - 13.0), (beside, top), THIN);
    scene.arrow((beside, C.1 + 13.0), (beside, BASE), THIN);
    label(scene, "$2H$", beside, C.1);
}

fn force(scene: &mut Scene, above: bool) {
    let right = C.0 + B;
    let y = C.1 + if above { -0.56 * H } else { 0.5 * H };
    let strong = Pen::solid(MARK, 2.0);
    scene.arrow((right + 74.0, y), (right + 1.5, y), strong);
    label(scene, "$F$", right + 52.0, y + if above { -14.0 } else { 14.0 });
    let beside = right + 96.0;
    for level in [y, C.1] {
        let from = if level == y { right + 79.0 } else { right + 18.0 };
        scene.line((from, level), (beside + 5.0, level), Pen::solid(FAINT, 0.6));
    }
    let middle = (y + C.1) / 2.0;
    scene.arrow((beside, middle), (beside, y), THIN);
    scene.arrow((beside, middle), (beside, C.1), THIN);
    let text = Text::new(if above { "$h = k′H$" } else { "$|h| = |k′|H$" }, 15.0);
    let rect = Rect::around(beside + 9.0 + text.width / 2.0, middle, text.width, text.height());
    scene.text_in(&text, &rect, INK);
}

fn reactions(scene: &mut Scene) {
    let x = C.0 + 40.0;
    let strong = Pen::solid(PUSH, 2.0);
    scene.arrow((x, BASE + 58.0), (x, BASE + 2.0), strong);
    label(scene, "$f_y$", x + 14.0, BASE + 46.0);
    scene.arrow((x + 14.0, BASE + 22.0), (x + 74.0, BASE + 22.0), strong);
    label(scene, "$f_x$", x + 86.0, BASE + 23.0);
    for end in [C.0, x] {
        let from = BASE + if end == x { 61.0 } else { 3.0 };
        scene.line((end, from), (end, BASE + 76.0), Pen::solid(FAINT, 0.6));
    }
    let y = BASE + 71.0;
    scene.arrow(((C.0 + x) / 2.0, y), (x, y), THIN);
    scene.arrow(((C.0 + x) / 2.0, y), (C.0, y), THIN);
    label(scene, "$ξ$", C.0 - 10.0, y);
}
