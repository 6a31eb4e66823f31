//! Rows of doubles that begin on cache lines and do not compete for them.

/// Doubles in a cache line of 64 bytes, and in the widest vector.
const LINE: usize = 8;

/// Rows of one length, each on its own cache lines.
///
/// Rows a power of two apart would share a few sets of the first-level cache, so there is a line between them.
#[derive(Debug, Clone)]
pub struct Rows {
    buffer: Vec<f64>,
    start: usize,
    stride: usize,
    length: usize,
    count: usize,
}

impl Rows {
    /// `count` rows of `length` zeros.
    #[must_use]
    pub fn zeros(count: usize, length: usize) -> Rows {
        let stride = length.next_multiple_of(LINE) + LINE;
        let buffer = vec![0.0; count * stride + LINE];
        // The offset to a boundary may be unknown, when code is run before it is compiled.
        let start = buffer.as_ptr().align_offset(64).min(LINE);
        Rows { buffer, start, stride, length, count }
    }

    /// The rows.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        let rows = self.buffer.get(self.start..).unwrap_or_default().chunks_exact(self.stride).take(self.count);
        rows.map(|row| row.get(..self.length).unwrap_or_default())
    }

    /// The rows, to be written.
    pub fn iter_mut(&mut self) -> impl ExactSizeIterator<Item = &mut [f64]> {
        let rows = self.buffer.get_mut(self.start..).unwrap_or_default().chunks_exact_mut(self.stride);
        rows.take(self.count).map(|row| row.get_mut(..self.length).unwrap_or_default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_begin_on_lines_and_do_not_overlap() {
        for (count, length) in [(0, 5), (1, 0), (3, 256), (7, 13)] {
            let mut rows = Rows::zeros(count, length);
            assert_eq!(rows.iter_mut().len(), count);
            for (index, row) in rows.iter_mut().enumerate() {
                assert_eq!((row.len(), row.as_ptr().addr() % 64), (length, 0));
                row.fill(index as f64);
            }
            assert!(rows.iter().enumerate().all(|(index, row)| row.iter().all(|x| *x == index as f64)));
        }
    }
}
