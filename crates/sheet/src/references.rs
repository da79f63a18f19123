//! References behind a sheet, as a checker orders them. What is known of one only from memory, or from those who cite
//! it, says so; `docs/theory` says the same.

use maud::{Markup, html};
use standfast::ground::bearing::GroundLaw;
use standfast_cases::Case;

/// Access to a source: read, or known from others.
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
    /// Parts of it that are used.
    used: &'static str,
    known: Known,
    /// True if it stands behind the sheet of a case.
    applies: fn(&Case) -> bool,
}

const SOURCES: [Source; 9] = [
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
    Source {
        authors: "European Committee for Standardization",
        year: "2004",
        title: "EN 1997-1, Eurocode 7: Geotechnical design, Part 1: General rules",
        place: "Annex D, bearing resistance of spread foundations",
        used: "bearing and inclination factors of a strip without cohesion; those of cohesion recalled",
        known: Known::Recalled,
        applies: |case| law(case) == Some(Law::Ec7),
    },
    Source {
        authors: "American Petroleum Institute",
        year: "2011",
        title: "API RP 2GEO, Geotechnical and foundation design considerations",
        place: "bearing capacity of shallow foundations, after J. Brinch Hansen",
        used: "bearing and inclination factors of a strip; checked against a program that carries them",
        known: Known::Recalled,
        applies: |case| law(case) == Some(Law::Hansen),
    },
    Source {
        authors: "R. Butterfield, G. Gottardi",
        year: "1994",
        title: "A complete three-dimensional failure envelope for shallow footings on sand",
        place: "Géotechnique, 44(1), 181–184",
        used: "the envelope of inclined and eccentric loads, its slopes and coupling",
        known: Known::Recalled,
        applies: |case| law(case) == Some(Law::Envelope),
    },
    Source {
        authors: "N. Allotey, M. H. El Naggar",
        year: "2003",
        title: "Analytical moment–rotation curves for rigid foundations based on a Winkler model",
        place: "Soil Dynamics and Earthquake Engineering, 23, 367–381",
        used: "the problem of springs that lift and yield; its solution is derived anew",
        known: Known::Recalled,
        applies: |case| case.ground.is_some_and(|ground| ground.stiffness.is_some()),
    },
];

/// By which formula the ground of a case bears.
#[derive(PartialEq)]
enum Law {
    Ec7,
    Hansen,
    Envelope,
}

fn law(case: &Case) -> Option<Law> {
    let soil = case.ground?.soil()?;
    Some(match (soil.friction_angle_deg(), soil.law()) {
        (None, _) => Law::Envelope,
        (_, Some(GroundLaw::Hansen)) => Law::Hansen,
        _ => Law::Ec7,
    })
}

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
        let pages = ["1-initiation.md", "3-loads.md", "5-base.md"].map(|page| {
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
