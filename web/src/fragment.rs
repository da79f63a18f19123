//! The state as the fragment of a link: `g=0.8&kp=0.9&k=0.7&mu=0.6&…`.
//!
//! Values that are as on a new page are left out, but for the four numbers. A fragment from elsewhere may hold
//! anything: what makes no sense is passed over.

use standfast::Point;
use standfast_figures::View;

use crate::state::State;
use crate::unit::{FORCES, LENGTHS, MASSES, PRESSURES, PageUnit, choose};

const UNITS: [(&str, &[PageUnit]); 4] =
    [("length", &LENGTHS), ("mass", &MASSES), ("force", &FORCES), ("pressure", &PRESSURES)];

/// Writes the state.
pub fn write(state: &State) -> String {
    let first = State::default();
    let mut parts = vec![
        format!("g={}", state.slenderness),
        format!("kp={}", state.elevation),
        format!("k={}", state.force),
        format!("mu={}", state.friction),
    ];
    if state.mirrored {
        parts.push("to=right".into());
    }
    let numbers = [
        ("w", state.width, first.width),
        ("m", state.mass, first.mass),
        ("sea", state.waters.sea, 0.0),
        ("lee", state.waters.lee, 0.0),
        ("up", state.waters.uplift, 0.0),
    ];
    let changed = numbers.into_iter().filter(|(_, value, first)| value != first);
    parts.extend(changed.map(|(key, value, _)| format!("{key}={value}")));
    if let Some(View { k_min, k_max, mu_min, mu_max }) = state.view {
        parts.push(format!("view={k_min},{k_max},{mu_min},{mu_max}"));
    }
    if let Some(figure) = state.figure {
        parts.push(format!("fig={figure}"));
    }
    let chosen = [state.units.length, state.units.mass, state.units.force, state.units.pressure];
    for ((quantity, table), chosen) in UNITS.into_iter().zip(chosen).filter(|(_, chosen)| *chosen > 0) {
        parts.push(format!("{quantity}={}", table[chosen].0.replace('/', "-per-")));
    }
    parts.join("&")
}

/// Reads a state, with or without the `#`.
pub fn parse(fragment: &str) -> State {
    let mut state = State::default();
    let parts = || fragment.trim_start_matches('#').split('&').filter_map(|part| part.split_once('='));
    for (key, value) in parts() {
        let mut next = state.clone();
        let number = value.parse::<f64>().ok().filter(|number| number.is_finite());
        let positive = number.filter(|number| (1e-50..1e50).contains(number));
        match (key, number) {
            ("g", Some(number)) => next.slenderness = number,
            ("kp", Some(number)) => next.elevation = number,
            ("k", Some(number)) => next.force = number,
            ("mu", Some(number)) => next.friction = number,
            ("w", _) => next.width = positive.unwrap_or(next.width),
            ("m", _) => next.mass = positive.unwrap_or(next.mass),
            ("sea", Some(number)) => next.waters.sea = number.max(0.0),
            ("lee", Some(number)) => next.waters.lee = number.max(0.0),
            ("up", Some(number)) => next.waters.uplift = number.max(0.0),
            ("to", _) => next.mirrored = value == "right",
            ("view", _) => next.view = view(value),
            ("fig", _) => next.figure = value.parse().ok(),
            ("length" | "mass" | "force" | "pressure", _) => {
                choose(&mut next.units, key, &value.replace("-per-", "/"));
            }
            _ => {}
        }
        if Point::new(next.slenderness, next.elevation, next.force, next.friction).is_ok() {
            state = next;
        }
    }
    let names_body = parts().any(|(key, _)| matches!(key, "g" | "kp"));
    with_figure(state, names_body)
}

/// A figure of the report shows its own body: one that the link names alone brings it along, beside another it is dropped.
fn with_figure(mut state: State, names_body: bool) -> State {
    let Some((id, body)) = state.figure.and_then(|id| Some((id, id.body()?))) else { return state };
    if body != (state.slenderness, state.elevation) {
        state.show_figure((!names_body).then_some(id));
    }
    state
}

fn view(text: &str) -> Option<View> {
    let numbers: Vec<f64> = text.split(',').filter_map(|number| number.parse().ok()).collect();
    let [k_min, k_max, mu_min, mu_max] = numbers[..] else { return None };
    Some(View { k_min, k_max, mu_min, mu_max }).filter(View::is_drawable)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_comes_back() {
        let mut state = State {
            slenderness: 0.1 + 0.2,
            elevation: -1.7,
            force: 1e-7,
            mirrored: true,
            ..State::default()
        };
        state.view = Some(View { k_min: 0.25, k_max: 1.0 / 3.0, mu_min: 0.0, mu_max: 0.7 });
        state.figure = "2.1".parse().ok();
        state.waters.uplift = 65.7e3;
        choose(&mut state.units, "mass", "kg/m");
        assert_eq!(parse(&write(&state)), state);
        assert_eq!(parse(&format!("#{}", write(&state))), state);
        assert_eq!(parse(""), State::default());
    }

    #[test]
    fn a_figure_alone_brings_its_body() {
        let state = parse("#fig=3.11");
        assert_eq!((state.slenderness, state.elevation), (3.0, 0.8));
        assert_eq!(parse(&write(&state)), state);
        assert_eq!(parse("g=1&kp=0.2&fig=3.11").figure, None);
    }

    #[test]
    fn nonsense_is_passed_over() {
        let text = "g=-1&kp=nan&k=inf&mu=&w=0&m=-3&view=1,0,3&fig=9.9&length=<b>&sea=-4&%=%&=&x";
        assert_eq!(parse(text), State::default());
    }
}
