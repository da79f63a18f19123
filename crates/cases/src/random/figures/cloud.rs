//! Draws in the colours of their modes, with the modes behind them.

use standfast::initiation::classify;
use standfast::{Diagram, Mode, Verdict};
use standfast_answers::random::{ChanceProblem, Chances, DrawInPlane, Happening};
use standfast_figures::{
    ChanceCloud, CloudPanel, DiagramContent, Figure, SpectrumAxis, chance_cloud, diagram_with,
};
use standfast_probability::sample;

use super::areas::{COARSE, FINE, areas};
use super::{quantity, rounded};
use crate::layout::digits;
use crate::units::Dimension;

/// Share of a heavy tail that is left outside of a picture, at each end.
const TAIL: f64 = 0.005;
/// Number of draws in a cloud.
const DRAWS: u64 = 1000;
/// Draws of the random numbers, and where they lie.
pub(in crate::random) struct Cloud {
    values: Vec<Vec<f64>>,
    modes: Vec<Option<Mode>>,
    /// True if the ground fails under any of them.
    fails: bool,
    /// Places in effective coordinates of the draws, where they have one.
    places: Vec<Option<DrawInPlane>>,
}

const K: usize = 1;
const K_PRIME: usize = 2;
const MU: usize = 3;
const GAMMA: usize = 0;
const NAMES: [&str; 4] =
    ["slenderness, $γ$", "force over weight, $k$", "elevation of the force, $k′$", "friction, $μ$"];

impl Cloud {
    /// None of a problem of one random number, which has no cloud.
    pub(in crate::random) fn of(problem: &ChanceProblem, seed: u64) -> Option<Cloud> {
        if problem.random().len() < 2 {
            return None;
        }
        let mut draws = Cloud { values: Vec::new(), modes: Vec::new(), fails: false, places: Vec::new() };
        sample::draws(problem.laws(), seed, DRAWS, |values| {
            draws.values.push(values.to_vec());
            let happens = problem.drawn(values).happens;
            draws.modes.push(happens.mode());
            draws.fails |= happens == Happening::Decided(Verdict::BearingFailure);
            draws.places.push(problem.in_plane(values));
        });
        Some(draws)
    }

    pub(in crate::random) fn figure(
        &self,
        problem: &ChanceProblem,
        worst: &Chances,
        title: &str,
    ) -> Option<Figure> {
        let title = format!("Draws: {title}");
        let placed: Vec<DrawInPlane> = self.places.iter().copied().flatten().collect();
        if !self.is_in_plane(problem) {
            return self.of_numbers(problem, worst, &title);
        }
        if let Some((diagram, cloud)) = self.in_plane(problem) {
            return Some(diagram_with(
                &diagram.into(),
                &DiagramContent { cloud: &cloud, ..DiagramContent::default() },
            ));
        }
        let of = |i: usize| placed.iter().map(|place| place.at[i]).collect::<Vec<f64>>();
        let first = placed[0].at;
        let same = |i: usize| of(i).iter().all(|x| (x - first[i]).abs() <= 1e-9 * first[i].abs());
        let varying: Vec<usize> = [K, MU, K_PRIME, GAMMA].into_iter().filter(|i| !same(*i)).collect();
        let [across, ups @ ..] = &varying[..] else { return self.of_numbers(problem, worst, &title) };
        if ups.is_empty() {
            return self.of_numbers(problem, worst, &title);
        }
        // A draw that is none has no place; what is left keeps its mode.
        let modes: Vec<Option<Mode>> =
            self.places.iter().zip(&self.modes).filter(|(p, _)| p.is_some()).map(|(_, mode)| *mode).collect();
        let medians: [f64; 4] = std::array::from_fn(|i| median(of(i)));
        let right = placed[0].right;
        // Of forces to both sides no one mode holds at a place.
        let one_sided = placed.iter().all(|place| place.right == right);
        let panels: Vec<CloudPanel<'_>> = ups
            .iter()
            .take(2)
            .map(|up| {
                let mut panel = panel((NAMES[*across], &of(*across)), (NAMES[*up], &of(*up)));
                if one_sided {
                    panel.areas = areas(&panel, FINE, |x, y| {
                        let mut at = medians;
                        (at[*across], at[*up]) = (x, y);
                        let mode = classify(at[GAMMA], at[K_PRIME], at[K], at[MU]).ok()?;
                        Some(if right { mode.mirrored() } else { mode })
                    });
                }
                panel
            })
            .collect();
        let behind = if one_sided { behind(ups, &medians) } else { String::new() };
        let caption = format!(
            "{} draws in the effective coordinates of the report's plane, in the colours of their modes{}. {behind}",
            placed.len(),
            outside(&panels)
        );
        Some(chance_cloud(&ChanceCloud {
            title: &title,
            caption: caption.trim_end(),
            panels: &panels,
            modes: &modes,
        }))
    }

    /// True if the draws are points of the report's plane, which is that of a rigid base.
    fn is_in_plane(&self, problem: &ChanceProblem) -> bool {
        !problem.gives_way() && self.places.iter().flatten().count() * 100 >= self.places.len() * 99
    }

    /// The report's plane in which force and friction of the draws lie, where they have one slenderness and one elevation of the force.
    pub(in crate::random) fn in_plane(&self, problem: &ChanceProblem) -> Option<(Diagram, Vec<(f64, f64)>)> {
        let placed: Vec<&DrawInPlane> = self.places.iter().flatten().collect();
        let first = placed.first().filter(|_| self.is_in_plane(problem))?.at;
        let same =
            |i: usize| placed.iter().all(|place| (place.at[i] - first[i]).abs() <= 1e-9 * first[i].abs());
        let diagram =
            Diagram::new(first[GAMMA], first[K_PRIME]).ok().filter(|_| same(GAMMA) && same(K_PRIME))?;
        Some((diagram, placed.iter().map(|place| (place.at[K], place.at[MU])).collect()))
    }

    /// The two numbers that matter most, of a body that the report's plane is not of.
    fn of_numbers(&self, problem: &ChanceProblem, worst: &Chances, title: &str) -> Option<Figure> {
        let mut order: Vec<usize> = (0..problem.random().len()).collect();
        if let Some(point) = &worst.design_point {
            standfast::order::by_number(&mut order, |one| -point.alpha[*one].abs());
        }
        let [across, up, ref others @ ..] = order[..] else { return None };
        let paper = |i: usize| problem.random()[i].dimension().map_or(("", 1.0), Dimension::on_paper);
        let name = |i: usize| quantity(&problem.random()[i].words(), paper(i).0);
        let of = |i: usize| self.values.iter().map(|values| values[i] / paper(i).1).collect::<Vec<f64>>();
        let names = [name(across), name(up)];
        let mut panel = panel((&names[0], &of(across)), (&names[1], &of(up)));
        let scales: Vec<f64> = (0..order.len()).map(|i| paper(i).1).collect();
        let medians: Vec<f64> = scales.iter().enumerate().map(|(i, scale)| scale * median(of(i))).collect();
        panel.areas = areas(&panel, COARSE, |x, y| {
            let mut values = medians.clone();
            (values[across], values[up]) = (x * scales[across], y * scales[up]);
            problem.drawn(&values).happens.mode()
        });
        let panels = [panel];
        let which = if others.is_empty() { "" } else { " of the two numbers that matter most" };
        let behind = if others.is_empty() {
            "Behind them the modes."
        } else {
            "Behind them the modes where all other numbers have their medians."
        };
        let fails = if self.fails { " White: the ground fails." } else { "" };
        let (count, outside) = (self.values.len(), outside(&panels));
        let caption = match problem.has_joints() {
            true => {
                let medians = if others.is_empty() { "" } else { ", all other numbers at their medians" };
                format!(
                    "{count} draws{which}{outside}. Shaded: every joint rests{medians}; white: one leaves rest."
                )
            }
            false => format!("{count} draws{which}, in the colours of their modes{outside}. {behind}{fails}"),
        };
        Some(chance_cloud(&ChanceCloud { title, caption: &caption, panels: &panels, modes: &self.modes }))
    }
}

/// Sentence on the modes behind draws, where several views each leave out those that the others show.
fn behind(ups: &[usize], medians: &[f64; 4]) -> String {
    if ups.len() == 1 {
        return "Behind them the modes.".to_owned();
    }
    let letters = ["γ", "k", "k′", "μ"];
    let held: Vec<String> =
        ups.iter().map(|i| format!("{} = {}", letters[*i], digits(rounded(medians[*i])))).collect();
    format!("Behind them the modes where what an axis does not show has its median, {}.", held.join(", "))
}

/// The middle one of some values.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Number of places outside of a view, in words.
fn outside(panels: &[CloudPanel<'_>]) -> String {
    let beyond = |axis: &SpectrumAxis<'_>, x: f64| x < axis.from || x > axis.to;
    let out = |panel: &CloudPanel<'_>| {
        panel.points.iter().filter(|(x, y)| beyond(&panel.across, *x) || beyond(&panel.up, *y)).count()
    };
    match panels.iter().map(out).max() {
        Some(1) => "; one of them lies outside".to_owned(),
        Some(count) if count > 0 && panels.len() == 1 => format!("; {count} of them lie outside"),
        Some(count) if count > 0 => format!("; up to {count} of them lie outside"),
        _ => String::new(),
    }
}

fn panel<'a>((across, xs): (&'a str, &[f64]), (up, ys): (&'a str, &[f64])) -> CloudPanel<'a> {
    let axis = |name: &'a str, values: &[f64]| {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let at = |share: f64| sorted[((share * sorted.len() as f64) as usize).min(sorted.len() - 1)];
        let (low, high) = (at(TAIL), at(1.0 - TAIL));
        let room = 0.12 * (high - low).max(1e-9 * high.abs()).max(f64::MIN_POSITIVE);
        // What cannot be negative does not get an axis that is.
        let from = if low >= 0.0 { (low - room).max(0.0) } else { low - room };
        SpectrumAxis { name, from, to: high + room, logarithmic: false }
    };
    let points = xs.iter().copied().zip(ys.iter().copied()).collect();
    CloudPanel { across: axis(across, xs), up: axis(up, ys), areas: Vec::new(), points }
}
