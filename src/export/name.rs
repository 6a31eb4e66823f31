//! Names as line-based formats can bear them.

use crate::diagnostic::is_deceptive;

/// `name` on one line: what would end the line, continue it, or disguise it becomes `_`.
pub(super) fn on_one_line(name: &str) -> String {
    // A backslash at the end of a line of OBJ continues it; U+2028 and U+2029 are line ends to some readers.
    let breaks = |c: char| c.is_control() || is_deceptive(c) || matches!(c, '\\' | '\u{2028}' | '\u{2029}');
    let line: String = name.trim().chars().map(|c| if breaks(c) { '_' } else { c }).collect();
    if line.is_empty() { "unnamed".to_owned() } else { line }
}

/// `name` on one line of ASCII: other characters are written as `u+3b1`.
pub(super) fn in_ascii(name: &str) -> String {
    on_one_line(name)
        .chars()
        .map(|c| if c.is_ascii() { c.to_string() } else { format!("u+{:x}", u32::from(c)) })
        .collect()
}

/// Each name as a word of ASCII letters, digits and underscores that begins with a letter, all of them different.
pub(super) fn distinct_words<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for name in names {
        let mut word: String = in_ascii(name).replace("u+", "u").chars().map(word_character).collect();
        if !word.starts_with(|c: char| c.is_ascii_alphabetic()) {
            word.insert_str(0, "patch_");
        }
        let repeated = (2..).map(|copy| format!("{word}_{copy}"));
        let free = std::iter::once(word.clone()).chain(repeated).find(|candidate| !words.contains(candidate));
        words.extend(free);
    }
    words
}

fn word_character(c: char) -> char {
    if c.is_ascii_alphanumeric() { c } else { '_' }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_and_greek_names_are_kept_on_one_line() {
        assert_eq!(on_one_line("left wing"), "left wing");
        assert_eq!(on_one_line("α2"), "α2");
    }

    #[test]
    fn line_ends_and_invisible_characters_become_underscores() {
        assert_eq!(on_one_line("a\nv 1 2 3\r\tb\u{1b}[31m"), "a_v 1 2 3__b_[31m");
        assert_eq!(on_one_line("a\u{202e}b\u{2028}c\u{85}d\\"), "a_b_c_d_");
    }

    #[test]
    fn blank_name_is_replaced() {
        assert_eq!(on_one_line(" \n "), "unnamed");
    }

    #[test]
    fn greek_name_in_ascii_shows_its_code() {
        assert_eq!(in_ascii("cup α\n2"), "cup u+3b1_2");
    }

    #[test]
    fn words_are_distinct_and_begin_with_a_letter() {
        let names = ["left wing", "α", "left_wing", "left-wing", "3", ""];
        let words = ["left_wing", "u3b1", "left_wing_2", "left_wing_3", "patch_3", "unnamed"];
        assert_eq!(distinct_words(names.into_iter()), words);
    }
}
