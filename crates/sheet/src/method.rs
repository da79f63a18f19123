//! Assumptions and method, in words.

use maud::{Markup, html};
use standfast_cases::Assessment;

pub fn words(assessment: &Assessment) -> Markup {
    let case = &assessment.case;
    html! {
        ul {
            li { "Body and base are rigid. Friction is dry (Coulomb). Forces act in the plane of the cross-section." }
            li {
                "The motion is that of the first instant after the load is applied to a body at rest: which mode begins, with which \
                 accelerations and reactions. What becomes of it later is not computed."
            }
            li {
                "Signs: x to the right, y upwards, rotation counter-clockwise. O is the bottom left corner of the base, O′ the \
                 bottom right one."
                @if case.wave.is_some() { " The sea is at the right; waves push to the left, and O is the heel." }
            }
            li { "Weight: " (case.weight_words()) "." }
            li {
                "Permanent and variable loads act together. Variable ones (waves with their uplift, earthquakes, forces) are \
                 applied at once for the mode of response, and raised in proportion for the load path."
                @if case.forces.iter().filter(|force| force.acts_alone()).count() > 1 && case.combinations.is_empty() {
                    " Of the forces that act alone, each is an alternative to the others."
                }
                @if !case.combinations.is_empty() {
                    " Loads act as the combinations of the case file say, each times its factor; the factors are the case \
                     file’s. The body’s mass, its inertia and the friction carry no factor."
                }
            }
            @if let Some(wave) = &case.wave {
                li {
                    "Wave pressures after Goda"
                    @if wave.choices.impulsive { " with Takahashi’s coefficient for impulsive breaking" }
                    @else { " without the coefficient for impulsive breaking" }
                    @if wave.choices.uplift { "; the uplift is a triangle from the seaward toe to the heel." }
                    @else { "; the waves do not press under the base, as the case file says." }
                    @if wave.choices.turn_deg == 0.0 { " The angle of the waves is used as given, not turned towards the normal." }
                }
            }
            @if case.water.is_some() {
                li { "Still water presses on the sides and under the whole base, linearly from one edge of the base to the other." }
            }
            @if !case.pressures.is_empty() {
                li { "Pressures that the case file gives are linear from point to point, and nothing outside." }
            }
            @if case.added_mass.mass() > 0.0 {
                li { "Water that moves with the body adds to its inertia against horizontal acceleration." }
            }
            @if case.earthquake.is_some() {
                li { "An acceleration of the base acts as a force of inertia; the motion is relative to the base." }
            }
            li {
                "Classical factors are taken about both edges of the base; " span.sym { "W′" } ", t, U, "
                span.sym { "M" sub { "U" } } ", P, " span.sym { "M" sub { "p" } } " are a designer’s symbols."
            }
        }
        p.note { "References" }
        ul {
            li {
                "The report on initiation of modes of response of vertical caissons (after Shenton’s treatment of earthquakes); its \
                 equation numbers stand in parentheses."
            }
            li { "H. W. Shenton III (1996), Journal of Engineering Mechanics 122(7): response of a rigid block to base excitation." }
            @if case.wave.is_some() {
                li { "Y. Goda, Random Seas and Design of Maritime Structures: wave heights and pressures." }
                li { "S. Takahashi, K. Tanimoto and K. Shimosako (1994): the impulsive coefficient." }
            }
        }
    }
}
