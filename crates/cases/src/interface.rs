//! Spelling of options.

/// By which face one speaks to the library, and so how its options are spelt.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Face {
    /// A program's command line: `--map mu=friction`, `--columns mode`.
    #[default]
    Program,
    /// A call in Python: `map={"mu": "friction"}`, `columns=["mode"]`.
    Python,
}

impl Face {
    /// Option that reads a column of the table, called `theirs`, as `ours`.
    pub fn map(self, ours: &str, theirs: &str) -> String {
        match self {
            Face::Program => format!("--map \"{ours}={theirs}\""),
            Face::Python => format!("map={{\"{ours}\": \"{theirs}\"}}"),
        }
    }

    /// Option that has a text and its figures show every situation.
    pub fn all(self) -> &'static str {
        match self {
            Face::Program => "--all",
            Face::Python => "all=True",
        }
    }

    /// The option that chooses results.
    pub fn columns(self) -> &'static str {
        match self {
            Face::Program => "--columns",
            Face::Python => "columns",
        }
    }
}
