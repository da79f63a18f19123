//! The library's words and symbols as HTML, and tables as CSV.

use std::ops::Range;

use standfast::Mode;
use standfast::loads::Reduced;
use standfast_figures::Map;

/// A mode's symbol: true signs as subscripts, a true prime.
pub fn symbol(mode: Mode) -> String {
    let plain = mode.symbol().replace('\'', "′");
    match plain.strip_suffix(['-', '+']) {
        Some(letters) => format!("{letters}<sub>{}</sub>", if plain.ends_with('-') { '−' } else { '+' }),
        None => plain,
    }
}

/// A place in a text, in units of UTF-16, as scripts count.
pub fn units_of_script(text: &str, place: &Range<usize>) -> [usize; 2] {
    [place.start, place.end].map(|end| text.get(..end).map_or(0, |before| before.encode_utf16().count()))
}

/// Mathematics in one line: single letters are italic, what is behind `_` is an index, primes and minus signs are true.
pub fn mathematics(text: &str) -> String {
    let text = text.replace('\'', "′").replace('<', "&lt;").replace('>', "&gt;");
    let letters: Vec<char> = text.chars().collect();
    let mut html = String::new();
    let mut entity = false;
    let mut after_index = 0;
    for (i, &letter) in letters.iter().enumerate() {
        if i < after_index {
            continue;
        }
        if letter == '_' {
            let index: String =
                letters[i + 1..].iter().take_while(|letter| letter.is_alphanumeric()).collect();
            after_index = i + 1 + index.chars().count();
            html.push_str(&format!("<sub>{index}</sub>"));
            continue;
        }
        entity = letter == '&' || entity && letter != ';';
        let alone = |at: Option<&char>| at.is_none_or(|other| !other.is_alphabetic());
        let before = i.checked_sub(1).and_then(|i| letters.get(i));
        // The letter of "case 1a" belongs to a name.
        let name = letter.is_ascii() && before.is_some_and(char::is_ascii_digit);
        let single = alone(before) && alone(letters.get(i + 1)) && !name;
        if letter.is_alphabetic() && single && !entity {
            html.push_str(&format!("<i>{letter}</i>"));
        } else {
            html.push(letter);
        }
    }
    html
}

/// The point of the case, its curves, then named points: what, k, μ.
pub fn curves_csv(map: &Map, case: &str, point: &Reduced) -> String {
    let (k, mu) = (point.point.k(), point.point.mu());
    let case = case.replace('"', "\"\"");
    let mut csv = format!("what,k,mu\n\"design point of {case}: {}\",{k},{mu}\n", point.mode());
    for (name, points) in map.curves(101) {
        for (k, mu) in points {
            csv.push_str(&format!("\"{name}\",{k},{mu}\n"));
        }
    }
    for point in map.diagram.chart().points() {
        csv.push_str(&format!("\"point {}\",{},{}\n", point.name.letter(), point.k, point.mu));
    }
    csv
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_have_true_signs() {
        let shown = [Mode::Rest, Mode::SlideRockOPrimeLeft, Mode::SlideRockORight].map(symbol);
        assert_eq!(shown, ["RE", "SRO′<sub>−</sub>", "SRO<sub>+</sub>"]);
    }

    #[test]
    fn letters_are_italic_where_they_stand_for_numbers() {
        assert_eq!(mathematics("μ ≥ k"), "<i>μ</i> ≥ <i>k</i>");
        assert_eq!(mathematics("μ < 1/γ − k k'"), "<i>μ</i> &lt; 1/<i>γ</i> − <i>k</i> <i>k</i>′");
        assert_eq!(
            mathematics("|f_x| ≤ μ_s f_y"),
            "|<i>f</i><sub>x</sub>| ≤ <i>μ</i><sub>s</sub> <i>f</i><sub>y</sub>"
        );
        assert_eq!(mathematics("after 3.8"), "after 3.8");
        assert_eq!(mathematics("case 1a: 3γ²"), "case 1a: 3<i>γ</i>²");
    }
}
