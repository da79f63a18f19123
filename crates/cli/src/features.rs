//! Parts that a build of the program may leave out, and the command that adds them.

use standfast_cases::Explained;
use thiserror::Error;

/// A part of the program that is a feature of its crate, because it takes long to compile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feature {
    /// Tables in Parquet and Arrow.
    Tables,
    /// Tables as Excel workbooks.
    Workbooks,
    /// Figures as PNG and PDF.
    Pictures,
}

impl Feature {
    /// True if this build has it.
    pub fn is_built_in(self) -> bool {
        match self {
            Feature::Tables => cfg!(feature = "tables"),
            Feature::Workbooks => cfg!(feature = "xlsx"),
            Feature::Pictures => cfg!(feature = "pictures"),
        }
    }

    fn name(self) -> &'static str {
        match self {
            Feature::Tables => "tables",
            Feature::Workbooks => "xlsx",
            Feature::Pictures => "pictures",
        }
    }

    fn adds(self) -> &'static str {
        match self {
            Feature::Tables => "Parquet and Arrow",
            Feature::Workbooks => "Excel, Parquet and Arrow",
            Feature::Pictures => "PNG and PDF",
        }
    }

    /// That this build can do what `asked` (a file or an option) asks for, which is called `what`.
    ///
    /// # Errors
    /// If it leaves that out.
    pub fn require(self, asked: &str, what: &'static str) -> Result<(), LeftOut> {
        let left_out = || LeftOut { asked: asked.to_owned(), what, feature: self };
        if self.is_built_in() { Ok(()) } else { Err(left_out()) }
    }
}

/// The parts that this build has, in words.
pub fn list() -> String {
    let all = [Feature::Tables, Feature::Workbooks, Feature::Pictures];
    let parts: Vec<&str> =
        all.into_iter().filter(|feature| feature.is_built_in()).map(Feature::name).collect();
    if parts.is_empty() { "no features".to_owned() } else { format!("with {}", parts.join(", ")) }
}

/// Something is asked for that this build leaves out.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{asked}: this build of standfast leaves out {what}")]
pub struct LeftOut {
    asked: String,
    what: &'static str,
    feature: Feature,
}

impl Explained for LeftOut {
    fn help(&self) -> Option<String> {
        Some(format!(
            "`cargo install --path crates/cli --features {}` adds {}; `--features full` adds all there is",
            self.feature.name(),
            self.feature.adds()
        ))
    }
}
