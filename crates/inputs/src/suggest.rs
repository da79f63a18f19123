//! "Did you mean …?"

/// Likeness of two words, from 0 to 1, from which one is suggested in place of the other.
const ALIKE: f64 = 0.6;

/// The key of a case that a name resembles most. The base is the first joint, and has its friction with the body.
pub fn closest_key<'a>(name: &str, keys: impl Iterator<Item = &'a str> + Clone) -> Option<String> {
    let of_base = name.strip_prefix("joint[1].").map(|key| format!("body.{key}"));
    let of_base = of_base.filter(|meant| keys.clone().any(|key| key == meant));
    of_base.or_else(|| closest(name, keys).map(str::to_owned))
}

/// The candidate most like `word`, upper and lower case alike, if any is like it. Of a key with its table, as `wave.heigth`, it is one of
/// that table where one is like it, whole or by one of its words: what tables have in common makes no likeness.
pub fn closest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let Some((table, key)) = word.rsplit_once('.') else { return most_like(word, pairs(candidates)) };
    let (own, others): (Vec<_>, Vec<_>) = pairs(candidates).partition(|(_, candidate)| {
        candidate.rsplit_once('.').is_some_and(|(other, _)| other.eq_ignore_ascii_case(table))
    });
    let keys = || own.iter().map(|(_, candidate)| (&candidate[table.len() + 1..], *candidate));
    let words = || keys().flat_map(|(key, candidate)| key.split('_').map(move |word| (word, candidate)));
    most_like(key, keys()).or_else(|| most_like(key, words())).or_else(|| most_like(word, others.into_iter()))
}

/// Candidates, each under its own name.
fn pairs<'a>(candidates: impl IntoIterator<Item = &'a str>) -> impl Iterator<Item = (&'a str, &'a str)> {
    candidates.into_iter().map(|candidate| (candidate, candidate))
}

/// What stands beside the name that is most like `word`.
fn most_like<'a>(word: &str, named: impl Iterator<Item = (&'a str, &'a str)>) -> Option<&'a str> {
    let word = word.to_lowercase();
    let likeness = |name: &str| strsim::normalized_damerau_levenshtein(&word, &name.to_lowercase());
    named
        .map(|(name, candidate)| (likeness(name), candidate))
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

#[cfg(test)]
mod tests {
    use super::closest;

    /// The keys of waves and of a body, as a case has them.
    const KEYS: [&str; 7] = [
        "wave.deep_water_height",
        "wave.period",
        "wave.berm_width",
        "wave.crest_height",
        "body.width",
        "body.friction",
        "load[1].force",
    ];

    #[test]
    fn a_key_is_looked_for_in_its_own_table() {
        let found = |word| closest(word, KEYS);
        assert_eq!(found("wave.heigth"), Some("wave.deep_water_height"));
        assert_eq!(found("wave.perid"), Some("wave.period"));
        assert_eq!(found("Wave.Period"), Some("wave.period"));
        assert_eq!(found("wave.width"), Some("wave.berm_width"));
        assert_eq!(found("load[1].forse"), Some("load[1].force"));
        // Of no key of its table it is one of another, and of an unknown table the whole counts.
        assert_eq!(found("wave.friction"), Some("body.friction"));
        assert_eq!(found("wav.period"), Some("wave.period"));
        assert_eq!(found("wave.zzzzzz"), None);
    }
}
