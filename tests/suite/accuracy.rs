//! docs/accuracy.md says what the methods do, and agrees with values computed apart from this program.

use std::sync::LazyLock;

#[expect(dead_code, reason = "the entry point of the example")]
#[path = "../../examples/accuracy.rs"]
mod page;

/// Measured now.
static MEASURED: LazyLock<String> = LazyLock::new(|| page::document().expect("the examples are solvable"));

/// The cells of a table's row, or the whole line.
fn cells(line: &str) -> Vec<&str> {
    if line.starts_with('|') { line.trim_matches('|').split('|').map(str::trim).collect() } else { vec![line] }
}

/// A number of the page; rounding errors count as zero.
fn number(cell: &str) -> Option<f64> {
    if cell.starts_with("< ") { Some(0.0) } else { cell.parse().ok() }
}

/// Equal texts, times whatever they are, or numbers that differ by no more than a digit does, or that are rounding errors amplified by conditions.
fn agree(found: &str, stated: &str) -> bool {
    match (number(found), number(stated)) {
        (Some(a), Some(b)) => (a - b).abs() <= 0.1 * a.max(b) || (a.max(b) < 1e-12),
        _ => found == stated || (found.ends_with(" ms") && stated.ends_with(" ms")),
    }
}

#[test]
fn page_on_accuracy_is_what_the_example_measures() {
    let stated: Vec<&str> = include_str!("../../docs/accuracy.md").lines().collect();
    let found: Vec<&str> = MEASURED.lines().collect();
    for (found, stated) in found.iter().zip(&stated) {
        let (a, b) = (cells(found), cells(stated));
        let same = a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| agree(a, b));
        assert!(
            same,
            "docs/accuracy.md has\n{stated}\nmeasured is\n{found}\nits last section says how to write it again"
        );
    }
    assert_eq!(found.len(), stated.len(), "docs/accuracy.md has more or fewer lines than what is measured");
}

/// Half a unit of the last digit of a number as it is printed.
fn half_unit(printed: &str) -> f64 {
    let (mantissa, exponent) = printed.split_once('e').unwrap_or((printed, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let exponent: i32 = exponent.parse().expect("an exponent");
    0.5 * 10_f64.powi(exponent - i32::try_from(decimals).expect("few digits"))
}

#[test]
fn measured_accuracy_is_that_of_independent_computations() {
    let mut compared = 0;
    let mut columns = Vec::new();
    for line in MEASURED.lines().filter(|line| line.starts_with('|')) {
        let row = cells(line);
        if row.contains(&"independent") {
            columns = (0..row.len()).filter(|column| row[*column] == "independent").collect();
            continue;
        }
        for column in &columns {
            let (found, expected) = (row[column - 1], row[*column]);
            if let (Some(value), Some(reference)) = (number(found), number(expected)) {
                // Both numbers are rounded as printed; the grids differ at most in points between the largest values.
                let allowed = half_unit(found) + half_unit(expected) + 0.01 * reference;
                assert!((value - reference).abs() <= allowed, "{found}, not {expected}: {line}");
                compared += 1;
            }
        }
    }
    // 3 columns of 14 pictures, 9 rows of Eq. (19), 8 of (13), 2 of (27), 3 of each of the six static examples.
    assert_eq!(compared, 42 + 9 + 8 + 2 + 18);
}

#[test]
fn boundary_is_met_to_rounding_by_every_method_on_the_page() {
    for row in MEASURED.lines().map(cells) {
        let boundary = match row.len() {
            // A series that is cut off meets nothing.
            7 if row[0].starts_with("Fourier series") => continue,
            7 => row[3],
            11 => row[6],
            _ => continue,
        };
        assert!(["boundary", "---", "–", "< 5e-15"].contains(&boundary), "{row:?}");
    }
}
