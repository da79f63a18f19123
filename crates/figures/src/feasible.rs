//! The plane of two quantities of a case: where a target is met, and what binds along the boundary.
//!
//! The set is given column by column, as stretches of the quantity upwards. Neighbouring columns of as many stretches are joined
//! by straight lines; between columns that differ the set ends, halfway.

use standfast::region::{Curve, Strip};

use crate::Figure;
use crate::axes::{Axes, COLUMN, FRAME, LEFT, NUMBER, named};
use crate::below::Words;
use crate::canvas::Canvas;
use crate::ground::shape::through;
use crate::palette::{FEASIBLE, INK, MARK};
use crate::plot::{Piece, View, clip, clip_strips, outline};
use crate::scene::Pen;
use crate::text::Text;

const HEIGHT: f64 = 300.0;
const TOP: f64 = 30.0;
/// Room to the right of the plot, for the last number below it.
const RIGHT: f64 = 26.0;
const LABEL: f64 = 13.0;
const BOUNDARY: Pen = Pen::solid(INK, 1.5);

/// The values of two quantities for which a target is met.
#[derive(Debug, Clone, PartialEq)]
pub struct FeasibleSet<'a> {
    /// Title, the quantities designed, in a line; not markup.
    pub title: &'a str,
    /// Caption, in sentences; not markup.
    pub caption: &'a str,
    /// The quantity to the right; its columns rise.
    pub across: SetAxis<'a>,
    /// The quantity upwards.
    pub up: SetAxis<'a>,
    /// The values upwards that meet the target, for values to the right.
    pub columns: &'a [SetColumn],
}

/// A quantity along an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct SetAxis<'a> {
    /// Name of the quantity; not markup.
    pub words: &'a str,
    /// Its symbol as it stands in mathematics.
    pub symbol: &'a str,
    /// The unit of the numbers; empty for plain ones.
    pub unit: &'a str,
    /// Its value at present.
    pub present: f64,
}

/// The stretches that meet the target at a value of the quantity to the right.
#[derive(Debug, Clone, PartialEq)]
pub struct SetColumn {
    /// That value.
    pub at: f64,
    /// From below.
    pub stretches: Vec<SetStretch>,
    /// If there is none, what binds where the target is nearest to be met, in a word.
    pub none: Option<&'static str>,
}

/// A stretch of values that meet the target.
#[derive(Debug, Clone, PartialEq)]
pub struct SetStretch {
    /// Its lower end.
    pub from: SetEnd,
    /// Its upper end.
    pub to: SetEnd,
}

/// An end of a stretch.
#[derive(Debug, Clone, PartialEq)]
pub struct SetEnd {
    /// The value.
    pub value: f64,
    /// Limit that binds there, in a word; `None` where only the search ended.
    pub by: Option<&'static str>,
}

/// A stretch of the boundary along which the same binds, by its points.
struct Run {
    by: &'static str,
    points: Vec<(f64, f64)>,
}

/// An upright part of the boundary.
struct Step {
    at: f64,
    from: f64,
    to: f64,
    by: Option<&'static str>,
}

impl Step {
    fn along(&self, share: f64) -> f64 {
        self.from + share * (self.to - self.from)
    }
}

/// Draws the set; `None` if it has no boundary.
///
/// ```
/// use standfast_figures::{FeasibleSet, SetAxis, SetColumn, SetEnd, SetStretch, feasible_set};
///
/// // A block slides unless its width is 6 m/μ.
/// let column = |mu: f64| SetColumn {
///     at: mu,
///     stretches: vec![SetStretch {
///         from: SetEnd { value: 6.0 / mu, by: Some("sliding") },
///         to: SetEnd { value: 40.0, by: None },
///     }],
///     none: None,
/// };
/// let figure = feasible_set(&FeasibleSet {
///     title: "Block",
///     caption: "Shaded: the block rests.",
///     across: SetAxis { words: "friction", symbol: "μ", unit: "", present: 0.6 },
///     up: SetAxis { words: "width", symbol: "w", unit: "m", present: 9.0 },
///     columns: &[0.3, 0.45, 0.6, 0.9, 1.2].map(column),
/// });
/// assert!(figure.is_some_and(|figure| figure.svg().contains("Along the boundary: sliding.")));
/// ```
pub fn feasible_set(set: &FeasibleSet<'_>) -> Option<Figure> {
    let (canvas, runs) = drawn(set, (COLUMN, HEIGHT))?;
    Some(framed(canvas, set, &runs, true))
}

/// Draws the set so wide for a screen, which has title and caption beside it, in colours that a page can change.
pub fn feasible_set_on_screen(set: &FeasibleSet<'_>, width: f64) -> Option<Figure> {
    let (canvas, runs) = drawn(set, (width, (0.55 * width).clamp(200.0, 340.0)))?;
    let figure = framed(canvas, set, &runs, false);
    Some(Figure { svg: figure.svg_on_screen(), ..figure })
}

/// The plot, so wide with its margins and so high, with the parts of the boundary that are told.
fn drawn(set: &FeasibleSet<'_>, (width, height): (f64, f64)) -> Option<(Canvas, Vec<Run>)> {
    let window = window(set)?;
    let (across, up) = window.axes();
    let axes = Axes::beside_numbers([across, up], (LEFT, width - RIGHT), TOP, height);
    let mut canvas = Canvas::new(axes);

    let pieces = clip_strips(&set.strips(), &window);
    // One path, for two that touch show a seam.
    canvas.scene.fill(&outline(&axes, &pieces), FEASIBLE);
    let runs = set.runs();
    let steps = set.steps(&window);
    boundary(&mut canvas, &runs, &steps);
    axes.border(&mut canvas.scene, FRAME);
    present(&mut canvas, set);
    let upright = steps.iter().filter_map(|step| {
        Some(Run {
            by: step.by?,
            points: (0..=10).map(|i| (step.at, step.along(f64::from(i) / 10.0))).collect(),
        })
    });
    let runs: Vec<_> = runs.into_iter().chain(upright).collect();
    runs.iter().for_each(|run| name(&mut canvas, run));
    name_set(&mut canvas, &pieces);
    Some((canvas, runs))
}

/// Writes the names of the axes, and where they are wanted title and caption, around the plot.
fn framed(mut canvas: Canvas, set: &FeasibleSet<'_>, runs: &[Run], with_words: bool) -> Figure {
    let axes = canvas.board.axes;
    axes.framed(&mut canvas.scene, &axes.ticks());
    axes.name_above(&mut canvas.scene, &axis_name(&set.up), LEFT, 0.0);
    let name = axis_name(&set.across);
    let below = axes.name_below(&mut canvas.scene, &name);
    let right = axes.area.x1 + RIGHT;
    let edges = (LEFT, (right - LEFT).max(LEFT + name.width));
    let mut binds: Vec<_> = runs.iter().map(|run| run.by).collect();
    binds.sort_unstable();
    binds.dedup();
    let along =
        if binds.is_empty() { String::new() } else { format!(" Along the boundary: {}.", binds.join(", ")) };
    let caption = format!("{}{along}", set.caption);
    let description = format!(
        "Chart of {}, upwards, over {}, to the right. {caption}",
        axis_name(&set.up).plain,
        axis_name(&set.across).plain
    );
    if !with_words {
        let size = (right.max(2.0 * LEFT + name.width).ceil(), (below + 10.0).ceil());
        let (svg, labels) = canvas.scene.finish(size.0, size.1, set.title, &description);
        return Figure { svg, title: set.title.to_owned(), caption, labels, size };
    }
    let words = Words { gap: 5.0, ..Words::verbatim(set.title, &caption) };
    words.figure(canvas.scene, edges, below + 14.0, 16.0, &description)
}

/// Words, symbol and unit of an axis.
fn axis_name(axis: &SetAxis<'_>) -> Text {
    let unit = if axis.unit.is_empty() { String::new() } else { format!(" ({})", axis.unit) };
    let words = named(&axis.words.replace('$', ""));
    Text::new(&format!("{words}, ${}${unit}", axis.symbol.replace('\'', "′")), NUMBER)
}

/// The part of the plane that is shown: all columns, and upwards all ends that are more than ends of the search, and the present
/// values. `None` without such an end.
fn window(set: &FeasibleSet<'_>) -> Option<View> {
    let ends = set.columns.iter().flat_map(|column| &column.stretches).flat_map(|one| [&one.from, &one.to]);
    let real: Vec<f64> = ends.filter(|end| end.by.is_some()).map(|end| end.value).collect();
    let (first, last) = (set.columns.first()?.at, set.columns.last()?.at);
    if real.is_empty() || first >= last {
        return None;
    }
    let shown = || real.iter().copied().chain([set.up.present]);
    let (least, greatest) =
        (shown().fold(f64::INFINITY, f64::min), shown().fold(f64::NEG_INFINITY, f64::max));
    let size = if greatest > least { greatest - least } else { greatest.abs().max(1.0) };
    // Down to zero where that is near.
    let low = if least >= 0.0 && least < 0.3 * greatest { 0.0 } else { least - 0.12 * size };
    let (k_min, k_max) = (first.min(set.across.present), last.max(set.across.present));
    Some(View { k_min, k_max, mu_min: low, mu_max: greatest + 0.12 * size })
}

impl FeasibleSet<'_> {
    /// Neighbouring columns.
    fn pairs(&self) -> impl Iterator<Item = (&SetColumn, &SetColumn)> {
        self.columns.windows(2).map(|pair| (&pair[0], &pair[1]))
    }

    /// The strips of the set between neighbouring columns: those of the first stretches, then those of the second ones.
    fn strips(&self) -> Vec<Strip> {
        let level = |stretch: &SetStretch, from: f64, to: f64| {
            let [lower, upper] =
                [&stretch.from, &stretch.to].map(|end| Curve::Line { slope: 0.0, intercept: end.value });
            Strip { from, to, lower, upper: Some(upper) }
        };
        let mut strips = Vec::new();
        for (left, right) in self.pairs() {
            let (from, to) = (left.at, right.at);
            if left.stretches.len() == right.stretches.len() {
                let joined = left.stretches.iter().zip(&right.stretches).map(|(one, other)| {
                    let lower = through((from, one.from.value), (to, other.from.value));
                    let upper = through((from, one.to.value), (to, other.to.value));
                    Strip { from, to, lower, upper: Some(upper) }
                });
                strips.extend(joined.enumerate());
            } else {
                let middle = (from + to) / 2.0;
                strips.extend(left.stretches.iter().map(|stretch| level(stretch, from, middle)).enumerate());
                strips.extend(right.stretches.iter().map(|stretch| level(stretch, middle, to)).enumerate());
            }
        }
        strips.sort_by_key(|(place, _)| *place);
        strips.into_iter().map(|(_, strip)| strip).collect()
    }

    /// Steps of the boundary between columns that differ.
    fn steps(&self, window: &View) -> Vec<Step> {
        let mut steps = Vec::new();
        for (left, right) in
            self.pairs().filter(|(left, right)| left.stretches.len() != right.stretches.len())
        {
            let both = [left, right].map(|column| -> Vec<(f64, f64)> {
                column.stretches.iter().map(|one| (one.from.value, one.to.value)).collect()
            });
            let mut cuts: Vec<f64> = both.iter().flatten().flat_map(|(from, to)| [*from, *to]).collect();
            cuts.sort_by(f64::total_cmp);
            let inside =
                |side: &[(f64, f64)], y: f64| side.iter().any(|(from, to)| (*from..=*to).contains(&y));
            let parts = cuts.windows(2).filter(|cut| {
                let middle = (cut[0] + cut[1]) / 2.0;
                inside(&both[0], middle) != inside(&both[1], middle)
            });
            let x = (left.at + right.at) / 2.0;
            let by = left.none.or(right.none);
            steps.extend(parts.map(|cut| Step { at: x, from: cut[0], to: cut[1], by }));
        }
        // Within the window.
        steps.retain_mut(|step| {
            (step.from, step.to) = (step.from.max(window.mu_min), step.to.min(window.mu_max));
            step.from < step.to
        });
        steps
    }

    /// The boundary, cut where something else begins to bind.
    fn runs(&self) -> Vec<Run> {
        let most = self.columns.iter().map(|column| column.stretches.len()).max().unwrap_or(0);
        let ends: [fn(&SetStretch) -> &SetEnd; 2] = [|stretch| &stretch.from, |stretch| &stretch.to];
        let mut runs: Vec<Run> = Vec::new();
        for place in 0..most {
            for end in ends {
                let mut open = false;
                for (left, right) in self.pairs() {
                    let same = left.stretches.len() == right.stretches.len();
                    let pair = left.stretches.get(place).zip(right.stretches.get(place)).filter(|_| same);
                    let Some((one, other)) = pair.map(|(one, other)| (end(one), end(other))) else {
                        open = false;
                        continue;
                    };
                    let (Some(by), Some(next)) = (one.by, other.by) else {
                        open = false;
                        continue;
                    };
                    let (from, to) = ((left.at, one.value), (right.at, other.value));
                    match runs.last_mut().filter(|run| open && run.by == by) {
                        Some(run) => run.points.push(to),
                        None => runs.push(Run { by, points: vec![from, to] }),
                    }
                    open = by == next;
                    if !open {
                        runs.push(Run { by: next, points: vec![to] });
                        open = true;
                    }
                }
            }
        }
        runs.retain(|run| run.points.len() > 1);
        runs
    }
}

/// Draws the boundary and keeps labels off it; a dot where something else begins to bind.
fn boundary(canvas: &mut Canvas, runs: &[Run], steps: &[Step]) {
    let axes = canvas.board.axes;
    let mut starts: Vec<(f64, f64)> = Vec::new();
    for run in runs {
        let lines = run.points.windows(2).map(|pair| (through(pair[0], pair[1]), pair[0].0, pair[1].0));
        let arcs = lines.flat_map(|(line, from, to)| clip(line, from, to, &axes.view())).collect();
        canvas.arcs(arcs, BOUNDARY);
        starts.extend(run.points.first());
    }
    canvas.verticals(steps.iter().map(|step| (step.at, step.from, step.to)), BOUNDARY);
    let ends: Vec<_> = runs.iter().filter_map(|run| run.points.last()).collect();
    for start in starts.into_iter().filter(|start| ends.contains(&start)) {
        canvas.scene.dot(axes.at(start.0, start.1), 2.4, INK, None);
    }
}

/// Marks the present values.
fn present(canvas: &mut Canvas, set: &FeasibleSet<'_>) {
    let axes = canvas.board.axes;
    let (x, y) = (set.across.present, set.up.present);
    if axes.shows(x, y) {
        let at = axes.at(x, y);
        canvas.diamond(at);
        let text = Text::new("present", LABEL);
        let place = canvas.board.beside(at, &text, 9.0);
        canvas.place(&text, place, MARK);
    }
}

/// Writes what binds beside its stretch of the boundary, where that is long enough to be told.
fn name(canvas: &mut Canvas, run: &Run) {
    const SHARES: [f64; 7] = [0.5, 0.38, 0.62, 0.25, 0.75, 0.12, 0.88];
    const SHORT: f64 = 24.0;
    let axes = canvas.board.axes;
    let points: Vec<_> = run.points.iter().filter(|(x, y)| axes.shows(*x, *y)).collect();
    let length: f64 = points
        .windows(2)
        .map(|pair| (axes.x(pair[1].0) - axes.x(pair[0].0)).hypot(axes.y(pair[1].1) - axes.y(pair[0].1)))
        .sum();
    if length < SHORT {
        return;
    }
    let text = Text::new(run.by, LABEL);
    let at = |share: f64| {
        let (x, y) = points[((points.len() - 1) as f64 * share) as usize];
        axes.at(*x, *y)
    };
    let clear = SHARES.into_iter().find_map(|share| {
        let place = canvas.board.beside(at(share), &text, 7.0)?;
        canvas.board.clear(&place, 1.0).then_some(place)
    });
    let place = clear.or_else(|| canvas.board.beside(at(0.5), &text, 7.0));
    canvas.place(&text, place, INK);
}

/// Names the set in its largest part.
fn name_set(canvas: &mut Canvas, pieces: &[Piece]) {
    let largest = pieces.chunk_by(|left, right| left.to == right.from).max_by(|one, other| {
        let size = |block: &[Piece]| {
            block.iter().map(|p| (p.to - p.from) * (p.upper.at(p.from) - p.lower.at(p.from))).sum::<f64>()
        };
        size(one).total_cmp(&size(other))
    });
    if let Some(block) = largest {
        canvas.name(block, "target met", 15.0, None);
    }
}
