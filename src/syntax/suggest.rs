//! "Did you mean …?"

/// The candidate that is most like a name, if any is like enough. The threshold is CPython's: about
/// one slip in three letters; a transposition counts as one slip, as a change of case nearly does.
pub fn suggest<'c, I>(name: &str, candidates: I) -> Option<&'c str>
where
    I: IntoIterator<Item = &'c str>,
{
    if name.is_empty() || name.len() > MAX_NAME {
        return None;
    }
    let length = name.chars().count();
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates.into_iter().take(MAX_CANDIDATES) {
        if candidate == name || candidate.is_empty() || candidate.len() > MAX_NAME {
            continue;
        }
        let limit = (length + candidate.chars().count() + 3) * SLIP / 6;
        let distance = distance(name, candidate);
        if distance <= limit && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// As CPython: longer names are not compared, and no more candidates than these.
const MAX_NAME: usize = 40;
const MAX_CANDIDATES: usize = 750;
/// What a slip costs; a letter in the wrong case costs half.
const SLIP: usize = 2;

fn distance(name: &str, candidate: &str) -> usize {
    let exact = strsim::damerau_levenshtein(name, candidate);
    let folded = strsim::damerau_levenshtein(&name.to_lowercase(), &candidate.to_lowercase());
    folded * SLIP + exact.saturating_sub(folded).min(1)
}

#[cfg(test)]
mod tests {
    use super::suggest;

    #[test]
    fn near_names_are_found() {
        let names = ["nightstand", "bed", "scene", "STANDING", "X_MAX", "X_MIN", "chairs", "e"];
        assert_eq!(suggest("nigthstand", names), Some("nightstand"));
        assert_eq!(suggest("Scene", names), Some("scene"));
        assert_eq!(suggest("standing", names), Some("STANDING"));
        assert_eq!(suggest("chair", names), Some("chairs"));
        assert_eq!(suggest("X_MX", names), Some("X_MAX"));
    }

    #[test]
    fn far_names_are_not() {
        assert_eq!(suggest("lamp", ["bed", "scene"]), None);
        assert_eq!(suggest("bed", ["bed"]), None);
        assert_eq!(suggest("x", ["y"]), None);
        assert_eq!(suggest("", ["a"]), None);
        assert_eq!(suggest(&"a".repeat(10_000), ["aaaa"]), None);
    }
}
