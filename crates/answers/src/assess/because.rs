//! Inequalities that decide a mode.

use standfast::relation::Relation;

use super::Assessed;

impl Assessed {
    /// The inequalities that decide the mode under the full load: the report's where the load has a point in its diagram,
    /// otherwise the conditions of the contact problem. None where no mode is consistent, of bodies on joints, and on a base seen
    /// from above.
    pub fn because(&self) -> Vec<Relation> {
        if self.joints.is_some() || self.outcome.plan.is_some() {
            return Vec::new();
        }
        let full = &self.outcome.full;
        if self.is_on_ground() {
            return self.because_of_ground();
        }
        match &full.effective {
            Some(reduced) if !self.situation.is_as_written() => reduced.point.explain().deciding().to_vec(),
            _ => self.situation.explain(full),
        }
    }
}
