//! References behind a sheet, as a checker orders them. `docs/trust/references.md` says which of them were read.

use maud::{Markup, html};
use standfast::ground::bearing::GroundLaw;
use standfast_cases::Case;
use standfast_cases::case::{CrownWall, WaveFormula};

/// A source.
struct Source {
    authors: &'static str,
    year: &'static str,
    title: &'static str,
    /// Journal or publisher, number, pages.
    place: &'static str,
    /// Parts of it that are used.
    used: &'static str,
    /// True if it stands behind the sheet of a case.
    applies: fn(&Case) -> bool,
}

const SOURCES: [Source; 12] = [
    Source {
        authors: "Author not named",
        year: "no year",
        title: "Initiation of modes of response of a vertical caisson under a single concentrated horizontal force",
        place: "report; the copy at hand has no title page, and this title describes it",
        used: "modes of response; the equation numbers in parentheses",
        applies: |_| true,
    },
    Source {
        authors: "H. W. Shenton III",
        year: "1996",
        title: "Criteria for initiation of slide, rock, and slide-rock rigid-body modes",
        place: "Journal of Engineering Mechanics, ASCE, 122(7), 690–693",
        used: "the treatment of a shaken base, which the report follows",
        applies: |_| true,
    },
    Source {
        authors: "Y. Goda",
        year: "2000",
        title: "Random Seas and Design of Maritime Structures",
        place: "2nd edition, World Scientific, Singapore; worked example p. 140",
        used: "wave heights and pressures; formulas from a specification that carries them, checked against published numbers",
        applies: |case| case.goda().is_some(),
    },
    Source {
        authors: "S. Takahashi, K. Tanimoto, K. Shimosako",
        year: "1994",
        title: "A proposal of impulsive pressure coefficient for the design of composite breakwaters",
        place: "Proceedings, Hydro-Port ’94, Yokosuka, 489–504",
        used: "the impulsive coefficient; formulas from a specification that carries them",
        applies: |case| case.goda().is_some(),
    },
    Source {
        authors: "G. Sainflou",
        year: "1928",
        title: "Essai sur les digues maritimes verticales",
        place: "Annales des Ponts et Chaussées, 98(4), 5–48",
        used: "standing waves, their linear form from a specification that carries it",
        applies: |case| matches!(formula(case), Some(WaveFormula::Sainflou(_))),
    },
    Source {
        authors: "U.S. Army Corps of Engineers",
        year: "2002",
        title: "Coastal Engineering Manual",
        place: "EM 1110-2-1100, Part VI, Chapter 5, table VI-5-61",
        used: "Pedersen’s forces on crown walls, as coded in an open toolbox",
        applies: |case| crown(case).is_some_and(|wall| matches!(wall, CrownWall::Pedersen(_))),
    },
    Source {
        authors: "M. R. A. van Gent, I. M. van der Werf",
        year: "2019",
        title: "Influence of oblique wave attack on wave overtopping and forces on rubble mound breakwater crest walls",
        place: "Coastal Engineering, 151, 78–96, doi 10.1016/j.coastaleng.2019.04.001",
        used: "forces on crown walls, as coded in an open toolbox",
        applies: |case| crown(case).is_some_and(|wall| matches!(wall, CrownWall::VanGent(_))),
    },
    Source {
        authors: "H. M. Westergaard",
        year: "1933",
        title: "Water pressures on dams during earthquakes",
        place: "Transactions, ASCE, 98, 418–433",
        used: "the problem whose solution for incompressible water gives the added mass",
        applies: |case| case.added_mass.height().is_some(),
    },
    Source {
        authors: "European Committee for Standardization",
        year: "2004",
        title: "EN 1997-1, Eurocode 7: Geotechnical design, Part 1: General rules",
        place: "Annex D, bearing resistance of spread foundations",
        used: "bearing, inclination and shape factors",
        applies: |case| law(case) == Some(Law::Ec7),
    },
    Source {
        authors: "American Petroleum Institute",
        year: "2011",
        title: "API RP 2GEO, Geotechnical and foundation design considerations",
        place: "bearing capacity of shallow foundations, after J. Brinch Hansen",
        used: "bearing, inclination and shape factors; checked against a program that carries them",
        applies: |case| law(case) == Some(Law::Hansen),
    },
    Source {
        authors: "R. Butterfield, G. Gottardi",
        year: "1994",
        title: "A complete three-dimensional failure envelope for shallow footings on sand",
        place: "Géotechnique, 44(1), 181–184",
        used: "the envelope of inclined and eccentric loads, its slopes and coupling",
        applies: |case| law(case) == Some(Law::Envelope),
    },
    Source {
        authors: "N. Allotey, M. H. El Naggar",
        year: "2003",
        title: "Analytical moment–rotation curves for rigid foundations based on a Winkler model",
        place: "Soil Dynamics and Earthquake Engineering, 23, 367–381",
        used: "the problem of springs that lift and yield; its solution is derived anew",
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
        _ if soil.undrained_strength().is_some() => Law::Ec7,
        (None, _) => Law::Envelope,
        (_, Some(GroundLaw::Hansen)) => Law::Hansen,
        _ => Law::Ec7,
    })
}

/// The formula of its waves.
fn formula(case: &Case) -> Option<&WaveFormula> {
    case.wave.as_ref().map(|wave| &wave.formula)
}

/// Its crown wall.
fn crown(case: &Case) -> Option<CrownWall> {
    match formula(case)? {
        WaveFormula::Crown(waves) => Some(waves.wall),
        _ => None,
    }
}

/// The sources of a case.
pub fn list(case: &Case) -> Markup {
    html! {
        h3 { "References" }
        ol.references {
            @for source in SOURCES.iter().filter(|source| (source.applies)(case)) {
                li {
                    (source.authors) " (" (source.year) "), " cite { (source.title) } ". " (source.place) ". "
                    span.known { "Used: " (source.used) "." }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The page that says which sources were read has each of them.
    #[test]
    fn the_page_of_references_has_every_source() {
        let page = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/trust/references.md");
        let page = std::fs::read_to_string(page).unwrap().replace('*', "");
        let entries: Vec<&str> = page.split("\n").collect();
        for source in &SOURCES {
            let family = source.authors.split(',').next().unwrap_or_default();
            let is_it = |entry: &&&str| {
                entry.contains(source.title)
                    && (source.year == "no year" || entry.contains(source.year) && entry.contains(family))
            };
            assert!(
                entries.iter().find(is_it).is_some(),
                "{} ({}): {}",
                source.authors,
                source.year,
                source.title
            );
        }
    }
}
