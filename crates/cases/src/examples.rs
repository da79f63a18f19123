//! The examples of the repository, with the records that they name.

macro_rules! examples {
    ($($path:literal)*) => {
        [$(($path, include_bytes!(concat!("../../../examples/", $path)).as_slice())),*]
    };
}

/// The examples: where each lies in their folder, and what it holds.
pub const EXAMPLES: [(&str, &[u8]); 52] = examples! {
    "block-two-loads.toml"
    "block.toml"
    "breaking-wave.toml"
    "caisson-by-pianc.toml"
    "caisson-in-air.toml"
    "caisson-of-parts.toml"
    "caisson-on-stone.toml"
    "crown-wall-by-pedersen.toml"
    "crown-wall.toml"
    "dam-with-drain.toml"
    "directions/device-on-three-feet.toml"
    "directions/marble-drum.toml"
    "directions/rack.toml"
    "directions/statue.toml"
    "eccentric-caisson.toml"
    "goda-2000-random.toml"
    "goda-2000-storm.toml"
    "goda-2000.toml"
    "goda-lower-berm.toml"
    "goda-on-sand.toml"
    "head-difference.toml"
    "joints/blockwork-quay.toml"
    "joints/column-of-drums.toml"
    "joints/crown-wall-on-caisson.toml"
    "joints/dam-with-lift-joints.toml"
    "joints/statue-on-pedestal.toml"
    "l-wall.toml"
    "marble-drum.toml"
    "monument-on-mortar.toml"
    "monument.toml"
    "motion/block-base-pulse.toml"
    "motion/block-under-a-record.toml"
    "motion/caisson-breaking-wave.toml"
    "motion/caisson-church-roof.toml"
    "motion/marble-column-earthquake.toml"
    "motion/server-rack-earthquake.toml"
    "motion/statue-earthquake.toml"
    "points.csv"
    "probability/column-records.toml"
    "probability/plane-random.toml"
    "quay-by-code.toml"
    "quay.toml"
    "rack-with-ties.toml"
    "records/README.md"
    "records/np01002p_4225a_a.smc"
    "records/np01002p_4225b_a.smc"
    "records/np01002p_4225c_a.smc"
    "sea-states.csv"
    "seismic-block.toml"
    "server-rack.toml"
    "statue-random.toml"
    "trough.toml"
};

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    /// The program has every example that the repository has.
    #[test]
    fn no_example_is_left_out() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
        let mut found = Vec::new();
        let mut folders = vec![root.clone()];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_none_or(|extension| extension != "svg") {
                    let path = path.strip_prefix(&root).unwrap();
                    found.push(path.to_str().unwrap().replace('\\', "/"));
                }
            }
        }
        found.sort();
        let own: Vec<_> = EXAMPLES.iter().map(|(path, _)| (*path).to_owned()).collect();
        assert_eq!(own, found);
    }
}
