//! Everything CI does, runnable by hand.
fn main() {}
