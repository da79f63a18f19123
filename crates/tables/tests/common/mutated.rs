//! Texts that are wrong somewhere: of tables here, of case files in the program's tests.

use proptest::prelude::*;

/// A text with a piece cut out and something else put in its place: a number, a quote, `odd`, or what no keyboard has.
pub fn mutated(text: &'static str, odd: &'static [&'static str]) -> impl Strategy<Value = Vec<u8>> {
    let bytes = text.as_bytes();
    let values = prop_oneof![
        any::<f64>().prop_map(|x| x.to_string()),
        Just("inf".to_owned()),
        prop::sample::select(odd).prop_map(str::to_owned),
        Just("\"".to_owned()),
        Just("\r\n\t\u{feff}é🌊".to_owned()),
        "\\PC{0,12}",
    ];
    (0..=bytes.len(), 0..20_usize, values).prop_map(move |(start, length, value)| {
        let end = (start + length).min(bytes.len());
        [&bytes[..start], value.as_bytes(), &bytes[end..]].concat()
    })
}

/// Numbers of every size the mechanics takes, and some beyond.
pub fn number() -> impl Strategy<Value = f64> {
    prop_oneof![4 => (1.0..10.0, -52..52).prop_map(|(x, n)| x * 10_f64.powi(n)), 1 => 0.0..3.0, 1 => Just(0.0)]
}
