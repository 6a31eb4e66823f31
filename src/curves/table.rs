//! A table of points: rows of x, y and z, with or without a line of names above them.

/// What is wrong with a table, in words that name row and column.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TableFault {
    /// The bytes are no text.
    #[error("it is not UTF-8 text")]
    NotText,
    /// There are no rows of numbers.
    #[error("it holds no points")]
    Empty,
    /// The line of names lacks a column.
    #[error("row {row}: the names of the columns are {names}, and `{missing}` is not among them")]
    MissingColumn {
        /// Counted from 1, as editors do.
        row: usize,
        /// What stands there.
        names: String,
        /// `x`, `y` or `z`.
        missing: &'static str,
    },
    /// A name stands above two columns.
    #[error("row {row}: two columns are called `{name}`")]
    RepeatedColumn {
        /// Counted from 1.
        row: usize,
        /// The name.
        name: String,
    },
    /// A row has more or fewer entries than the first.
    #[error("row {row} has {found} columns where {expected} are expected")]
    Ragged {
        /// Counted from 1.
        row: usize,
        /// Columns of the first row; three without names.
        expected: usize,
        /// Columns of this row.
        found: usize,
    },
    /// A row ends before one of the three columns.
    #[error("row {row} has no column {column}: it has {found} columns where {expected} are expected")]
    Short {
        /// Counted from 1.
        row: usize,
        /// The first of the columns that is missing.
        column: &'static str,
        /// Columns of the first row; three without names.
        expected: usize,
        /// Columns of this row.
        found: usize,
    },
    /// An entry is no finite number.
    #[error("row {row}, column {column}: `{text}` is not a finite number")]
    NotANumber {
        /// Counted from 1.
        row: usize,
        /// `x`, `y` or `z`.
        column: &'static str,
        /// What stands there, cut where it is long.
        text: String,
    },
    /// There are more points than allowed.
    #[error("it holds more than {allowed} points")]
    TooMany {
        /// How many are allowed.
        allowed: usize,
    },
}

/// The names of the columns.
const COLUMNS: [&str; 3] = ["x", "y", "z"];

/// Characters of an entry that a message shows.
const SHOWN: usize = 24;

/// The points of a table, each with the row it stands in, counted from 1.
///
/// Entries are separated by commas, or else by semicolons, or else by blanks, as the first row shows. Empty lines and
/// those that begin with `#` are passed over. A first row that holds no numbers names the columns: x, y and z, in any
/// order, beside others; without it there are these three.
///
/// # Errors
/// [`TableFault`] for the first thing wrong.
pub fn read_points(bytes: &[u8], allowed: usize) -> Result<Vec<(usize, [f64; 3])>, TableFault> {
    let text = std::str::from_utf8(bytes).map_err(|_| TableFault::NotText)?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    let mut lines = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#')).peekable();
    let Some(&(row, first)) = lines.peek() else { return Err(TableFault::Empty) };
    let separator = [',', ';'].into_iter().find(|separator| first.contains(*separator));
    let cells = |line: &str| -> Vec<String> {
        let own = |cell: &str| cell.trim().trim_matches('"').to_owned();
        match separator {
            Some(separator) => line.split(separator).map(own).collect(),
            None => line.split_whitespace().map(own).collect(),
        }
    };
    let names = cells(first);
    let has_names = names.iter().all(|name| name.parse::<f64>().is_err());
    let (places, expected) = if has_names {
        lines.next();
        (columns(&names, row)?, names.len())
    } else {
        ([0, 1, 2], 3)
    };
    let mut points = Vec::new();
    for (row, line) in lines {
        let cells = cells(line);
        let found = cells.len();
        if found != expected {
            let missing = places.into_iter().zip(COLUMNS).filter(|(place, _)| *place >= found).min();
            return Err(match missing {
                Some((_, column)) => TableFault::Short { row, column, expected, found },
                None => TableFault::Ragged { row, expected, found },
            });
        }
        if points.len() >= allowed {
            return Err(TableFault::TooMany { allowed });
        }
        let mut point = [0.0; 3];
        for ((value, place), column) in point.iter_mut().zip(places).zip(COLUMNS) {
            let cell = cells.get(place).map_or("", String::as_str);
            let number = cell.parse::<f64>().ok().filter(|number| number.is_finite());
            *value = number.ok_or_else(|| TableFault::NotANumber { row, column, text: shown(cell) })?;
        }
        points.push((row, point));
    }
    if points.is_empty() { Err(TableFault::Empty) } else { Ok(points) }
}

/// Where x, y and z stand.
fn columns(names: &[String], row: usize) -> Result<[usize; 3], TableFault> {
    let mut places = [0; 3];
    for (place, wanted) in places.iter_mut().zip(COLUMNS) {
        let mut found = names.iter().enumerate().filter(|(_, name)| name.eq_ignore_ascii_case(wanted));
        *place = match (found.next(), found.next()) {
            (Some((index, _)), None) => index,
            (None, _) => {
                let quoted: Vec<String> = names.iter().take(8).map(|name| format!("`{}`", shown(name))).collect();
                return Err(TableFault::MissingColumn { row, names: quoted.join(", "), missing: wanted });
            }
            (Some(_), Some(_)) => return Err(TableFault::RepeatedColumn { row, name: wanted.to_owned() }),
        };
    }
    Ok(places)
}

fn shown(cell: &str) -> String {
    if cell.chars().count() <= SHOWN { cell.to_owned() } else { cell.chars().take(SHOWN).chain(['…']).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Vec<(usize, [f64; 3])>, TableFault> {
        read_points(text.as_bytes(), 4)
    }

    #[test]
    fn columns_are_found_by_their_names_and_otherwise_by_their_places() {
        let expected = vec![(2, [1.0, 2.0, -3.0])];
        assert_eq!(read("x,y,z\n1,2,-3\n"), Ok(expected.clone()));
        assert_eq!(read("\u{feff}# measured\r\n1, 2e0 ,-3\r\n"), Ok(expected.clone()));
        assert_eq!(read("name;z;Y;\"x\"\na;-3;2;1"), Ok(expected));
        assert_eq!(read("\n\n 1\t2   -3"), Ok(vec![(3, [1.0, 2.0, -3.0])]));
    }

    #[test]
    fn faults_name_row_and_column() {
        let told = |text: &str| read(text).expect_err("at fault").to_string();
        assert_eq!(told("z,x,y\n1\n"), "row 2 has no column x: it has 1 columns where 3 are expected");
        assert_eq!(told("x,y,z,name\n1,2,3\n"), "row 2 has 3 columns where 4 are expected");
        assert_eq!(told("1,2,3\n\n1,nan,3"), "row 3, column y: `nan` is not a finite number");
        assert_eq!(told("1,2,3\n1,2,"), "row 2, column z: `` is not a finite number");
        assert_eq!(told("x,y\n1,2"), "row 1: the names of the columns are `x`, `y`, and `z` is not among them");
        assert_eq!(told("x,y,z,x\n1,2,3,4"), "row 1: two columns are called `x`");
        assert_eq!(told("1,2\n"), "row 1 has no column z: it has 2 columns where 3 are expected");
        assert_eq!(told("# nothing\nx,y,z\n"), "it holds no points");
        assert_eq!(told(&"1 2 3\n".repeat(5)), "it holds more than 4 points");
        assert_eq!(read_points(&[0xff], 4), Err(TableFault::NotText));
    }
}
