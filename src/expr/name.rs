//! Names: every spelling of a name has one canonical ASCII form, and a Unicode form for reading.

/// Greek letters with their ASCII names; variant glyphs follow the letter they stand for.
const GREEK: &[(char, &str)] = &[
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('ο', "omicron"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Γ', "Gamma"),
    ('Δ', "Delta"),
    ('Θ', "Theta"),
    ('Λ', "Lambda"),
    ('Ξ', "Xi"),
    ('Π', "Pi"),
    ('Σ', "Sigma"),
    ('Υ', "Upsilon"),
    ('Φ', "Phi"),
    ('Ψ', "Psi"),
    ('Ω', "Omega"),
    ('ϵ', "epsilon"),
    ('ϑ', "theta"),
    ('ϕ', "phi"),
    ('ϱ', "rho"),
    ('ς', "sigma"),
    ('ϖ', "pi"),
    ('µ', "mu"),
];

/// The ASCII name of a Greek letter, for example `beta` for `β`.
#[must_use]
pub fn greek_letter(letter: char) -> Option<&'static str> {
    GREEK.iter().find(|(greek, _)| *greek == letter).map(|(_, name)| *name)
}

/// The Greek letter with an ASCII name, for example `β` for `beta`.
#[must_use]
pub fn greek_named(name: &str) -> Option<char> {
    GREEK.iter().find(|(_, known)| *known == name).map(|(letter, _)| *letter)
}

/// The one ASCII form of all spellings of a name: `b₁`, `b_1` and `b_{1}` become `b1`, `β` becomes `beta`,
/// primes become `'` and come last, since `h'_0` and `h_0'` are one name; an underscore before a letter is kept.
#[must_use]
pub fn canonical_name(spelling: &str) -> String {
    let mut name = String::with_capacity(spelling.len());
    let (mut primes, mut in_subscript) = (0, false);
    let mut letters = spelling.chars().filter(|c| !matches!(c, '{' | '}')).peekable();
    while let Some(letter) = letters.next() {
        if matches!(letter, '′' | '\'') {
            primes += 1;
            continue;
        }
        let digit = subscript_digit(letter).or(Some(letter).filter(char::is_ascii_digit));
        in_subscript |= letter == '_';
        if digit.is_none() && !in_subscript {
            name.push_str(&"'".repeat(std::mem::take(&mut primes)));
        }
        if let Some(greek) = greek_letter(letter) {
            name.push_str(greek);
        } else if let Some(digit) = digit {
            name.push(digit);
        } else if letter != '_' || !letters.peek().is_some_and(char::is_ascii_digit) {
            name.push(letter);
        }
    }
    name + &"'".repeat(primes)
}

/// The form for reading: `b1` becomes `b₁`, `beta` becomes `β`, `h0'` becomes `h₀′`.
#[must_use]
pub fn unicode_name(canonical: &str) -> String {
    let stem_end = canonical.find(|c: char| c.is_ascii_digit() || c == '\'' || c == '_').unwrap_or(canonical.len());
    let (stem, rest) = canonical.split_at(stem_end);
    let greek = GREEK.iter().find(|(_, name)| *name == stem).map(|(letter, _)| letter.to_string());
    let tail: String = rest
        .chars()
        .map(|c| match c {
            '0'..='9' => char::from_u32(u32::from('₀') + u32::from(c) - u32::from('0')).unwrap_or(c),
            '\'' => '′',
            _ => c,
        })
        .collect();
    // A digit after a kept underscore would read back without it; leave such names in ASCII.
    if rest.contains('_') { canonical.to_owned() } else { greek.unwrap_or_else(|| stem.to_owned()) + &tail }
}

fn subscript_digit(letter: char) -> Option<char> {
    let value = u32::from(letter).checked_sub(u32::from('₀')).filter(|value| *value < 10)?;
    char::from_digit(value, 10)
}

/// `b1` as `b_{1}`, `beta` as `\beta`, longer names upright, and those whose subscript has parts: `S1_x`.
pub(super) fn latex_name(canonical: &str) -> String {
    let plain = canonical.trim_end_matches('\'');
    if let Some((stem, subscript)) = plain.split_once('_')
        && (subscript.contains('_') || stem.contains(|c: char| c.is_ascii_digit()))
    {
        let primes = canonical.get(plain.len()..).unwrap_or_default();
        return format!(r"\mathrm{{{stem}_{{{subscript}}}}}{primes}");
    }
    let stem_end = canonical.find(|c: char| c.is_ascii_digit() || c == '\'' || c == '_').unwrap_or(canonical.len());
    let (stem, rest) = canonical.split_at(stem_end);
    let primes = rest.chars().filter(|c| *c == '\'').count();
    let subscript: String = rest.chars().filter(|c| !matches!(c, '\'' | '_')).collect();
    let is_greek = unicode_name(stem).chars().next().and_then(greek_letter).is_some_and(|name| name == stem);
    let stem = match stem.chars().count() {
        1 => stem.to_owned(),
        // TeX has no command for it.
        _ if stem == "omicron" => "ο".to_owned(),
        // `\pi` is always the number.
        _ if is_greek && stem != "pi" => format!(r"\{stem}"),
        _ => format!(r"\mathrm{{{stem}}}"),
    };
    let subscript = if subscript.is_empty() { String::new() } else { format!("_{{{subscript}}}") };
    format!("{stem}{}{subscript}", "'".repeat(primes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_spellings_of_a_name_have_one_form() {
        for spelling in ["b_1", "b₁", "b_{1}", "b1"] {
            assert_eq!(canonical_name(spelling), "b1");
        }
        assert_eq!(canonical_name("β"), "beta");
        for spelling in ["h0′", "h_0'", "h'_0", "h'_{0}"] {
            assert_eq!(canonical_name(spelling), "h0'");
        }
        assert_eq!(canonical_name("r_max"), "r_max");
    }

    #[test]
    fn parts_of_a_subscript_stay_apart_in_latex() {
        let spelled = ["b1", "r_max", "r_x1", "S1_x", "a_b_c", "h1_x'"].map(latex_name);
        let expected = ["b_{1}", "r_{max}", "r_{x1}", r"\mathrm{S1_{x}}", r"\mathrm{a_{b_c}}", r"\mathrm{h1_{x}}'"];
        assert_eq!(spelled, expected);
    }

    #[test]
    fn unicode_form_reads_back_as_the_same_name() {
        for name in ["b1", "beta", "beta12", "h0'", "r_max", "eta_x", "theta", "x"] {
            assert_eq!(canonical_name(&unicode_name(name)), name);
        }
    }
}
