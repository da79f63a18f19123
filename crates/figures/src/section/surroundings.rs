//! What a body stands on and what stands beside it: water, a wave, fill, the mound, the bed or a floor.

use super::paint::{Painter, THIN};
use super::{Mound, Side};
use crate::palette::{FILL, INK, MOUND, PUSH, WATER};
use crate::scene::{Path, Pen, Rect};
use crate::texture;

/// The ratio of slopes of the mound, which no case gives.
pub(super) const SLOPE: f64 = 1.5;
/// How far beyond the left edge of the base the mound is level, on the page.
pub(super) const SHOULDER: f64 = 12.0;
/// Lengths of a sketched wave, in those of the room at its wall; the surface is cut where the room ends.
const WAVES: [f64; 6] = [1.0, 1.5, 2.0, 3.0, 5.0, 8.0];

/// Room beside the body for water and ground, once all else has its place.
pub(super) struct Room {
    /// The x at which the names of levels begin at the left, and at the right.
    pub ends: (f64, f64),
    /// Where labels stand.
    pub labels: Vec<Rect>,
}

impl Painter<'_> {
    /// Water up to its levels, the mound and the bed, or a floor.
    pub(super) fn surroundings(&mut self) {
        let Some(room) = &self.room else { return };
        let [west, east] = [room.ends.0, room.ends.1].map(|x| (x - self.origin.0) / self.scale);
        let floor = self.bed.unwrap_or(0.0).min(0.0);
        for level in self.given.levels.iter().filter(|level| level.is_water) {
            let y = level.elevation;
            // The body, which is wider below, is drawn over it.
            let (x0, x1) = match level.side {
                Side::Left => (west, self.face(y, -1.0)),
                Side::Right => (self.face(y, 1.0), east),
            };
            let path = self.polygon(&[(x0, floor), (x1, floor), (x1, y), (x0, y)]);
            self.drawn.scene.fill(&path, WATER);
        }
        self.wave(east);
        self.backfill((west, east));
        if let (Some(mound), Some(bed)) = (self.given.mound, self.bed) {
            self.mound(&mound, bed, (west, east));
        } else {
            let beside = 26.0 / self.scale;
            let reach = |side, far: f64, near: f64| if self.is_earth_at(side) { far } else { near };
            let left = reach(Side::Left, west, self.bounds.x0 - beside);
            let right = reach(Side::Right, east, self.bounds.x1 + beside);
            self.ground(0.0, (left, right));
        }
    }

    /// True if there is soil on a side: under all, or as fill beside the body.
    fn is_earth_at(&self, side: Side) -> bool {
        self.given.is_on_soil || self.given.backfills.iter().any(|fill| fill.side == side)
    }

    /// Fill beside the body, up to its surface.
    fn backfill(&mut self, (west, east): (f64, f64)) {
        for fill in &self.given.backfills {
            // The body, which is wider below, is drawn over it.
            let (near, far) = match fill.side {
                Side::Left => (self.face(fill.top, -1.0), west),
                Side::Right => (self.face(fill.top, 1.0), east),
            };
            let rises = fill.top + fill.slope * (far - near).abs();
            self.soil(&[(far, 0.0), (near, 0.0), (near, fill.top), (far, rises)], FILL);
        }
    }

    /// An area of soil: grains over a tint.
    fn soil(&mut self, corners: &[(f64, f64)], tint: &str) {
        let places: Vec<_> = corners.iter().map(|&(x, y)| self.place(x, y)).collect();
        let path = self.polygon(corners);
        self.drawn.scene.fill(&path, tint);
        texture::grains(&mut self.drawn.scene, &places);
    }

    /// The surface of the wave, from its crest at the wall down towards the water at the right: half a wave of any length, one that keeps
    /// off the labels where there is such a one.
    fn wave(&mut self, east: f64) {
        const STEPS: u32 = 24;
        let still = self.given.levels.iter().find(|level| level.is_water && level.side == Side::Right);
        let (Some(still), Some(crest)) = (still, self.given.wave_crest) else { return };
        let still = still.elevation;
        let (wall, crest) = (self.face(still, 1.0), self.shown(crest));
        let surface = |length: f64| -> Vec<(f64, f64)> {
            let at = |i: u32| {
                let share = f64::from(i) / f64::from(STEPS);
                let height = (1.0 + (std::f64::consts::PI * share / length).cos()) / 2.0;
                (wall + share * (east - wall), still + height * (crest - still))
            };
            (0..=STEPS).map(at).collect()
        };
        let is_clear = |line: &[(f64, f64)]| {
            let places: Vec<_> = line.iter().map(|&(x, y)| self.place(x, y)).collect();
            let labels = self.room.iter().flat_map(|room| &room.labels);
            !labels.map(|label| label.grown(2.0)).any(|label| meets(&places, &label))
        };
        let mut surfaces = WAVES.map(surface).into_iter();
        let line = surfaces.clone().find(|line| is_clear(line)).or_else(|| surfaces.next());
        let line = line.unwrap_or_default();
        let mut area = line.clone();
        // A long one is cut above the still water.
        area.extend(line.last().filter(|end| end.1 > still).map(|_| (east, still)));
        area.push((wall, still));
        let path = self.polygon(&area);
        self.drawn.scene.fill(&path, WATER);
        let line: Vec<_> = line.into_iter().map(|(x, y)| self.place(x, y)).collect();
        self.hold(&Rect { x0: line[0].0, y0: line[0].1, x1: line[0].0, y1: line[0].1 });
        self.drawn.scene.stroke(&Path::through(&line), Pen::solid(PUSH, 1.2));
    }

    fn mound(&mut self, mound: &Mound, bed: f64, (west, east): (f64, f64)) {
        let (left, right) = self.given.base;
        let shoulder = left - SHOULDER / self.scale;
        let end = right + self.berm_reach(mound);
        let top = mound.berm.max(bed);
        let toe = (shoulder + SLOPE * bed).max(west);
        let outline = [
            (toe, bed),
            (shoulder, 0.0),
            (right, 0.0),
            (right, top),
            (end, top),
            ((end + SLOPE * (top - bed)).min(east), bed),
        ];
        if bed < 0.0 {
            let path = self.polygon(&outline);
            if self.given.is_on_soil {
                self.soil(&outline, MOUND);
            } else {
                self.drawn.scene.fill(&path, MOUND);
            }
            self.drawn.scene.stroke(&path, THIN);
        }
        self.ground(bed, (west, east));
    }

    /// A line at a level with soil under it, or else with hatching.
    fn ground(&mut self, level: f64, (left, right): (f64, f64)) {
        const STEP: f64 = 8.0;
        let (from, to) = (self.place(left, level), self.place(right, level));
        if self.given.is_on_soil {
            let low = level - self.earth() / self.scale;
            self.soil(&[(left, low), (right, low), (right, level), (left, level)], MOUND);
            self.drawn.scene.line(from, to, Pen::solid(INK, 1.2));
            return;
        }
        let mut hatch = Path::default();
        for i in 1..=((to.0 - from.0) / STEP) as u32 {
            let x = from.0 + STEP * f64::from(i);
            hatch.move_to(x, from.1);
            hatch.line_to(x - 6.0, from.1 + 6.0);
        }
        self.drawn.scene.stroke(&hatch, THIN);
        self.drawn.scene.line(from, to, Pen::solid(INK, 1.2));
    }
}

/// True if a line of many points meets a rectangle.
fn meets(line: &[(f64, f64)], rect: &Rect) -> bool {
    const STEPS: u32 = 8;
    let on = |pair: &[(f64, f64)], i: u32| {
        let share = f64::from(i) / f64::from(STEPS);
        (pair[0].0 + share * (pair[1].0 - pair[0].0), pair[0].1 + share * (pair[1].1 - pair[0].1))
    };
    let mut places = line.windows(2).flat_map(|pair| (0..=STEPS).map(move |i| on(pair, i)));
    places.any(|(x, y)| rect.x0 < x && x < rect.x1 && rect.y0 < y && y < rect.y1)
}
