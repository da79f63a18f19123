//! Links of the first page: `g=0.8&kp=0.9&k=0.7&mu=0.6&…`, four numbers, a size, water and uplift. They are read into a case once.
//!
//! A fragment from elsewhere may hold anything: what makes no sense is passed over.

use standfast::Point;

/// What such a link keeps, with what an empty one means.
struct OldLink {
    slenderness: f64,
    elevation: f64,
    force: f64,
    friction: f64,
    to_right: bool,
    width: f64,
    mass: f64,
    sea: f64,
    lee: f64,
    uplift: f64,
}

/// g, m/s², of the first page.
const GRAVITY: f64 = 9.81;

/// The text of the case that a fragment says, with or without its `#`; `None` if it is no such link.
pub fn case(fragment: &str) -> Option<String> {
    let parts = || fragment.trim_start_matches('#').split('&').filter_map(|part| part.split_once('='));
    const KEYS: [&str; 10] = ["g", "kp", "k", "mu", "to", "w", "m", "sea", "lee", "up"];
    parts().any(|(key, _)| KEYS.contains(&key)).then(|| OldLink::of(parts()).text())
}

impl OldLink {
    fn of<'a>(parts: impl Iterator<Item = (&'a str, &'a str)>) -> OldLink {
        let mut link = OldLink {
            slenderness: 0.8,
            elevation: 0.9,
            force: 0.8,
            friction: 0.6,
            to_right: false,
            width: 15.0,
            mass: 378e3,
            sea: 0.0,
            lee: 0.0,
            uplift: 0.0,
        };
        for (key, value) in parts {
            let number = value.parse::<f64>().ok().filter(|number| number.is_finite());
            let positive = number.filter(|number| (1e-50..1e50).contains(number));
            let OldLink { slenderness: g, elevation: kp, force: k, friction: mu, .. } = link;
            let is_point = |g, kp, k, mu| Point::new(g, kp, k, mu).is_ok();
            match (key, number) {
                ("g", Some(number)) if is_point(number, kp, k, mu) => link.slenderness = number,
                ("kp", Some(number)) if is_point(g, number, k, mu) => link.elevation = number,
                ("k", Some(number)) if is_point(g, kp, number, mu) => link.force = number,
                ("mu", Some(number)) if is_point(g, kp, k, number) => link.friction = number,
                ("w", _) => link.width = positive.unwrap_or(link.width),
                ("m", _) => link.mass = positive.unwrap_or(link.mass),
                ("sea", Some(number)) => link.sea = number.max(0.0),
                ("lee", Some(number)) => link.lee = number.max(0.0),
                ("up", Some(number)) => link.uplift = number.max(0.0),
                ("to", _) => link.to_right = value == "right",
                _ => {}
            }
        }
        link
    }

    fn text(&self) -> String {
        let OldLink { width, mass, friction, sea, lee, uplift, .. } = *self;
        let height = width * self.slenderness;
        let mut text = format!(
            "title = \"From a link\"\n\n[body]\nwidth = \"{} m\"\nheight = \"{} m\"\nmass = \"{} t/m\"\nfriction = {}\n",
            toml(width),
            toml(height),
            toml(mass / 1e3),
            toml(friction)
        );
        // The sea is where the force comes from.
        let [sea_side, lee_side] = if self.to_right { ["left", "right"] } else { ["right", "left"] };
        if sea != 0.0 || lee != 0.0 {
            text += &format!(
                "\n[water]\n{sea_side} = \"{} m\"\n{lee_side} = \"{} m\"\ndensity = \"1030 kg/m3\"\n",
                toml(sea),
                toml(lee)
            );
        }
        if uplift != 0.0 {
            text += &format!(
                "\n[uplift]\n{sea_side} = \"{} kPa\"\n{lee_side} = 0\ngrows = true\n",
                toml(uplift / 1e3)
            );
        }
        text + &self.forces(height)
    }

    /// The force; one that acts above the crest or below the base as two, on them, that amount to it.
    fn forces(&self, height: f64) -> String {
        let force = self.force * self.mass * GRAVITY;
        let level = (1.0 + self.elevation) * height / 2.0;
        let [towards, back] = if self.to_right { ["right", "left"] } else { ["left", "right"] };
        if (0.0..=height).contains(&level) {
            let table = load(force, level, towards);
            return table.replace("[[load]]\n", "[[load]]\nname = \"force\"\n");
        }
        let top = force * level / height;
        let parts = [(top, height), (force - top, 0.0)];
        let part = |(size, level): (f64, f64)| {
            let way = if size < 0.0 { back } else { towards };
            load(size.abs(), level, way) + "together = true\n"
        };
        parts.map(part).concat()
    }
}

fn load(force: f64, level: f64, direction: &str) -> String {
    format!(
        "\n[[load]]\nforce = \"{} kN/m\"\nelevation = \"{} m\"\ndirection = \"{direction}\"\n",
        toml(force / 1e3),
        toml(level)
    )
}

/// A number as TOML has it, without what binary fractions add behind the fifteenth digit.
fn toml(number: f64) -> String {
    let number: f64 = format!("{number:.14e}").parse().unwrap_or(number);
    if number == 0.0 || (1e-4..1e15).contains(&number.abs()) {
        (number + 0.0).to_string()
    } else {
        format!("{number:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::Page;

    fn opened(fragment: &str) -> Page {
        let mut page = Page::default();
        assert!(page.open("link.toml", &case(fragment).unwrap()), "{fragment}: {:?}", page.fault());
        page
    }

    #[test]
    fn an_old_link_is_the_case_that_it_was() {
        for (fragment, mode) in [
            ("#g=0.8&kp=0.9&k=0.3&mu=0.6", "RE"),
            ("g=1&kp=0.4&k=0.8&mu=0.4", "SL"),
            ("g=3&kp=0.8&k=0.6&mu=0.4", "RO"),
            ("g=0.8&kp=0.9&k=0.8&mu=0.6", "SRO-"),
            ("g=3&kp=0.8&k=1.7&mu=0.05", "SRO+"),
            ("g=1&kp=-0.6&k=5&mu=0.5", "SRO'-"),
            ("g=3&kp=0.8&k=0.6&mu=0.4&to=right", "RO'"),
            ("g=1&kp=0.4&k=0.8&mu=0.4&to=right&w=3&m=5", "SL+"),
            // Above the crest, and below the base.
            ("g=1&kp=1&k=2&mu=5", "RO"),
            ("g=2&kp=2.5&k=0.3&mu=0.9", "RO"),
            ("g=1&kp=-1.7&k=0.7&mu=0.9", "RE"),
        ] {
            let page = opened(fragment);
            let reduced = page.answered().point().unwrap();
            let of = |key: &str| {
                let parts =
                    fragment.trim_start_matches('#').split('&').filter_map(|part| part.split_once('='));
                parts
                    .filter(|(name, _)| *name == key)
                    .map(|(_, value)| value.parse::<f64>().unwrap())
                    .next()
                    .unwrap()
            };
            let point = &reduced.point;
            for (key, found) in
                [("g", point.gamma()), ("kp", point.k_prime()), ("k", point.k()), ("mu", point.mu())]
            {
                assert!((found - of(key)).abs() < 1e-12 * (1.0 + of(key).abs()), "{fragment}: {key} {found}");
            }
            assert_eq!(page.answered().verdict().map(standfast::Verdict::symbol), Some(mode), "{fragment}");
        }
    }

    #[test]
    fn water_and_uplift_come_along() {
        let page = opened("g=0.8&kp=0.9&k=0.5&mu=0.6&sea=8&lee=7&up=60000&to=right");
        for line in [
            "left = \"8 m\"",
            "right = \"7 m\"",
            "density = \"1030 kg/m3\"",
            "left = \"60 kPa\"",
            "right = 0",
            "grows = true",
            "direction = \"right\"",
        ] {
            assert!(page.text().lines().any(|found| found == line), "{line} in {}", page.text());
        }
    }

    #[test]
    fn nonsense_is_passed_over() {
        assert_eq!(case(""), None);
        assert_eq!(case("#c=abc&v=load"), None);
        assert_eq!(case("%=%&=&x"), None);
        let plain = case("g=0.8").unwrap();
        assert_eq!(
            case("g=-1&kp=nan&k=inf&mu=&w=0&m=-3&view=1,0,3&fig=9.9&length=<b>&sea=-4&%=%&=&x").unwrap(),
            plain
        );
        // Numbers that no case takes are a fault of the text.
        assert!(!Page::default().open("link.toml", &case("g=1e50&sea=8&k=1e-300").unwrap()));
    }
}
