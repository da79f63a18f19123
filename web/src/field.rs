//! The page's number fields and sliders: what they mean, and what they take.

use standfast::loads::HorizontalForce;
use standfast::{Body, Point, Slip};
use standfast_figures::{Axis, View};

use crate::loads::Waters;
use crate::number;
use crate::state::{GRAVITY, State, round_digits, rounded};
use crate::unit::{self, FORCES, LENGTHS, MASSES, PRESSURES, PageUnit};

/// A number that a person can type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Field {
    /// γ.
    Slenderness,
    /// k'.
    Elevation,
    /// k.
    Force,
    /// μ.
    Friction,
    /// 2B.
    Width,
    /// 2H.
    Height,
    /// m.
    Mass,
    /// F.
    Thrust,
    /// Of F above the base.
    Level,
    /// Of the water on the side that the force comes from, above the base.
    Sea,
    /// Of the water on the other side.
    Lee,
    /// Wave pressure under the edge of the base that the force comes from; none under the other edge.
    Uplift,
}

impl Field {
    /// All fields with their names in the page.
    pub const ALL: [(&'static str, Field); 12] = [
        ("slenderness", Field::Slenderness),
        ("elevation", Field::Elevation),
        ("force", Field::Force),
        ("friction", Field::Friction),
        ("width", Field::Width),
        ("height", Field::Height),
        ("mass", Field::Mass),
        ("thrust", Field::Thrust),
        ("level", Field::Level),
        ("sea", Field::Sea),
        ("lee", Field::Lee),
        ("uplift", Field::Uplift),
    ];

    /// The field of a name.
    pub fn named(name: &str) -> Option<Field> {
        Field::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, field)| field)
    }

    /// The units that the field takes, and the place of the one chosen; none of a number without unit.
    fn units(self, state: &State) -> (&'static [PageUnit], usize) {
        let units = &state.units;
        match self {
            Field::Slenderness | Field::Elevation | Field::Force | Field::Friction => (&[], 0),
            Field::Width | Field::Height | Field::Level | Field::Sea | Field::Lee => (&LENGTHS, units.length),
            Field::Mass => (&MASSES, units.mass),
            Field::Thrust => (&FORCES, units.force),
            Field::Uplift => (&PRESSURES, units.pressure),
        }
    }

    /// SI units that make one of the field's unit.
    fn scale(self, state: &State) -> f64 {
        let (units, chosen) = self.units(state);
        units.get(chosen).map_or(1.0, |(_, scale)| *scale)
    }

    /// The field's value in SI.
    fn value(self, state: &State) -> f64 {
        let real = state.real();
        let of = |value: fn(&(Body, HorizontalForce)) -> f64| real.as_ref().map_or(f64::NAN, value);
        match self {
            Field::Slenderness => state.slenderness,
            Field::Elevation => state.elevation,
            Field::Force => state.force,
            Field::Friction => state.friction,
            Field::Width => state.width,
            Field::Mass => state.mass,
            Field::Height => of(|(body, _)| body.height()),
            Field::Thrust => of(|(_, force)| force.magnitude()),
            Field::Level => of(|(_, force)| force.elevation()),
            Field::Sea => state.waters.sea,
            Field::Lee => state.waters.lee,
            Field::Uplift => state.waters.uplift,
        }
    }

    /// Text that the field shows.
    pub fn text(self, state: &State) -> String {
        unit::plain(self.value(state) / self.scale(state))
    }

    /// Takes what was typed.
    ///
    /// # Errors
    /// A sentence on the fault for the person who typed it.
    pub fn set(self, state: &mut State, typed: &str) -> Result<(), String> {
        let (number, scale) = number::read(typed, self.units(state).0)?;
        let value = number * scale.unwrap_or_else(|| self.scale(state));
        let before = state.clone();
        let taken = self.take(state, value);
        if taken.is_err() {
            *state = before;
        }
        taken
    }

    fn take(self, state: &mut State, value: f64) -> Result<(), String> {
        match self {
            Field::Slenderness => state.set_body(value, state.elevation),
            Field::Elevation => state.set_body(state.slenderness, value),
            Field::Force => state.force = value,
            Field::Friction => state.friction = value,
            Field::Sea | Field::Lee | Field::Uplift => {
                // A figure of the report knows no water.
                state.figure = None;
                let place = |waters: &mut Waters| match self {
                    Field::Sea => waters.sea = value,
                    Field::Lee => waters.lee = value,
                    _ => waters.uplift = value,
                };
                // By itself: what a lower body has left above its crest on the other side is not this field's to mend.
                let mut alone = Waters::default();
                place(&mut alone);
                alone.check(state)?;
                place(&mut state.waters);
            }
            Field::Width | Field::Height | Field::Mass | Field::Thrust | Field::Level => {
                return self.resize(state, value);
            }
        }
        Point::new(state.slenderness, state.elevation, state.force, state.friction)
            .map_err(|error| sentence(&error.to_string()))?;
        Ok(())
    }

    /// Changes one dimension of the real body or its force, and leaves the others as they are.
    fn resize(self, state: &mut State, value: f64) -> Result<(), String> {
        let now = |field: Field| if field == self { value } else { field.value(state) };
        let said = |error: standfast::InputError| sentence(&error.to_string());
        let body = Body::new(now(Field::Width), now(Field::Height), now(Field::Mass)).map_err(said)?;
        let force = HorizontalForce::new(now(Field::Thrust), now(Field::Level), Slip::Left).map_err(said)?;
        let reduced = force.reduce(&body, state.friction, GRAVITY).map_err(said)?;
        let (slenderness, elevation) = (reduced.point.gamma(), reduced.point.k_prime());
        // Rounding is not to take a figure of the report away.
        if matches!(self, Field::Width | Field::Height | Field::Level) {
            state.set_body(slenderness, elevation);
        }
        if matches!(self, Field::Mass | Field::Thrust) {
            state.force = reduced.point.k();
        }
        (state.width, state.mass) = (body.width(), body.mass());
        Ok(())
    }

    /// Axis of a slider from 0 to 1, if the field has one.
    pub fn axis(self, state: &State) -> Option<Axis> {
        // Those of k and μ cover what the diagram of the force shows.
        let shown = |largest: fn(&View) -> f64| {
            Some(Axis { from: 0.0, to: largest(&state.force_view()), logarithmic: false })
        };
        match self {
            Field::Slenderness => Some(Axis { from: 0.1, to: 10.0, logarithmic: true }),
            Field::Elevation => Some(Axis { from: -1.0, to: 1.0, logarithmic: false }),
            Field::Force => shown(|view| view.k_max),
            Field::Friction => shown(|view| view.mu_max),
            _ => None,
        }
    }

    /// Position of the slider, from 0 to 1.
    pub fn share(self, state: &State) -> Option<f64> {
        self.axis(state).map(|axis| axis.share(self.value(state)).clamp(0.0, 1.0))
    }

    /// Takes a slider's place.
    pub fn slide(self, state: &mut State, share: f64) {
        let Some(axis) = self.axis(state).filter(|_| share.is_finite()) else { return };
        let value = axis.value(share.clamp(0.0, 1.0));
        let value = match self {
            Field::Slenderness => round_digits(value, 3),
            Field::Elevation => (value * 200.0).round() / 200.0 + 0.0,
            _ => rounded(value, (axis.to - axis.from) / 400.0),
        };
        // A slider's values are all valid.
        let _ = self.take(state, value);
    }
}

/// An error message as a sentence of the page.
pub fn sentence(message: &str) -> String {
    let mut letters = message.chars();
    let first = letters.next().map(|c| c.to_uppercase().collect::<String>()).unwrap_or_default();
    format!("{first}{}.", letters.as_str()).replace('\'', "′").replace(" -", " −")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Water that a lower body leaves above its crest on both sides is mended side by side.
    #[test]
    fn water_above_the_crest_is_mended_field_by_field() {
        let mut state = State::default();
        let enter = |state: &mut State, field: Field, typed: &str| field.set(state, typed);
        for (field, typed) in [(Field::Sea, "8"), (Field::Lee, "7"), (Field::Height, "6")] {
            enter(&mut state, field, typed).unwrap();
        }
        assert!(state.waters.check(&state).is_err());
        assert!(enter(&mut state, Field::Sea, "6.5").is_err());
        for field in [Field::Sea, Field::Uplift, Field::Lee] {
            enter(&mut state, field, "0").unwrap();
        }
        assert!(state.waters.are_none());
    }

    #[test]
    fn a_dimension_changes_alone() {
        for field in [Field::Width, Field::Height, Field::Mass, Field::Thrust, Field::Level] {
            let mut state = State::default();
            let all = [Field::Width, Field::Height, Field::Mass, Field::Thrust, Field::Level];
            let before = all.map(|field| field.value(&state));
            let typed = field.value(&state) / field.scale(&state) * 1.1;
            field.set(&mut state, &typed.to_string()).unwrap();
            for (other, before) in all.into_iter().zip(before) {
                let expected = if other == field { 1.1 * before } else { before };
                assert!((other.value(&state) / expected - 1.0).abs() < 1e-12, "{field:?} changed {other:?}");
            }
        }
    }

    #[test]
    fn what_is_no_value_is_said_and_changes_nothing() {
        let cases = [
            (
                Field::Slenderness,
                "0",
                "Slenderness γ is 0; expected a number above zero, from 1e-50 to 1e50.",
            ),
            (Field::Friction, "−0.1", "Friction μ is −0.1; expected a number from 0 to 1e50."),
            (Field::Force, "abc", "“abc” is not a number."),
            (Field::Force, "inf", "“inf” is not a number."),
            (Field::Force, "", "A number is missing."),
            (Field::Thrust, "2,700", "“2,700” could be 2.7 or 2700: type 2.7 or 2700."),
            (Field::Width, "-3", "Width is −3; expected a number above zero, from 1e-50 to 1e50."),
            (
                Field::Sea,
                "40",
                "Water level is 40; expected no more than the height of the body: its crest has to stand above still water.",
            ),
        ];
        for (field, typed, message) in cases {
            let mut state = State::default();
            assert_eq!(field.set(&mut state, typed), Err(message.to_owned()));
            assert_eq!(state, State::default());
        }
    }

    #[test]
    fn units_scale_what_is_typed_and_shown() {
        let mut state = State::default();
        unit::choose(&mut state.units, "length", "cm");
        Field::Width.set(&mut state, "1200").unwrap();
        assert_eq!(state.width, 12.0);
        assert_eq!(Field::Width.text(&state), "1200");
        unit::choose(&mut state.units, "length", "mm");
        assert_eq!(Field::Width.text(&state), "12000");
        Field::Width.set(&mut state, "1,5 m").unwrap();
        assert_eq!((state.width, Field::Width.text(&state)), (1.5, "1500".to_owned()));
    }

    #[test]
    fn sliders_cover_their_axis() {
        let mut state = State::default();
        for (share, expected) in [(0.0, 0.1), (0.5, 1.0), (1.0, 10.0)] {
            Field::Slenderness.slide(&mut state, share);
            assert_eq!(state.slenderness, expected);
            assert!((Field::Slenderness.share(&state).unwrap() - share).abs() < 1e-9);
        }
    }
}
