//! IGES 5.3: each face as a rational B-spline surface (entity 128) whose weights are one.

use std::fmt::Write;

use super::Face;
use super::part21::with_point;
use crate::export::name::in_ascii;

/// A line holds so many characters of data, in its global and in its parameter section.
const GLOBAL_COLUMNS: usize = 72;
const PARAMETER_COLUMNS: usize = 64;

/// A surface's line count and pointers have seven columns; what is longer than that has no place in the format.
pub(super) fn text(name: &str, faces: &[Face]) -> String {
    let mut file = String::new();
    // Writing to a string does not fail.
    let _ = writeln!(file, "{:<72}S{:>7}", "B-spline surfaces, lengths in millimetres", 1);
    let global = packed(&global(name, faces), GLOBAL_COLUMNS);
    for (index, line) in global.iter().enumerate() {
        let _ = writeln!(file, "{line:<72}G{:>7}", index + 1);
    }
    let parameters: Vec<Vec<String>> = faces.iter().map(|face| packed(&surface(face), PARAMETER_COLUMNS)).collect();
    let mut first = 1;
    for (index, (face, lines)) in faces.iter().zip(&parameters).enumerate() {
        let label: String = in_ascii(&face.name).chars().take(8).collect();
        let zero = 0;
        let _ = writeln!(
            file,
            "{:>8}{first:>8}{zero:>8}{zero:>8}{zero:>8}{zero:>8}{zero:>8}{zero:>8}00000000D{:>7}",
            128,
            2 * index + 1
        );
        let _ = writeln!(
            file,
            "{:>8}{zero:>8}{zero:>8}{:>8}{zero:>8}{:>8}{:>8}{label:>8}{zero:>8}D{:>7}",
            128,
            lines.len(),
            "",
            "",
            2 * index + 2
        );
        first += lines.len();
    }
    let mut sequence = 0;
    for (index, line) in
        parameters.iter().enumerate().flat_map(|(index, lines)| lines.iter().map(move |line| (index, line)))
    {
        sequence += 1;
        let _ = writeln!(file, "{line:<64} {:>7}P{sequence:>7}", 2 * index + 1);
    }
    let _ = writeln!(file, "S{:>7}G{:>7}D{:>7}P{sequence:>7}{:>40}T{:>7}", 1, global.len(), 2 * faces.len(), "", 1);
    file
}

/// Fields, separated by commas and ended by a semicolon, on lines of at most `columns` characters.
fn packed(fields: &[String], columns: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for (index, field) in fields.iter().enumerate() {
        let end = if index + 1 == fields.len() { ';' } else { ',' };
        for piece in pieces(&format!("{field}{end}"), columns) {
            match lines.last_mut() {
                Some(line) if line.len() + piece.len() <= columns => line.push_str(&piece),
                _ => lines.push(piece),
            }
        }
    }
    lines
}

/// A field in pieces that fit on a line; only strings are longer than one, and may be broken anywhere.
fn pieces(field: &str, columns: usize) -> Vec<String> {
    field.as_bytes().chunks(columns).map(|piece| String::from_utf8_lossy(piece).into_owned()).collect()
}

/// A Hollerith string: its length, then itself.
fn hollerith(text: &str) -> String {
    format!("{}H{text}", text.len())
}

fn global(name: &str, faces: &[Face]) -> Vec<String> {
    let largest = faces.iter().map(|face| face.surface.size()).fold(0.0, f64::max);
    // A breakable string would lose its blanks at a line's end; names are cut to what fits.
    let name: String = in_ascii(name).chars().take(40).collect();
    let program = format!("trimline {}", env!("CARGO_PKG_VERSION"));
    // The format wants a date; there is no clock here.
    let date = || hollerith("19700101.000000");
    vec![
        hollerith(","),
        hollerith(";"),
        hollerith(&name),
        hollerith(&name),
        hollerith(&program),
        hollerith(&program),
        "32".to_owned(),
        "38".to_owned(),
        "6".to_owned(),
        "308".to_owned(),
        "15".to_owned(),
        hollerith(&name),
        "1.".to_owned(),
        "2".to_owned(),
        hollerith("MM"),
        "1".to_owned(),
        "0.1".to_owned(),
        date(),
        real(1e-7),
        real(largest),
        String::new(),
        String::new(),
        "11".to_owned(),
        "0".to_owned(),
        date(),
    ]
}

/// A double, with the fewest digits that read back to it.
fn real(x: f64) -> String {
    with_point(x, 'D')
}

fn surface(face: &Face) -> Vec<String> {
    let [u, v] = face.surface.knots();
    let flag = |is_true: bool| u8::from(is_true).to_string();
    let closes_in_u = face.surface.rows().next() == face.surface.rows().next_back();
    let closes_in_v = face.surface.rows().all(|row| row.first() == row.last());
    let numbers = [u.points() - 1, v.points() - 1, u.degree(), v.degree()];
    let mut fields = vec!["128".to_owned()];
    fields.extend(numbers.map(|number| number.to_string()));
    fields.extend([flag(closes_in_u), flag(closes_in_v), "1".to_owned(), "0".to_owned(), "0".to_owned()]);
    fields.extend(u.as_slice().iter().chain(v.as_slice()).map(|knot| real(*knot)));
    fields.extend(face.surface.net().iter().map(|_| "1.".to_owned()));
    // u runs first.
    fields.extend(face.surface.transposed().net().iter().flatten().map(|x| real(*x)));
    fields.extend([u, v].into_iter().flat_map(|knots| knots.domain()).map(real));
    // No associated and no property entities.
    fields.extend(["0".to_owned(), "0".to_owned()]);
    fields
}
