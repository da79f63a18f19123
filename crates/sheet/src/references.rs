//! Which writings stand behind a sheet, as a checker orders them. What is known of one only from memory, or from those who cite
//! it, says so; `docs/theory` says the same.

use maud::{Markup, html};
use standfast_cases::Case;

/// How far a source was at hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Known {
    /// It was read.
    Read,
    /// It was not read; title and place are known from those who cite it.
    Cited,
    /// It was not read, and title and place are told from memory.
    Recalled,
}

impl Known {
    fn words(self) -> &'static str {
        match self {
            Known::Read => "read",
            Known::Cited => "not read; year, journal and number from those who cite it, pages recalled",
            Known::Recalled => "recalled, not read",
        }
    }
}

/// A source.
struct Source {
    authors: &'static str,
    year: &'static str,
    title: &'static str,
    /// Journal or publisher, number, pages.
    place: &'static str,
    /// What of it is used.
    used: &'static str,
    known: Known,
    /// Whether it stands behind the sheet of a case.
    applies: fn(&Case) -> bool,
}

const SOURCES: [Source; 5] = [
    Source {
        authors: "Author not named",
        year: "no year",
        title: "Initiation of modes of response of a vertical caisson under a single concentrated horizontal force",
        place: "report; the copy read has no title page, and this title describes it",
        used: "modes of response; the equation numbers in parentheses",
        known: Known::Read,
        applies: |_| true,
    },
    Source {
        authors: "H. W. Shenton III",
        year: "1996",
        title: "Criteria for initiation of slide, rock, and slide-rock rigid-body modes",
        place: "Journal of Engineering Mechanics, ASCE, 122(7), 690–693",
        used: "the treatment of a shaken base, which the report follows",
        known: Known::Cited,
        applies: |_| true,
    },
    Source {
        authors: "Y. Goda",
        year: "2000",
        title: "Random Seas and Design of Maritime Structures",
        place: "2nd edition, World Scientific, Singapore; worked example p. 140",
        used: "wave heights and pressures; formulas from a specification that carries them, checked against published numbers",
        known: Known::Recalled,
        applies: |case| case.wave.is_some(),
    },
    Source {
        authors: "S. Takahashi, K. Tanimoto, K. Shimosako",
        year: "1994",
        title: "A proposal of impulsive pressure coefficient for the design of composite breakwaters",
        place: "Proceedings, Hydro-Port ’94, Yokosuka, 489–504",
        used: "the impulsive coefficient; formulas from a specification that carries them",
        known: Known::Recalled,
        applies: |case| case.wave.is_some(),
    },
    Source {
        authors: "H. M. Westergaard",
        year: "1933",
        title: "Water pressures on dams during earthquakes",
        place: "Transactions, ASCE, 98, 418–433",
        used: "the problem whose solution for incompressible water gives the added mass",
        known: Known::Recalled,
        applies: |case| case.added_mass.height().is_some(),
    },
];

/// The sources of a case.
pub fn list(case: &Case) -> Markup {
    html! {
        h3 { "References" }
        ol.references {
            @for source in SOURCES.iter().filter(|source| (source.applies)(case)) {
                li {
                    (source.authors) " (" (source.year) "), " cite { (source.title) } ". " (source.place) ". "
                    span.known { "Used: " (source.used) ". Known: " (source.known.words()) "." }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A source is told alike on the sheet and on the pages of the theory.
    #[test]
    fn the_pages_of_the_theory_have_the_same_sources() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/theory");
        let pages = ["1-initiation.md", "3-loads.md"].map(|page| {
            let text = std::fs::read_to_string(root.join(page)).unwrap();
            text.split_whitespace().collect::<Vec<_>>().join(" ").replace('*', "")
        });
        for source in SOURCES.iter().filter(|source| source.known != Known::Read) {
            let told = |page: &String| {
                [source.authors, source.year, source.title, source.place]
                    .iter()
                    .all(|part| page.contains(part))
            };
            assert!(pages.iter().any(told), "{} ({})", source.authors, source.year);
        }
    }
}
