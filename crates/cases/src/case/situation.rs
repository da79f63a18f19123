//! A case as situations of the library: all its loads together, once with each of the alternative forces.

use standfast::contact::Wrench;
use standfast::{LoadKind, Situation};

use super::{AddedMass, Case, Weight};

/// Where a load comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// m g.
    Weight,
    /// W', as given.
    BuoyantWeight,
    /// Still water under the base.
    Buoyancy,
    /// Still water on the sides.
    StillWater,
    /// Pressures under the base, as given.
    Uplift,
    /// The body's inertia against a horizontal acceleration of the base.
    HorizontalInertia,
    /// Water against the shaken wall.
    ShakenWater,
    /// The body's inertia against a vertical acceleration of the base.
    VerticalInertia,
    /// Waves on the wall.
    WavePressure,
    /// Waves under the base.
    WaveUplift,
    /// One of the case's forces.
    Force,
}

/// A load and what it is called.
#[derive(Debug, Clone, PartialEq)]
pub struct Component {
    /// In words.
    pub name: String,
    /// Where it comes from.
    pub origin: Origin,
    /// How it counts.
    pub kind: LoadKind,
    /// Whether it is there all the time, or grows with the load factor.
    pub permanent: bool,
    /// Its wrench at the centre of mass, N and N·m per metre run.
    pub wrench: Wrench,
}

/// The body under all loads that act together.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedBody {
    /// Which of the case's alternative forces is among them.
    pub load: Option<usize>,
    /// The loads one by one.
    pub components: Vec<Component>,
    /// For the library.
    pub situation: Situation,
}

impl Case {
    /// One situation for each alternative force, or the only one.
    pub fn situations(&self) -> Vec<LoadedBody> {
        match self.loads.len() {
            0 => vec![self.situation(None)],
            count => (0..count).map(|load| self.situation(Some(load))).collect(),
        }
    }

    fn situation(&self, load: Option<usize>) -> LoadedBody {
        let mut components = self.common_components();
        if let Some(load) = load.map(|load| &self.loads[load]) {
            let name = load.name.clone().unwrap_or_else(|| "force".to_owned());
            let force = load.force.direction().sign() * load.force.magnitude();
            let wrench = self.body.horizontal_force(force, load.force.elevation());
            components.push(variable(name, Origin::Force, LoadKind::Horizontal, wrench));
        }
        let mut situation = Situation::new(self.body, self.friction, self.gravity);
        situation.kinetic_friction = self.kinetic_friction;
        situation.added_mass = self.added_mass.mass;
        for &Component { kind, permanent, wrench, .. } in &components {
            situation =
                if permanent { situation.permanent(kind, wrench) } else { situation.variable(kind, wrench) };
        }
        LoadedBody { load, components, situation }
    }

    /// The loads that act beside each of the alternative forces.
    fn common_components(&self) -> Vec<Component> {
        let body = &self.body;
        let mut components = vec![match self.weight {
            Weight::Total => {
                permanent("weight m g", Origin::Weight, LoadKind::Weight, body.weight(self.gravity))
            }
            Weight::Buoyant { force, arm } => {
                let wrench = body.vertical_force(force, arm);
                permanent("buoyant weight W'", Origin::BuoyantWeight, LoadKind::Weight, wrench)
            }
        }];
        if let Some(water) = &self.water {
            let unit_weight = water.density * self.gravity;
            let still = body
                .still_water(water.left, water.right, unit_weight)
                .expect("levels were checked when the case was read");
            components.push(permanent("buoyancy", Origin::Buoyancy, LoadKind::Weight, still.base));
            if water.left != water.right {
                let sides = "still water on the sides";
                components.push(permanent(sides, Origin::StillWater, LoadKind::Horizontal, still.sides));
            }
        }
        if let Some(uplift) = &self.uplift {
            let wrench = body.base_pressure(uplift.left, uplift.right);
            components.push(match uplift.grows {
                true => variable("uplift".to_owned(), Origin::Uplift, LoadKind::Uplift, wrench),
                false => permanent("uplift", Origin::Uplift, LoadKind::Uplift, wrench),
            });
        }
        if let Some(earthquake) = &self.earthquake {
            let horizontal = body.base_acceleration(earthquake.horizontal, 0.0);
            components.push(variable(
                "earthquake, horizontal".to_owned(),
                Origin::HorizontalInertia,
                LoadKind::Horizontal,
                horizontal,
            ));
            // Against the shaken wall, water presses as if its mass were shaken, too.
            if let AddedMass { mass, height: Some(height) } = self.added_mass {
                let water = body.horizontal_force(-mass * earthquake.horizontal, height);
                let name = "water on the shaken wall".to_owned();
                components.push(variable(name, Origin::ShakenWater, LoadKind::Horizontal, water));
            }
            if earthquake.vertical != 0.0 {
                let vertical = body.base_acceleration(0.0, earthquake.vertical);
                let name = "earthquake, vertical".to_owned();
                components.push(variable(name, Origin::VerticalInertia, LoadKind::Weight, vertical));
            }
        }
        if let Some(wave) = &self.wave {
            let goda = &wave.goda;
            let force = body.horizontal_force(-goda.force, goda.force_moment / goda.force);
            let name = "wave pressure".to_owned();
            components.push(variable(name, Origin::WavePressure, LoadKind::Horizontal, force));
            let uplift = body.base_pressure(0.0, goda.pu);
            let name = "wave uplift".to_owned();
            components.push(variable(name, Origin::WaveUplift, LoadKind::Uplift, uplift));
        }
        components
    }
}

fn permanent(name: &str, origin: Origin, kind: LoadKind, wrench: Wrench) -> Component {
    Component { name: name.to_owned(), origin, kind, permanent: true, wrench }
}

fn variable(name: String, origin: Origin, kind: LoadKind, wrench: Wrench) -> Component {
    Component { name, origin, kind, permanent: false, wrench }
}
