//! Areas of a plane in which a function of two quantities exceeds a level: where do its answers change?
//!
//! The function is known on a grid and is asked, one place at a time, for half as many places again at most. First cells are cut in four
//! along features that are one place of the grid wide, as far as these go; then the edges that part two classes are located by halving, or
//! by interpolation where the function is finite and above zero; then the areas are traced through the places found.
//!
//! Places are whole numbers, [`UNITS`] to a cell of the grid, so that what two cells share is the same to the last bit.

use std::collections::{BTreeMap, BTreeSet};

/// Units to a cell of the grid: cells are cut in four once, and edges located to a few units.
const UNITS: u32 = 64;
/// Cells are cut in four as long as they are no smaller.
const SMALLEST: u32 = UNITS;
/// Edges are located to so many units where there is enough to spend, and to so many where there is little.
const FINEST: u32 = 2;
const COARSEST: u32 = UNITS / 2;
/// The share of what may be asked that is for cutting cells.
const FOR_CELLS: f64 = 0.5;
/// The share of the rest that is for the edge of the highest level.
const FOR_THE_HIGHEST: f64 = 0.9;
/// Number of times that an outline is drawn straight, as far as its stretches let it, if it passes so many: an island would shrink.
const STRAIGHTENED: usize = 24;
const LONG: usize = 14;

/// A place in units, to the right and upwards.
pub(super) type Place = (u32, u32);

/// A closed line through places in units, with the area at its left.
pub(super) type Loop = Vec<(f64, f64)>;

/// Areas above each level.
pub(super) struct Areas {
    /// Outlines of the area above each level; where an outline lies in another it is that of a hole.
    pub above: Vec<Vec<Loop>>,
    /// Cells of the grid to which the edge of the highest level is located, and to which others are.
    pub located: [f64; 2],
}

/// A cell: its lower left corner and its size.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Cell {
    x: u32,
    y: u32,
    size: u32,
}

impl Cell {
    /// The corners, counter-clockwise from the lower left.
    fn corners(self) -> [Place; 4] {
        let Cell { x, y, size } = self;
        [(x, y), (x + size, y), (x + size, y + size), (x, y + size)]
    }

    fn centre(self) -> Place {
        (self.x + self.size / 2, self.y + self.size / 2)
    }

    /// Middles of the sides, and the centre.
    fn cuts(self) -> [Place; 5] {
        let [a, b, c, d] = self.corners();
        [middle(a, b), middle(b, c), middle(c, d), middle(d, a), self.centre()]
    }

    fn quarters(self) -> [Cell; 4] {
        let (size, (x, y)) = (self.size / 2, self.centre());
        [(self.x, self.y), (x, self.y), (x, y), (self.x, y)].map(|(x, y)| Cell { x, y, size })
    }
}

fn middle(a: Place, b: Place) -> Place {
    (u32::midpoint(a.0, b.0), u32::midpoint(a.1, b.1))
}

/// Stretch of an upright or level line whose ends are of two classes.
type Stretch = (Place, Place);

fn length((a, b): Stretch) -> u32 {
    a.0.abs_diff(b.0) + a.1.abs_diff(b.1)
}

/// Place at a share of a stretch.
fn at((a, b): Stretch, share: f64) -> (f64, f64) {
    let between = |from: u32, to: u32| f64::from(from) + share * (f64::from(to) - f64::from(from));
    (between(a.0, b.0), between(a.1, b.1))
}

/// Share of a stretch at which a straight line crosses the line that it lies on.
fn crossing((a, b): Stretch, [from, to]: [(f64, f64); 2]) -> Option<f64> {
    let [a, b] = [a, b].map(|(x, y)| (f64::from(x), f64::from(y)));
    let turned = |(x, y): (f64, f64)| if a.1 == b.1 { (x, y) } else { (y, x) };
    let [a, b, from, to] = [a, b, from, to].map(turned);
    let rise = to.1 - from.1;
    let x = from.0 + (to.0 - from.0) * (a.1 - from.1) / rise;
    (rise != 0.0).then(|| (x - a.0) / (b.0 - a.0))
}

/// The function, as far as it is known.
struct Known<'a, F> {
    levels: &'a [f64],
    ask: F,
    by_row: BTreeMap<(u32, u32), f64>,
    by_column: BTreeMap<(u32, u32), f64>,
    left: usize,
}

impl<E, F: FnMut(&[Place]) -> Result<Vec<f64>, E>> Known<'_, F> {
    fn put(&mut self, (x, y): Place, value: f64) {
        self.by_row.insert((y, x), value);
        self.by_column.insert((x, y), value);
    }

    fn value(&self, (x, y): Place) -> Option<f64> {
        self.by_row.get(&(y, x)).copied()
    }

    /// Number of levels that the function exceeds; none where it is not known.
    fn class(&self, place: Place) -> Option<usize> {
        self.value(place).map(|value| self.levels.iter().filter(|level| value > **level).count())
    }

    /// Asks for all places, if there is enough to spend and so much is kept; false if not.
    fn get(&mut self, places: BTreeSet<Place>, kept: usize) -> Result<bool, E> {
        let new: Vec<Place> = places.into_iter().filter(|place| self.value(*place).is_none()).collect();
        if new.len() + kept > self.left {
            return Ok(false);
        }
        self.left -= new.len();
        let values = (self.ask)(&new)?;
        new.into_iter().zip(values).for_each(|(place, value)| self.put(place, value));
        Ok(true)
    }

    /// Known places from one end of a side to the other, the latter left out.
    fn side(&self, a: Place, b: Place) -> Vec<Place> {
        let mut places: Vec<Place> = if a.1 == b.1 {
            self.by_row.range((a.1, a.0.min(b.0))..=(a.1, a.0.max(b.0))).map(|((y, x), _)| (*x, *y)).collect()
        } else {
            let column = (a.0, a.1.min(b.1))..=(a.0, a.1.max(b.1));
            self.by_column.range(column).map(|(place, _)| *place).collect()
        };
        if a > b {
            places.reverse();
        }
        places.pop();
        places
    }

    /// Known places around a cell, counter-clockwise.
    fn around(&self, cell: Cell) -> Vec<Place> {
        let [a, b, c, d] = cell.corners();
        [(a, b), (b, c), (c, d), (d, a)].into_iter().flat_map(|(a, b)| self.side(a, b)).collect()
    }

    /// True if the highest level is exceeded at a place and not at its neighbours at both sides, or the other way round.
    fn alone(&self, (x, y): Place, step: u32) -> bool {
        let top = |place: Place| self.class(place).map(|class| class == self.levels.len());
        let pair = |one: Option<Place>, two: Place| {
            let (here, one, two) = (top((x, y)), one.and_then(top), top(two));
            one.is_some() && one == two && one != here
        };
        pair(x.checked_sub(step).map(|x| (x, y)), (x + step, y))
            || pair(y.checked_sub(step).map(|y| (x, y)), (x, y + step))
    }

    /// True if a cell may hold more than its corners tell.
    fn is_doubtful(&self, cell: Cell) -> bool {
        let corners = cell.corners();
        let classes = corners.map(|corner| self.class(corner));
        let top = classes.map(|class| class == Some(self.levels.len()));
        let mixed = top.iter().any(|over| *over != top[0]);
        // A middle that another cell was asked for and that is of no class from one end's to the other's.
        let bulges = (0..4).any(|i| {
            let (a, b) = (corners[i], corners[(i + 1) % 4]);
            let (low, high) = (classes[i].min(classes[(i + 1) % 4]), classes[i].max(classes[(i + 1) % 4]));
            let class = self.class(middle(a, b));
            class.is_some() && (class < low || class > high)
        });
        let saddle = top[0] == top[2] && top[1] == top[3] && top[0] != top[1];
        bulges || saddle || (mixed && corners.into_iter().any(|corner| self.alone(corner, cell.size)))
    }

    /// Cuts cells in four where they may hold more than their corners tell.
    fn cut(&mut self, cells: &mut BTreeSet<Cell>) -> Result<(), E> {
        let kept = (self.left as f64 * (1.0 - FOR_CELLS)) as usize;
        let mut size = UNITS;
        while size >= SMALLEST {
            let doubtful: Vec<Cell> =
                cells.iter().copied().filter(|cell| cell.size == size && self.is_doubtful(*cell)).collect();
            if doubtful.is_empty() {
                size /= 2;
                continue;
            }
            let places = doubtful.iter().flat_map(|cell| cell.cuts()).collect();
            if !self.get(places, kept)? {
                break;
            }
            for cell in doubtful {
                cells.remove(&cell);
                cells.extend(cell.quarters());
            }
        }
        Ok(())
    }

    /// True if halving a stretch is all that can be done: at an end the function is zero, or has no bound.
    fn jumps(&self, (a, b): Stretch) -> bool {
        [a, b].into_iter().any(|end| !self.value(end).is_some_and(|value| value > 0.0 && value.is_finite()))
    }

    /// Stretches between neighbouring places around cells that are of two classes.
    fn stretches(&self, cells: &BTreeSet<Cell>) -> Vec<Stretch> {
        let mut found = BTreeSet::new();
        for cell in cells {
            let around = self.around(*cell);
            for (i, &a) in around.iter().enumerate() {
                let b = around[(i + 1) % around.len()];
                if self.class(a) != self.class(b) {
                    found.insert((a.min(b), a.max(b)));
                }
            }
        }
        found.into_iter().collect()
    }

    /// Place in a stretch to be asked for next.
    fn within(&self, (a, b): Stretch, round: usize, unit: u32) -> Place {
        let parts = length((a, b)) / unit;
        let mut part = parts / 2;
        if let (Some(from), Some(to)) = (self.value(a), self.value(b))
            && round < 2
            && !self.jumps((a, b))
            && let Some(level) = self.levels.iter().find(|level| (from > **level) != (to > **level))
        {
            part = ((level - from) / (to - from) * f64::from(parts)).round() as u32;
        }
        let along = part.clamp(1, parts - 1) * unit;
        if a.1 == b.1 { (a.0 + along, a.1) } else { (a.0, a.1 + along) }
    }

    /// About as many places as it takes to shorten stretches to so many units.
    fn cost(&self, stretches: &[Stretch], unit: u32) -> f64 {
        // Interpolation meets a level at once, and then its other side; sometimes it takes more.
        let of = |stretch: &Stretch| {
            let halvings = f64::from((length(*stretch) / unit).max(1)).log2();
            if self.jumps(*stretch) { halvings } else { halvings.min(2.2) }
        };
        1.1 * stretches.iter().map(of).sum::<f64>()
    }

    /// True if the highest level is met in a stretch.
    fn is_highest(&self, (a, b): Stretch) -> bool {
        let [a, b] = [a, b].map(|end| self.class(end) == Some(self.levels.len()));
        a != b
    }

    /// Locates edges with a share of what may be asked for, those of the highest level or others; gives the longest stretch that is left.
    fn locate(&mut self, cells: &BTreeSet<Cell>, highest: bool, share: f64) -> Result<u32, E> {
        let mut open = self.stretches(cells);
        open.retain(|stretch| self.is_highest(*stretch) == highest);
        let mut unit = FINEST;
        while unit < COARSEST && self.cost(&open, unit) > share * self.left as f64 {
            unit *= 2;
        }
        for round in 0.. {
            let (wide, narrow): (Vec<Stretch>, Vec<Stretch>) =
                open.iter().partition(|stretch| length(**stretch) > unit);
            let middles: Vec<Place> = wide.iter().map(|stretch| self.within(*stretch, round, unit)).collect();
            if wide.is_empty() || !self.get(middles.iter().copied().collect(), 0)? {
                break;
            }
            let halves = wide.into_iter().zip(middles).flat_map(|((a, b), c)| [(a, c), (c, b)]);
            open = narrow;
            open.extend(halves.filter(|(a, b)| self.class(*a) != self.class(*b)));
            open.retain(|stretch| self.is_highest(*stretch) == highest);
        }
        Ok(open.into_iter().map(length).max().unwrap_or(unit))
    }

    /// Cells with what is known around them; for the centres of those whose corners go to and fro it is asked.
    fn rings(&mut self, cells: &BTreeSet<Cell>) -> Result<Vec<Ring>, E> {
        let mut rings: Vec<Ring> = cells.iter().map(|cell| self.ring(*cell)).collect();
        let count = self.levels.len();
        let twofold = rings.iter().filter(|ring| (1..=count).any(|level| ring.turns(level).len() > 2));
        let centres = twofold.map(|ring| ring.centre).collect();
        self.get(centres, 0)?;
        rings.iter_mut().for_each(|ring| ring.of_centre = self.class(ring.centre).unwrap_or(0));
        Ok(rings)
    }

    fn ring(&self, cell: Cell) -> Ring {
        let places = self.around(cell);
        let classes = places.iter().map(|place| self.class(*place).unwrap_or(0)).collect();
        Ring { places, classes, centre: cell.centre(), of_centre: 0 }
    }

    /// Share of a stretch at which a level is met.
    fn share(&self, (a, b): Stretch, level: usize) -> f64 {
        match (self.value(a), self.value(b)) {
            (Some(from), Some(to)) if a != b && !self.jumps((a, b)) => {
                (self.levels[level - 1] - from) / (to - from)
            }
            _ => 0.5,
        }
    }

    /// Places where an outline meets its stretches. Where the function jumps any place will do: the straightest is taken, and the same by
    /// the lower levels that are met there too.
    fn places(&self, outline: &[Stretch], level: usize, taken: &mut BTreeMap<Stretch, f64>) -> Loop {
        let mut shares: Vec<f64> = outline
            .iter()
            .map(|stretch| taken.get(stretch).copied().unwrap_or_else(|| self.share(*stretch, level)))
            .collect();
        let count = outline.len();
        let free: Vec<usize> = (0..count)
            .filter(|i| outline[*i].0 != outline[*i].1 && self.jumps(outline[*i]))
            .filter(|i| !taken.contains_key(&outline[*i]))
            .collect();
        for _ in 0..if count < LONG { 0 } else { STRAIGHTENED } {
            for &i in &free {
                let [before, after] = [(i + count - 1) % count, (i + 1) % count];
                let ends = [before, after].map(|j| at(outline[j], shares[j]));
                if let Some(share) = crossing(outline[i], ends) {
                    shares[i] = share.clamp(0.05, 0.95);
                }
            }
        }
        taken.extend(free.into_iter().map(|i| (outline[i], shares[i])));
        outline.iter().zip(shares).map(|(stretch, share)| at(*stretch, share)).collect()
    }
}

/// What is known around a cell, counter-clockwise, and at its centre.
struct Ring {
    places: Vec<Place>,
    classes: Vec<usize>,
    centre: Place,
    of_centre: usize,
}

impl Ring {
    /// Stretch from a place of the ring to the next.
    fn stretch(&self, i: usize) -> Stretch {
        let (a, b) = (self.places[i], self.places[(i + 1) % self.places.len()]);
        (a.min(b), a.max(b))
    }

    /// Places after which the area above a level, counted from 1, begins or ends.
    fn turns(&self, level: usize) -> Vec<usize> {
        let above = |i: usize| self.classes[i % self.classes.len()] >= level;
        (0..self.classes.len()).filter(|i| above(*i) != above(i + 1)).collect()
    }
}

/// Outlines of the area above a level, in a plane of so many units: the stretches that they pass, and places at the plane's border.
fn outlines(rings: &[Ring], level: usize, (width, height): Place) -> Vec<Vec<Stretch>> {
    let mut next: BTreeMap<Stretch, Stretch> = BTreeMap::new();
    for ring in rings {
        let turns = ring.turns(level);
        let joined = ring.of_centre >= level;
        for (i, &turn) in turns.iter().enumerate().filter(|(_, turn)| ring.classes[**turn] >= level) {
            // The area ends here; it began one turn before.
            let count = turns.len();
            let other = turns[if joined { (i + 1) % count } else { (i + count - 1) % count }];
            next.insert(ring.stretch(turn), ring.stretch(other));
        }
        for (i, &a) in ring.places.iter().enumerate() {
            let j = (i + 1) % ring.places.len();
            let b = ring.places[j];
            let at_border =
                (a.0 == b.0 && (a.0 == 0 || a.0 == width)) || (a.1 == b.1 && (a.1 == 0 || a.1 == height));
            let (from, to) = match (ring.classes[i] >= level, ring.classes[j] >= level) {
                (true, true) => ((a, a), (b, b)),
                (true, false) => ((a, a), ring.stretch(i)),
                (false, true) => (ring.stretch(i), (b, b)),
                (false, false) => continue,
            };
            if at_border {
                next.insert(from, to);
            }
        }
    }
    let mut found = Vec::new();
    while let Some((&first, _)) = next.first_key_value() {
        let mut outline = Vec::new();
        let mut at = first;
        while let Some(to) = next.remove(&at) {
            outline.push(at);
            at = to;
        }
        found.push(outline);
    }
    found
}

/// Areas in which a function exceeds levels, rising, on a grid of so many columns and rows on which it is known column by column; `ask`
/// gives it elsewhere, for no more than `most` places.
pub(super) fn areas<E>(
    (columns, rows): (usize, usize),
    values: &[f64],
    levels: &[f64],
    most: usize,
    ask: impl FnMut(&[Place]) -> Result<Vec<f64>, E>,
) -> Result<Areas, E> {
    let mut known = Known { levels, ask, by_row: BTreeMap::new(), by_column: BTreeMap::new(), left: most };
    let place = |i: usize, j: usize| (i as u32 * UNITS, j as u32 * UNITS);
    let mut cells = BTreeSet::new();
    for i in 0..columns {
        for j in 0..rows {
            let (x, y) = place(i, j);
            known.put((x, y), values[i * rows + j]);
            if i + 1 < columns && j + 1 < rows {
                cells.insert(Cell { x, y, size: UNITS });
            }
        }
    }
    known.cut(&mut cells)?;
    let highest = known.locate(&cells, true, FOR_THE_HIGHEST)?;
    let others = known.locate(&cells, false, 1.0)?;
    let rings = known.rings(&cells)?;
    let mut taken = BTreeMap::new();
    let mut above = Vec::new();
    for level in (1..=levels.len()).rev() {
        let outlines = outlines(&rings, level, place(columns - 1, rows - 1));
        above.insert(0, outlines.iter().map(|outline| known.places(outline, level, &mut taken)).collect());
    }
    Ok(Areas { above, located: [highest, others].map(|units| f64::from(units) / f64::from(UNITS)) })
}

/// Place in cells of the grid.
pub(super) fn cells((x, y): (f64, f64)) -> (f64, f64) {
    (x / f64::from(UNITS), y / f64::from(UNITS))
}
