# A programmer, who has cargo, unpacks the crate and prints a mode.
tar -xf "$FILES"/standfast-[0-9]*.crate
cargo init --quiet --vcs none wall
cd wall
cargo add --quiet --path ../standfast-[0-9]*
cat > src/main.rs <<'LINES'
fn main() -> Result<(), standfast::InputError> {
    println!("{}", standfast::Point::new(0.8, 0.9167, 0.7281, 0.6)?.mode());
    Ok(())
}
LINES
cargo run --quiet > answer.txt
grep -q "SRO-" answer.txt
