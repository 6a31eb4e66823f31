//! The factors of a sum of products, tabulated along u and along v.

use super::Number;

/// The widest vector has so many numbers; tiles are three of them wide.
const WIDEST: usize = 16;

/// `A_r(u_i)`: numbers, or vectors of three, row after row.
#[derive(Debug, Clone)]
pub struct Across<N> {
    rows: usize,
    rank: usize,
    components: usize,
    numbers: Vec<N>,
}

impl<N: Number> Across<N> {
    /// For each row as many zeros as the `rank`.
    #[must_use]
    pub fn scalars(rows: usize, rank: usize) -> Self {
        Across { rows, rank, components: 1, numbers: vec![N::default(); rows * rank] }
    }

    /// For each row as many zero vectors as the `rank`.
    #[must_use]
    pub fn vectors(rows: usize, rank: usize) -> Self {
        Across { rows, rank, components: 3, numbers: vec![N::default(); rows * rank * 3] }
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
        self.components
    }

    /// What belongs to u_i: for r after r a number, or x, y and z.
    #[must_use]
    pub fn row(&self, i: usize) -> &[N] {
        let length = self.rank * self.components;
        self.numbers.get(i * length..).and_then(|rest| rest.get(..length)).unwrap_or_default()
    }

    /// The rows, to be written.
    pub fn rows_mut(&mut self) -> impl Iterator<Item = &mut [N]> {
        self.numbers.chunks_exact_mut((self.rank * self.components).max(1))
    }

    pub(super) fn is_like(&self, other: &Self) -> bool {
        (self.rows, self.rank, self.components) == (other.rows, other.rank, other.components)
    }

    /// The largest size of each `A_r`, in any component; NaN or infinite where one of the numbers is.
    #[must_use]
    pub fn largest(&self) -> Vec<f64> {
        let mut most = vec![0.0; self.rank];
        for row in self.numbers.chunks_exact((self.rank * self.components).max(1)) {
            for (most, numbers) in most.iter_mut().zip(row.chunks(self.components)) {
                *most = larger(*most, size(numbers));
            }
        }
        most
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

/// A bound of the size of `Σ_r A_r B_r`, from the largest of each; not finite where a number is not.
#[must_use]
pub fn bound<N: Number>(across: &Across<N>, along: &Along<N>) -> f64 {
    // The sizes are rounded sums of `rank` products: half a dozen digits are more than enough room.
    across.largest().iter().zip(along.largest()).map(|(a, b)| a * b).sum::<f64>() * (1.0 + 1e-6)
}

fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

fn size<N: Number>(numbers: &[N]) -> f64 {
    // Eight at a time, so that vectors can be used.
    let mut most = [0_u64; 8];
    let bits = |number: N| number.to_f64().to_bits() & (u64::MAX >> 1);
    let chunks = numbers.chunks_exact(8);
    let rest = chunks.remainder();
    for chunk in chunks {
        // Sizes are ordered as their bits are, and NaN comes last.
        most.iter_mut().zip(chunk).for_each(|(most, number)| *most = (*most).max(bits(*number)));
    }
    most.iter_mut().zip(rest).for_each(|(most, number)| *most = (*most).max(bits(*number)));
    f64::from_bits(most.into_iter().fold(0, u64::max))
}
