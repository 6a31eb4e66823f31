//! Rows of doubles that begin on cache lines and do not compete for them.

/// Doubles in a cache line of 64 bytes, and in the widest vector.
const LINE: usize = 8;

/// Rows of one length, each on its own cache lines.
///
/// Rows a power of two apart would share a few sets of the first-level cache, so there is a line between them.
#[derive(Debug, Clone, Default)]
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

    /// Makes it `count` rows of `length` numbers, whatever they are, in the same memory if that is large enough.
    pub fn reshape(&mut self, count: usize, length: usize) {
        let stride = length.next_multiple_of(LINE) + LINE;
        if self.start + count * stride > self.buffer.len() {
            *self = Rows::zeros(count, length);
        } else {
            (self.count, self.length, self.stride) = (count, length, stride);
        }
    }

    /// The number of rows.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// The numbers in a row.
    #[must_use]
    pub fn length(&self) -> usize {
        self.length
    }

    /// Row number `index`; empty past the last.
    #[must_use]
    pub fn row(&self, index: usize) -> &[f64] {
        let begin = self.start + index * self.stride;
        let row = if index < self.count { self.buffer.get(begin..begin + self.length) } else { None };
        row.unwrap_or_default()
    }

    /// The numbers of all rows in one slice, and how many lie from the beginning of a row to that of the next.
    pub fn strided(&mut self) -> (&mut [f64], usize) {
        let end = self.start + self.count * self.stride;
        (self.buffer.get_mut(self.start..end).unwrap_or_default(), self.stride)
    }

    /// The rows.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        let rows = self.buffer.get(self.start..).unwrap_or_default().chunks_exact(self.stride.max(1)).take(self.count);
        rows.map(|row| row.get(..self.length).unwrap_or_default())
    }

    /// The rows, to be written.
    pub fn iter_mut(&mut self) -> impl ExactSizeIterator<Item = &mut [f64]> {
        let rows = self.buffer.get_mut(self.start..).unwrap_or_default().chunks_exact_mut(self.stride.max(1));
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

    #[test]
    fn rows_of_another_shape_are_still_on_lines_and_apart() {
        let mut rows = Rows::default();
        for (count, length) in [(3, 256), (5, 100), (2, 256), (40, 9), (0, 0)] {
            rows.reshape(count, length);
            assert_eq!((rows.count(), rows.length(), rows.iter().len()), (count, length, count));
            for (index, row) in rows.iter_mut().enumerate() {
                assert_eq!((row.len(), row.as_ptr().addr() % 64), (length, 0));
                row.fill(index as f64);
            }
            assert!((0..count).all(|index| rows.row(index).iter().all(|x| *x == index as f64)));
            assert!(rows.row(count).is_empty());
            let (all, stride) = rows.strided();
            assert!((0..count).all(|index| all.get(index * stride) == Some(&(index as f64)) || length == 0));
        }
    }
}
