//! Stretches of a line, of which neighbours with the same answer are one.

/// A stretch of a line.
pub(crate) trait Neighbour: Sized {
    /// True if the same holds on the next stretch.
    fn is_like(&self, next: &Self) -> bool;

    /// Prolongs it over the next stretch.
    fn prolong(&mut self, next: &Self);

    /// Adds a stretch behind others: the last of them goes on over it if the same holds there.
    fn join(self, all: &mut Vec<Self>) {
        match all.last_mut() {
            Some(last) if last.is_like(&self) => last.prolong(&self),
            _ => all.push(self),
        }
    }
}
