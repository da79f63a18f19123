//! "Did you mean …?"

/// Likeness of two words, from 0 to 1, from which one is suggested in place of the other.
const ALIKE: f64 = 0.6;

/// The candidate most like `word`, upper and lower case alike, if any is like it.
pub fn closest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.to_lowercase();
    let likeness = |candidate: &str| strsim::normalized_damerau_levenshtein(&word, &candidate.to_lowercase());
    candidates
        .into_iter()
        .map(|candidate| (likeness(candidate), candidate))
        .filter(|(likeness, _)| *likeness >= ALIKE)
        // Of several that are as like the first.
        .reduce(|best, other| if other.0 > best.0 { other } else { best })
        .map(|(_, candidate)| candidate)
}

/// Other names that people give a column, in small letters: the four numbers of the report's problem, and the eleven of the
/// general contact problem.
const OTHER_NAMES: [(&str, &[&str]); 15] = [
    ("gamma", &["γ", "slenderness", "h/b"]),
    ("k_prime", &["k'", "kprime", "kp", "elevation", "height"]),
    ("k", &["force", "f", "load"]),
    ("mu", &["μ", "friction", "friction coefficient"]),
    ("b1", &["b_1", "b₁"]),
    ("b2", &["b_2", "b₂"]),
    ("d", &["depth"]),
    ("rho2", &["rho^2", "ρ²"]),
    ("m_x", &["mx"]),
    ("m_y", &["my"]),
    ("x", &["f_x", "horizontal"]),
    ("p", &["vertical"]),
    ("m", &["moment"]),
    ("mu_s", &["μ_s", "mus", "static friction"]),
    ("mu_k", &["μ_k", "muk", "kinetic friction"]),
];

/// Other names that people give columns of a case, in small letters, and the last part of the key.
const KEY_NAMES: [(&str, &[&str]); 7] = [
    ("period", &["tp", "ts", "tm", "t13", "t1/3", "tm-1,0", "tm02"]),
    ("H13", &["hs", "hm0", "h1/3", "h_s", "significant wave height"]),
    ("deep_water_height", &["h0", "h0'", "h_0"]),
    ("water_level", &["wl", "swl", "tide", "level", "sea level"]),
    ("angle_deg", &["beta", "β", "dir", "direction", "mwd"]),
    ("friction", &["mu", "μ", "friction coefficient"]),
    ("horizontal", &["pga", "kh", "k_h"]),
];

/// Last part of the key that a column is often meant by.
pub fn key_meant(column: &str) -> Option<&'static str> {
    let column = column.to_lowercase();
    KEY_NAMES.iter().find(|(_, others)| others.contains(&column.as_str())).map(|(key, _)| *key)
}

/// Of the columns `found` in a table the one that is most likely meant by `column`, of the columns `needed`.
pub fn similar<'a>(column: &str, found: &[&'a str], needed: &[&str]) -> Option<&'a str> {
    let other = OTHER_NAMES.iter().find(|(name, _)| *name == column).map_or(&[][..], |(_, others)| others);
    let others = || std::iter::once(&column).chain(other).copied();
    let free = || found.iter().copied().filter(|name| !needed.contains(name));
    let exact = free().find(|name| others().any(|other| other == name.to_lowercase()));
    exact.or_else(|| others().find_map(|other| closest(other, free())))
}
