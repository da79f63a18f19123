//! The k–μ plane where the base gives way: its curves are exact, its areas are those of the decision, its labels keep apart.

#[path = "base/load.rs"]
mod load;

use standfast::Verdict;
use standfast::diagram::Window;
use standfast::ground::bearing::{BearingPlane, Ground, GroundLaw};
use standfast::ground::strength::{CrushMap, CrushPoint};
use standfast_figures::outlines::{Outlines, Polyline};
use standfast_figures::{DesignPoint, DiagramContent, Figure, KMuPlane, Rect, diagram_with, outlines};

/// γ, k' and ω of every kind: below, between and above the centres of percussion, low forces, and ω next to 0, ½ and 1.
fn maps() -> impl Iterator<Item = (f64, f64, f64)> {
    let bodies = [
        (1.0, 0.4),
        (2.0, 0.55),
        (2.0, 0.8),
        (3.0, 0.8),
        (1.0, 2.0 / 3.0),
        (1.0, 0.0),
        (1.0, -0.6),
        (4.0, -0.55),
        (4.0, -0.2),
        (1.0, -1.0),
        (1.2, -1.7),
        (0.3, 3.0),
    ];
    bodies.into_iter().flat_map(|(γ, h)| [1e-6, 0.05, 0.2, 0.5, 0.8, 0.97].map(|ω| (γ, h, ω)))
}

fn grounds() -> [Ground; 3] {
    let soil = |law| Ground::new(law, 35.0, 10e3).expect("sand");
    [soil(GroundLaw::Ec7), soil(GroundLaw::Hansen), Ground::envelope(1.0).expect("an envelope")]
}

fn soils() -> impl Iterator<Item = BearingPlane> {
    let bodies =
        [(0.7, 0.4), (1.0, 0.0), (3.0, 0.9), (1.0, -0.6), (0.3, -0.2), (2.0, -0.5), (1.0, -1.0), (1.2, -1.7)];
    let planes = |(γ, h)| {
        let of =
            move |ground| [0.05, 0.3, 0.8].map(|u| BearingPlane::of_share(ground, γ, h, u).expect("a plane"));
        grounds().into_iter().flat_map(of)
    };
    bodies.into_iter().flat_map(planes)
}

fn points_of(shown: &Outlines, name: &str) -> Polyline {
    let lines = shown.lines.iter().filter(|line| line.name == name);
    lines.flat_map(|line| line.parts.iter().flatten().copied()).collect()
}

/// At every point of the drawn curve one rotation solves the equations of rock and of slide-rock, written here as the theory has them.
#[test]
fn every_point_of_the_drawn_curve_solves_both_modes() {
    let mut count = 0;
    for (γ, h, ω) in maps() {
        let map = CrushMap::new(γ, h, ω).expect("a map");
        let shown = outlines(&KMuPlane::Crushing(map), &DiagramContent::default());
        // The mirror of a force below the base is one of a force above it that pulls.
        let g = if h < -1.0 { -γ } else { γ };
        let lever = g * (1.0 + h);
        let (j, rho2) = ((1.0 + 4.0 * γ * γ) / 3.0, (1.0 + γ * γ) / 3.0);
        for (k, mu) in points_of(&shown, "mu*") {
            let normal = |a: f64| (1.0 + a) / (1.0 + 2.0 * ω * a);
            let moment = |a: f64| normal(a) * (1.0 - ω * normal(a));
            // Rock, by bisection: J α + R = k G₁.
            let (mut low, mut high) = (0.0, k * lever / j);
            for _ in 0..200 {
                let a = (low + high) / 2.0;
                if j * a + moment(a) < k * lever { low = a } else { high = a }
            }
            let a = low;
            let pull = k - g * a;
            assert!((pull.abs() - mu * normal(a)).abs() < 1e-12 * (1.0 + k), "{γ} {h} {ω}: {k}, {mu}");
            let friction = pull.signum() * mu * normal(a);
            let left = rho2 * a + moment(a) - k * h * g - g * friction;
            assert!(left.abs() < 1e-12 * (1.0 + k * γ * (1.0 + h.abs())), "{γ} {h} {ω}: {k}, {mu}: {left}");
            count += 1;
        }
    }
    assert!(count > 500, "{count} points");
}

/// Twice the area, by the shoelace formula.
fn twice_area(polygon: &Polyline) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(&(k0, m0), &(k1, m1))| k0 * m1 - k1 * m0).sum::<f64>().abs()
}

fn assert_filled(shown: &Outlines, of: &str) {
    let filled: f64 = shown.areas.iter().flat_map(|area| &area.polygons).map(twice_area).sum::<f64>() / 2.0;
    let window = shown.window.k * shown.window.mu;
    assert!((filled / window - 1.0).abs() < 1e-6, "{of}: {filled} of {window}");
}

/// True if a point lies in a polygon, by counting what a ray crosses.
fn is_inside(polygon: &Polyline, (k, mu): (f64, f64)) -> bool {
    let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
    let crossed = edges
        .filter(|((k0, m0), (k1, m1))| (*k0 > k) != (*k1 > k) && m0 + (k - k0) / (k1 - k0) * (m1 - m0) > mu);
    crossed.count() % 2 == 1
}

/// The areas fill the window, and each is of the verdict that the decision has at points all over it. A point nearer to a boundary
/// than the drawing's tolerance may be on its other side.
fn assert_decided(shown: &Outlines, of: &str, verdict: impl Fn(f64, f64) -> Verdict) {
    assert_filled(shown, of);
    for i in 0..25 {
        for j in 0..25 {
            let at =
                |i: f64, j: f64| (shown.window.k * (i + 0.37) / 25.0, shown.window.mu * (j + 0.61) / 25.0);
            let (i, j) = (f64::from(i), f64::from(j));
            let near = [(-0.01, 0.0), (0.01, 0.0), (0.0, -0.01), (0.0, 0.01)];
            let own = verdict(at(i, j).0, at(i, j).1);
            if near.map(|(di, dj)| at(i + di, j + dj)).iter().any(|&(k, mu)| verdict(k, mu) != own) {
                continue;
            }
            let holding =
                shown.areas.iter().filter(|area| area.polygons.iter().any(|p| is_inside(p, at(i, j))));
            let found: Vec<_> = holding.map(|area| area.verdict).collect();
            assert_eq!(found, [own], "{of} at {:?}", at(i, j));
        }
    }
}

#[test]
fn areas_are_those_of_the_decision() {
    for (γ, h, ω) in maps() {
        let map = CrushMap::new(γ, h, ω).expect("a map");
        let shown = outlines(&KMuPlane::Crushing(map), &DiagramContent::default());
        assert_decided(&shown, &format!("{γ} {h} {ω}"), |k, mu| {
            CrushPoint::new(γ, h, k, mu, ω).expect("a point").verdict()
        });
    }
    for plane in soils() {
        let shown = outlines(&KMuPlane::Failing(plane), &DiagramContent::default());
        assert_decided(&shown, &format!("{plane:?}"), |k, mu| plane.at(k, mu).expect("a point").verdict);
    }
}

/// On the drawn line the ground just bears a body that slides, by the laws written out here; and the line goes through (k_BF, k_BF).
#[test]
fn ground_fails_on_the_drawn_line() {
    for (which, plane) in soils().enumerate() {
        let shown = outlines(&KMuPlane::Failing(plane), &DiagramContent::default());
        let (γ, h, u) = (plane.gamma(), plane.k_prime(), plane.share());
        let line = points_of(&shown, "R = V");
        for &(k, mu) in &line {
            let ε = γ * (mu + k * h);
            let excess = match which / 3 % 3 {
                0 => u - (1.0 - ε.abs()).powi(2) * (1.0 - mu).powi(3),
                1 => u - (1.0 - ε.abs()).powi(2) * (1.0 - 0.7 * mu).powi(5),
                _ => {
                    let (η, ε) = (mu / 0.52, ε / 0.7);
                    η * η + ε * ε - 2.0 * 0.22 * η * ε - (1.0 - u).powi(2)
                }
            };
            assert!(excess.abs() < 1e-12 * (1.0 + k), "{plane:?} at {k}, {mu}: {excess}");
        }
        let corner = plane.k_bf();
        let nearest =
            line.iter().map(|(k, mu)| (k - corner).hypot(mu - corner)).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-12, "{plane:?}: {nearest} from {corner}");
    }
}

fn assert_tidy(figure: &Figure) {
    let (width, height) = figure.size();
    let page = Rect { x0: 1.0, y0: 1.0, x1: width - 1.0, y1: height - 1.0 };
    let labels = figure.labels();
    for (i, label) in labels.iter().enumerate() {
        assert!(page.contains(&label.rect), "{:?} leaves the page of {:?}", label.text, figure.title());
        for other in &labels[i + 1..] {
            let touch = label.rect.overlaps(&other.rect);
            assert!(!touch, "{:?} touches {:?} in {:?}", label.text, other.text, figure.title());
        }
    }
}

#[test]
fn labels_keep_apart() {
    let point = |k: f64, mu: f64, label: &str| DesignPoint { k, mu, label: label.into(), mirrored: false };
    let points = [point(0.3, 0.5, "storm"), point(0.31, 0.5, "the other storm"), point(2.5, 0.2, "far")];
    for points in [&points[..], &[]] {
        let content = DiagramContent { points, ..DiagramContent::default() };
        for (γ, h, ω) in maps() {
            let map = CrushMap::new(γ, h, ω).expect("a map");
            assert_tidy(&diagram_with(&KMuPlane::Crushing(map), &content));
        }
        soils().for_each(|plane| assert_tidy(&diagram_with(&KMuPlane::Failing(plane), &content)));
    }
}

/// On rigid ground the boundaries are dotted, as in the plane of the load, and named where the ground fails.
#[test]
fn the_rigid_map_is_dotted_and_named() {
    for plane in soils().map(KMuPlane::Failing) {
        let figure = diagram_with(&plane, &DiagramContent::default());
        assert!(figure.svg().contains("stroke-dasharray=\"1.5 3\""), "{:?}", figure.title());
        assert!(figure.caption().contains("Dotted: on rigid ground."), "{}", figure.caption());
    }
    let map = CrushMap::new(3.0, 0.8, 0.2).expect("a map");
    let planes = [KMuPlane::Crushing(map)].into_iter().chain(soils().map(KMuPlane::Failing));
    let is_named = |plane: &KMuPlane| {
        let figure = diagram_with(plane, &DiagramContent::default());
        figure.labels().iter().any(|label| label.text == "on rigid ground")
    };
    let (named, all) =
        planes.fold((0, 0), |(named, all), plane| (named + usize::from(is_named(&plane)), all + 1));
    assert!(named * 4 >= all * 3, "{named} of {all}");
}

/// A base that hardly crushes shows the rigid map: the dotted lines lie under the black ones.
#[test]
fn the_rigid_map_lies_behind() {
    let window = Some(Window { k: 2.5, mu: 1.5 });
    for (γ, h) in [(3.0, 0.8), (1.0, 0.4), (4.0, -0.55), (1.2, -1.7)] {
        let map = CrushMap::new(γ, h, 1e-7).expect("a map");
        let shown =
            outlines(&KMuPlane::Crushing(map), &DiagramContent { window, ..DiagramContent::default() });
        let solid: Vec<(f64, f64)> =
            shown.lines.iter().filter(|line| !line.dashed).flat_map(|line| line.parts.concat()).collect();
        assert!(shown.rigid.len() >= 3);
        for &(k, mu) in shown
            .rigid
            .iter()
            .filter_map(|part| part.first())
            .chain(shown.rigid.iter().filter_map(|p| p.last()))
        {
            let nearest = solid.iter().map(|(a, b)| (a - k).hypot(b - mu)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-4, "{γ} {h}: ({k}, {mu}) is {nearest} from a line");
        }
    }
}
