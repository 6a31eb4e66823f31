//! Rows of a text to the text: `=` and comments in columns, at most one empty line between sections.

/// A line of the result.
#[derive(Debug, Default, Clone, PartialEq, Eq)]
pub struct Row {
    /// Blanks before it; `None` for an empty line and for a comment that stood at the margin.
    pub indent: Option<usize>,
    /// The code.
    pub text: String,
    /// Where the `=` of a constraint stands in the code.
    pub equals: Option<usize>,
    /// The comment.
    pub comment: Option<String>,
}

impl Row {
    fn is_empty(&self) -> bool {
        self.text.is_empty() && self.comment.is_none()
    }
}

/// The text of `rows`.
pub fn joined(mut rows: Vec<Row>) -> String {
    indent_comments(&mut rows);
    align_equations(&mut rows);
    let mut text = String::new();
    let mut follows_empty = true;
    let columns = comment_columns(&rows);
    for (row, column) in rows.iter().zip(columns) {
        if row.is_empty() {
            follows_empty = true;
            continue;
        }
        if follows_empty && !text.is_empty() {
            text.push('\n');
        }
        follows_empty = false;
        let line = format!("{}{}", " ".repeat(row.indent.unwrap_or(0)), row.text);
        text.push_str(&line);
        if let Some(comment) = &row.comment {
            if !row.text.is_empty() {
                text.push_str(&" ".repeat(column.saturating_sub(width(&line)).max(2)));
            }
            text.push_str(comment.trim_end());
        }
        text.push('\n');
    }
    text
}

/// A comment on a line of its own belongs to the line that follows it.
fn indent_comments(rows: &mut [Row]) {
    let mut below: Option<usize> = None;
    for row in rows.iter_mut().rev() {
        if !row.text.is_empty() {
            below = row.indent;
        } else if row.comment.is_none() {
            below = None;
        } else if below.is_some() {
            row.indent = below;
        }
    }
}

/// Puts the `=` of constraints on lines that follow each other in one column.
fn align_equations(rows: &mut [Row]) {
    for run in rows.chunk_by_mut(|a, b| a.equals.is_some() && b.equals.is_some() && a.indent == b.indent) {
        let left = |row: &Row| row.equals.and_then(|at| row.text.get(..at)).map_or(0, |left| width(left.trim_end()));
        let column = run.iter().map(left).max().unwrap_or(0);
        for row in run.iter_mut() {
            let missing = column - left(row);
            if let Some(at) = row.equals {
                row.text.insert_str(at, &" ".repeat(missing));
            }
        }
    }
}

/// For each row, the column of a comment behind its code: one for rows that follow each other.
fn comment_columns(rows: &[Row]) -> Vec<usize> {
    let has_both = |row: &Row| !row.text.is_empty() && row.comment.is_some();
    let mut columns = Vec::with_capacity(rows.len());
    for run in rows.chunk_by(|a, b| has_both(a) && has_both(b)) {
        let ends = run.iter().map(|row| row.indent.unwrap_or(0) + width(&row.text) + 2);
        let column = ends.max().unwrap_or(0);
        columns.extend(run.iter().map(|_| column));
    }
    columns
}

/// Columns of a text; a mark above a letter takes none.
fn width(text: &str) -> usize {
    text.lines().last().unwrap_or("").chars().filter(|c| !('\u{300}'..='\u{36f}').contains(c)).count()
}
