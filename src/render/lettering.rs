//! Digits, the label with the instant, and the legend of a scale.

use super::color::{INK, Rgb};
use super::picture::Picture;

/// Five columns of seven pixels, the lowest bit on top.
const GLYPHS: [(char, [u8; 5]); 18] = [
    ('0', [0x3e, 0x51, 0x49, 0x45, 0x3e]),
    ('1', [0x00, 0x42, 0x7f, 0x40, 0x00]),
    ('2', [0x62, 0x51, 0x49, 0x49, 0x46]),
    ('3', [0x22, 0x41, 0x49, 0x49, 0x36]),
    ('4', [0x18, 0x14, 0x12, 0x7f, 0x10]),
    ('5', [0x27, 0x45, 0x45, 0x45, 0x39]),
    ('6', [0x3c, 0x4a, 0x49, 0x49, 0x30]),
    ('7', [0x01, 0x71, 0x09, 0x05, 0x03]),
    ('8', [0x36, 0x49, 0x49, 0x49, 0x36]),
    ('9', [0x06, 0x49, 0x49, 0x29, 0x1e]),
    ('.', [0x00, 0x60, 0x60, 0x00, 0x00]),
    ('-', [0x08, 0x08, 0x08, 0x08, 0x08]),
    ('=', [0x14, 0x14, 0x14, 0x14, 0x14]),
    ('e', [0x38, 0x54, 0x54, 0x54, 0x18]),
    ('t', [0x04, 0x3f, 0x44, 0x40, 0x20]),
    ('<', [0x08, 0x14, 0x22, 0x41, 0x00]),
    ('>', [0x00, 0x41, 0x22, 0x14, 0x08]),
    (' ', [0x00, 0x00, 0x00, 0x00, 0x00]),
];

const GLYPH_HEIGHT: usize = 7;
/// Five columns and one between letters.
const ADVANCE: usize = 6;

/// Writes the instant into the lower left corner.
pub(super) fn label(picture: &mut Picture, time: f64) {
    let size = letter_size(picture);
    let margin = 4 * size;
    let top = picture.height().saturating_sub(margin + GLYPH_HEIGHT * size);
    write(picture, &format!("t = {}", short(time)), (margin, top), size);
}

/// Draws a bar with the colours of a scale at the right edge, its largest value above and its least below; signs
/// before them say that there are values beyond.
pub(super) fn legend(picture: &mut Picture, [low, high]: [f64; 2], is_exceeded: bool, color: impl Fn(f64) -> Rgb) {
    let size = letter_size(picture);
    let (margin, width, letters) = (4 * size, 7 * size, GLYPH_HEIGHT * size);
    let (top, bottom) = (margin + letters + 2 * size, picture.height().saturating_sub(margin + letters + 2 * size));
    let left = picture.width().saturating_sub(margin + width);
    for y in top..bottom {
        // The middle of the first row is the largest value but for half a row.
        let share = 1.0 - ((y - top) as f64 + 0.5) / (bottom - top) as f64;
        for x in left..left + width {
            picture.set(x, y, color(share));
        }
    }
    for (value, sign, top) in [(high, ">", margin), (low, "<", bottom + 2 * size)] {
        let text = format!("{}{}", if is_exceeded { sign } else { "" }, short(value));
        let start = picture.width().saturating_sub(margin + (text.len() * ADVANCE - 1) * size);
        write(picture, &text, (start, top), size);
    }
}

/// Pixels of the picture to a pixel of a letter.
fn letter_size(picture: &Picture) -> usize {
    (picture.width().min(picture.height()) / 240).max(1)
}

/// Four significant digits at most, three before an exponent.
fn short(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".to_owned();
    }
    if (1e-3..1e5).contains(&size) {
        let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
        return format!("{rounded}");
    }
    // Not parsed again: the largest double rounds to more than doubles hold.
    let text = format!("{value:.2e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    format!("{}e{exponent}", digits.trim_end_matches('0').trim_end_matches('.'))
}

fn write(picture: &mut Picture, text: &str, (left, top): (usize, usize), size: usize) {
    for (place, letter) in text.chars().enumerate() {
        let Some((_, columns)) = GLYPHS.iter().find(|(glyph, _)| *glyph == letter) else { continue };
        for (column, bits) in columns.iter().enumerate() {
            for row in (0..GLYPH_HEIGHT).filter(|row| bits >> row & 1 == 1) {
                for (x, y) in (0..size).flat_map(|x| (0..size).map(move |y| (x, y))) {
                    picture.set(left + (place * ADVANCE + column) * size + x, top + row * size + y, INK);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_digits_at_most() {
        let values = [0.0, 0.1, -2.5, 1.0 / 3.0, 12345.678, 1e5, 1e-300, 6.02214e23, -1.234567e-9];
        let texts = ["0", "0.1", "-2.5", "0.3333", "12350", "1e5", "1e-300", "6.02e23", "-1.23e-9"];
        assert_eq!(values.map(short), texts);
    }

    #[test]
    fn every_character_of_a_number_has_a_glyph() {
        for value in [f64::MIN, 1.0 / 3.0, 1e-300, -0.0, 456_789.0] {
            let text = format!("t = <>{}", short(value));
            assert!(text.chars().all(|c| GLYPHS.iter().any(|(glyph, _)| *glyph == c)), "{text}");
        }
    }
}
