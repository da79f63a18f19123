//! The loads of a situation one by one.

use standfast::Wrench;
use standfast::loads::{Load, LoadSource};
use standfast_model::load_words;

use super::Assessed;

/// A load of a situation: what it is called, whether it is permanent, and what it amounts to at the centre of mass. Water on
/// both sides is one load, where it has one factor.
#[derive(Debug, Clone, PartialEq)]
pub struct Component {
    /// Its name.
    pub name: String,
    /// The load; the first of those that are one.
    pub load: Load,
    /// At the centre of mass, N and N·m per metre run.
    pub wrench: Wrench,
}

impl Assessed {
    /// The loads one by one.
    pub fn components(&self) -> Vec<Component> {
        let mut components: Vec<Component> = Vec::new();
        for load in self.situation.loads() {
            let wrench = self.situation.wrench_of(load);
            match components.last_mut() {
                Some(last)
                    if load.source == LoadSource::StillWater
                        && (last.load.source, last.load.factor) == (load.source, load.factor) =>
                {
                    last.wrench = last.wrench + wrench;
                }
                _ => components.push(Component { name: load_words(load), load: load.clone(), wrench }),
            }
        }
        components
    }
}
