//! The factors of a sum of products, tabulated along u and along v.

use super::Number;

/// The widest vector has so many numbers; tiles are three of them wide.
const WIDEST: usize = 16;

/// `A_r(u_i)`: numbers, or vectors of three of which some components are zero for every u.
#[derive(Debug, Clone)]
pub struct Across<N> {
    rows: usize,
    rank: usize,
    /// For numbers one list of all r; for vectors those r of which x, y, z are not zero.
    parts: Vec<Vec<usize>>,
    numbers: Vec<N>,
}

impl<N: Number> Across<N> {
    /// For each row as many zeros as the `rank`.
    #[must_use]
    pub fn scalars(rows: usize, rank: usize) -> Self {
        Across::of(rows, rank, vec![(0..rank).collect()])
    }

    /// For each row as many zero vectors as the `rank`, of which only the x, y and z of the r in `parts` will be written.
    /// Each list is in ascending order; what is not below the rank is left out.
    #[must_use]
    pub fn vectors(rows: usize, rank: usize, parts: [Vec<usize>; 3]) -> Self {
        Across::of(rows, rank, parts.into_iter().map(|part| part.into_iter().filter(|r| *r < rank).collect()).collect())
    }

    fn of(rows: usize, rank: usize, parts: Vec<Vec<usize>>) -> Self {
        let width: usize = parts.iter().map(Vec::len).sum();
        Across { rows, rank, parts, numbers: vec![N::default(); rows * width] }
    }

    /// The number of u_i.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The number of r.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// 1 or 3.
    #[must_use]
    pub fn components(&self) -> usize {
        self.parts.len()
    }

    /// The r that each component has.
    #[must_use]
    pub fn parts(&self) -> &[Vec<usize>] {
        &self.parts
    }

    /// The numbers of one row.
    #[must_use]
    pub fn width(&self) -> usize {
        self.parts.iter().map(Vec::len).sum()
    }

    /// What belongs to u_i: for r after r a number, or all x, then all y, then all z.
    #[must_use]
    pub fn row(&self, i: usize) -> &[N] {
        let width = self.width();
        self.numbers.get(i * width..).and_then(|rest| rest.get(..width)).unwrap_or_default()
    }

    /// The rows, to be written.
    pub fn rows_mut(&mut self) -> impl Iterator<Item = &mut [N]> {
        let width = self.width();
        self.numbers.chunks_exact_mut(width.max(1))
    }

    /// The same, rounded to other numbers.
    #[must_use]
    pub fn rounded<M: Number>(&self) -> Across<M> {
        let numbers = self.numbers.iter().map(|number| M::rounded(number.to_f64())).collect();
        Across { rows: self.rows, rank: self.rank, parts: self.parts.clone(), numbers }
    }

    pub(super) fn is_like(&self, other: &Self) -> bool {
        (self.rows, self.rank, &self.parts) == (other.rows, other.rank, &other.parts)
    }

    /// The largest size of each number of a row in any of the rows; NaN or infinite where one of them is.
    #[must_use]
    pub fn largest(&self) -> Vec<f64> {
        let width = self.width();
        let mut most = vec![0_u64; width];
        for row in self.numbers.chunks_exact(width.max(1)) {
            most.iter_mut().zip(row).for_each(|(most, number)| *most = (*most).max(size_bits(*number)));
        }
        most.into_iter().map(f64::from_bits).collect()
    }
}

/// `B_r(v_j)`: numbers, or vectors of three, in rows that vectors may be read from beyond their end.
#[derive(Debug, Clone)]
pub struct Along<N> {
    columns: usize,
    rank: usize,
    components: usize,
    is_interleaved: bool,
    stride: usize,
    numbers: Vec<N>,
}

impl<N: Number> Along<N> {
    /// `rank` rows of zeros, one for each v_j.
    #[must_use]
    pub fn scalars(rank: usize, columns: usize) -> Self {
        Along::of(rank, 1, columns, false)
    }

    /// `rank` rows of zero vectors: all x, then all y, then all z.
    #[must_use]
    pub fn vectors(rank: usize, columns: usize) -> Self {
        Along::of(rank, 3, columns, false)
    }

    fn of(rank: usize, components: usize, columns: usize, is_interleaved: bool) -> Self {
        let (rows, length) = if is_interleaved { (rank, components * columns) } else { (rank * components, columns) };
        // A tile that begins at the last column reads the rest of its width.
        let least = (length + 3 * WIDEST).next_multiple_of(WIDEST);
        // Rows a power of two apart would share a few sets of the first-level cache.
        let stride = if least.is_multiple_of(256) { least + WIDEST } else { least };
        Along { columns, rank, components, is_interleaved, stride, numbers: vec![N::default(); rows * stride] }
    }

    /// Vectors as x y z x y z …, from ones with all x, all y and all z in a row; numbers stay.
    #[must_use]
    pub fn interleaved(&self) -> Self {
        if self.components == 1 || self.is_interleaved {
            return self.clone();
        }
        let mut result = Along::of(self.rank, 3, self.columns, true);
        let planes = self.numbers.chunks_exact(3 * self.stride);
        for (row, planes) in result.numbers.chunks_exact_mut(result.stride).zip(planes) {
            for (component, plane) in planes.chunks_exact(self.stride).enumerate() {
                let slots = row.iter_mut().skip(component).step_by(3);
                slots.zip(plane.iter().take(self.columns)).for_each(|(slot, number)| *slot = *number);
            }
        }
        result
    }

    /// The number of v_j.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The number of r.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// 1 or 3.
    #[must_use]
    pub fn components(&self) -> usize {
        self.components
    }

    pub(super) fn is_interleaved(&self) -> bool {
        self.is_interleaved
    }

    pub(super) fn stride(&self) -> usize {
        self.stride
    }

    pub(super) fn numbers(&self) -> &[N] {
        &self.numbers
    }

    /// The rows, to be written: for r after r one, or those of x, y and z. None where vectors are interleaved.
    pub fn rows_mut(&mut self) -> impl Iterator<Item = &mut [N]> {
        let (columns, rows) = (self.columns, if self.is_interleaved { 0 } else { self.rank * self.components });
        self.numbers.chunks_exact_mut(self.stride).take(rows).filter_map(move |row| row.get_mut(..columns))
    }

    pub(super) fn is_like(&self, other: &Self) -> bool {
        (self.columns, self.rank, self.components, self.is_interleaved)
            == (other.columns, other.rank, other.components, other.is_interleaved)
    }

    /// The largest size of each `B_r`, in any component; NaN or infinite where one of the numbers is.
    #[must_use]
    pub fn largest(&self) -> Vec<f64> {
        let rows = if self.is_interleaved { 1 } else { self.components };
        self.numbers.chunks_exact(rows * self.stride).map(size).collect()
    }
}

/// A bound of the size of `Σ_r A_r B_r` in any component, from the `largest` of the A_r ([`Across::largest`]) and the
/// B_r; not finite where a number is not.
#[must_use]
pub fn bound<N: Number>(across: &Across<N>, largest: &[f64], along: &Along<N>) -> f64 {
    let along = along.largest();
    let mut largest = largest.iter();
    let sum = |part: &Vec<usize>| -> f64 {
        part.iter().zip(largest.by_ref()).map(|(r, a)| a * along.get(*r).copied().unwrap_or(0.0)).sum()
    };
    let sums: Vec<f64> = across.parts().iter().map(sum).collect();
    // The sizes are rounded sums of `rank` products: half a dozen digits are more than enough room.
    sums.into_iter().fold(0.0, larger) * (1.0 + 1e-6)
}

fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// The bits of a number's size: sizes are ordered as their bits are, and NaN comes last.
#[inline(always)]
fn size_bits<N: Number>(number: N) -> u64 {
    number.to_f64().to_bits() & (u64::MAX >> 1)
}

fn size<N: Number>(numbers: &[N]) -> f64 {
    // Eight at a time, so that vectors can be used.
    let mut most = [0_u64; 8];
    let chunks = numbers.chunks_exact(8);
    let rest = chunks.remainder();
    for chunk in chunks {
        most.iter_mut().zip(chunk).for_each(|(most, number)| *most = (*most).max(size_bits(*number)));
    }
    most.iter_mut().zip(rest).for_each(|(most, number)| *most = (*most).max(size_bits(*number)));
    f64::from_bits(most.into_iter().fold(0, u64::max))
}
