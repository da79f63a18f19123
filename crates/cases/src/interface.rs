//! Spelling of options.

/// Interface by which one speaks to the library, and so how its options are spelt.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Interface {
    /// A program's command line: `--map mu=friction`, `--columns mode`.
    #[default]
    Program,
    /// A call in Python: `map={"mu": "friction"}`, `columns=["mode"]`.
    Python,
}

impl Interface {
    /// Option that reads a column of the table, called `theirs`, as `ours`.
    pub fn map(self, ours: &str, theirs: &str) -> String {
        match self {
            Interface::Program => format!("--map \"{ours}={theirs}\""),
            Interface::Python => format!("map={{\"{ours}\": \"{theirs}\"}}"),
        }
    }

    /// Option that has a text and its figures show every situation.
    pub fn all(self) -> &'static str {
        match self {
            Interface::Program => "--all",
            Interface::Python => "all=True",
        }
    }

    /// The option that chooses results.
    pub fn columns(self) -> &'static str {
        match self {
            Interface::Program => "--columns",
            Interface::Python => "columns",
        }
    }
}
