//! The stories that the page tells: each a file of steps, in `web/stories`.
//!
//! A step has a headline, words, something to do where there is something, and a case with the numbers that are other in it: the page
//! takes it as it takes any case. What the words say of the answer is held against the answer by the tests.

/// The files, in the order of the menu.
const STORIES: [&str; 6] = [
    include_str!("../stories/two-factors.json"),
    include_str!("../stories/k-mu.json"),
    include_str!("../stories/blow.json"),
    include_str!("../stories/islands.json"),
    include_str!("../stories/ground.json"),
    include_str!("../stories/sure.json"),
];

/// All stories, as JSON.
pub fn json() -> String {
    format!("[{}]", STORIES.join(","))
}

#[cfg(test)]
mod tests;
