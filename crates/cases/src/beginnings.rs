//! Cases to begin from: complete, with comments, each answered as it comes and without a file beside it.

/// A case to begin from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Beginning {
    /// Its name, in a word.
    pub name: &'static str,
    /// Subject of the case, in a line.
    pub title: &'static str,
    /// Content of the case, in a sentence.
    pub words: &'static str,
    /// Text of its case file.
    pub text: &'static str,
}

macro_rules! beginnings {
    ($($name:literal $title:literal $words:literal;)*) => {
        [$(Beginning {
            name: $name,
            title: $title,
            words: $words,
            text: include_str!(concat!("../beginnings/", $name, ".toml")),
        }),*]
    };
}

/// Every case to begin from.
pub const BEGINNINGS: [Beginning; 7] = beginnings! {
    "block" "A block" "Width, height, density, friction, one force.";
    "caisson" "A caisson under a wave" "Goda’s wave from the right, still water, three criteria.";
    "wall" "A wall" "A fill that pushes, traffic on it, two criteria.";
    "statue" "A statue in an earthquake" "One thing on a plinth narrower than itself, under a peak acceleration.";
    "rack" "A rack on a floor" "One thing of some length, a floor that shakes, two criteria.";
    "motion" "A body in time" "Shaken by one period of a sine: does it come back?";
    "random" "Numbers that are not certain" "Friction and the largest wave of a year as laws, a life of fifty years.";
};

impl Beginning {
    /// The case of a name.
    ///
    /// ```
    /// use standfast_cases::{Assessment, CaseFile, beginnings::Beginning};
    ///
    /// let statue = Beginning::find("statue").expect("there is one");
    /// let file = CaseFile::parse("statue.toml", statue.text)?;
    /// assert!(Assessment::of_file(&file)?.governing().verdict().is_some());
    /// # Ok::<(), standfast_cases::CaseError>(())
    /// ```
    pub fn find(name: &str) -> Option<&'static Beginning> {
        BEGINNINGS.iter().find(|beginning| beginning.name == name)
    }

    /// Name of its file.
    pub fn file(&self) -> String {
        format!("{}.toml", self.name)
    }
}
