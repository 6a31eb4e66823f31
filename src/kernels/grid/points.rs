//! Sums of products at scattered points, and the sums that make the tables of grids.

use crate::kernels::{InstructionSet, multiversion};

/// The coefficients that are not zero: for each row of an outer sum and each of x, y and z, rows of the inner sum.
#[derive(Debug, Clone, Default)]
pub struct Combination {
    /// Where the entries of each row and component begin, and where the last ends.
    starts: Vec<usize>,
    entries: Vec<(usize, f64)>,
}

impl Combination {
    /// `rows` rows of an outer sum, with `terms` of row, component, row of the inner sum and coefficient. Those of one row
    /// and component are added in the order in which they are given; zeros are left out.
    #[must_use]
    pub fn new(rows: usize, terms: &[(usize, usize, usize, f64)]) -> Combination {
        let is_term = |(_, _, _, coefficient): &&(usize, usize, usize, f64)| *coefficient != 0.0;
        let place = |row: usize, component: usize| 3 * row + component;
        let mut starts = vec![0; 3 * rows + 1];
        for (row, component, ..) in terms.iter().filter(is_term) {
            if let Some(count) = starts.get_mut(place(*row, *component) + 1) {
                *count += 1;
            }
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let (mut next, mut entries) = (starts.clone(), vec![(0, 0.0); sum]);
        for (row, component, inner, coefficient) in terms.iter().filter(is_term) {
            if let Some(at) = next.get_mut(place(*row, *component))
                && let Some(entry) = entries.get_mut(*at)
            {
                *entry = (*inner, *coefficient);
                *at += 1;
            }
        }
        Combination { starts, entries }
    }

    /// The number of rows of the outer sum.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.starts.len() / 3
    }

    /// The rows of the inner sum and their coefficients.
    #[must_use]
    pub fn entries(&self, row: usize, component: usize) -> &[(usize, f64)] {
        let index = 3 * row + component;
        let ends = self.starts.get(index).zip(self.starts.get(index + 1));
        ends.and_then(|(from, to)| self.entries.get(*from..*to)).unwrap_or_default()
    }

    /// The rows of the outer sum that have entries for a component.
    pub fn rows_of(&self, component: usize) -> impl Iterator<Item = usize> {
        (0..self.rows()).filter(move |row| !self.entries(*row, component).is_empty())
    }
}

/// Points of which a sum is held in registers: as many vectors of eight as multiplications are under way at once.
const LANES: usize = 64;

multiversion! {
    /// Writes `Σ c inner_j` to `sum`, as far as it reaches, for the entries `(j, c)` of one row and component.
    pub fn combine(entries: &[(usize, f64)], inner: &[&[f64]], sum: &mut [f64]) {
        sum.fill(0.0);
        for (j, factor) in entries {
            let values = inner.get(*j).copied().unwrap_or_default();
            for (sum, value) in sum.iter_mut().zip(values) {
                *sum = factor.mul_add(*value, *sum);
            }
        }
    }
}

/// Writes `Σ_m outer_m Σ_j c_mj inner_j` to x, y and z for each of several `outers`. All rows are as long as these.
pub fn contract(
    set: InstructionSet,
    combination: &Combination,
    inner: &[&[f64]],
    outers: &[Vec<&[f64]>],
    targets: &mut [[&mut [f64]; 3]],
) {
    let length = targets.iter().flatten().map(|target| target.len()).min().unwrap_or(0);
    if length >= LANES {
        return contract_whole(set, combination, (inner, outers), targets, length);
    }
    // Few points are treated as if they were enough.
    let inner: Vec<[f64; LANES]> = inner.iter().map(|row| padded(row)).collect();
    let outers: Vec<Vec<[f64; LANES]>> =
        outers.iter().map(|rows| rows.iter().map(|row| padded(row)).collect()).collect();
    let inner: Vec<&[f64]> = inner.iter().map(<[f64; LANES]>::as_slice).collect();
    let outers: Vec<Vec<&[f64]>> =
        outers.iter().map(|rows| rows.iter().map(<[f64; LANES]>::as_slice).collect()).collect();
    let mut sums = vec![[[0.0; LANES]; 3]; targets.len()];
    let mut all: Vec<[&mut [f64]; 3]> = sums.iter_mut().map(|sums| sums.each_mut().map(|sum| &mut sum[..])).collect();
    contract_whole(set, combination, (&inner, &outers), &mut all, LANES);
    for (target, sum) in targets.iter_mut().flatten().zip(sums.iter().flatten()) {
        target.iter_mut().zip(sum).for_each(|(slot, value)| *slot = *value);
    }
}

multiversion! {
    /// The same for rows of `length` numbers, at least [`LANES`].
    fn contract_whole(
        combination: &Combination,
        factors: (&[&[f64]], &[Vec<&[f64]>]),
        targets: &mut [[&mut [f64]; 3]],
        length: usize,
    ) {
        let (inner, outers) = factors;
        let mut windows = Vec::with_capacity(inner.len());
        let mut outer_windows = vec![Vec::new(); outers.len()];
        for begin in (0..length).step_by(LANES) {
            // The last points are treated with some before them, once more.
            let begin = begin.min(length - LANES);
            look(inner, begin, &mut windows);
            outers.iter().zip(&mut outer_windows).for_each(|(outer, windows)| look(outer, begin, windows));
            targets.iter_mut().flatten().filter_map(|target| window(target, begin)).for_each(|sums| *sums = [0.0; LANES]);
            for row in 0..combination.rows() {
                for component in 0..3 {
                    let entries = combination.entries(row, component);
                    if entries.is_empty() {
                        continue;
                    }
                    let sum = weighted(entries, &windows);
                    for (outer, target) in outer_windows.iter().zip(&mut *targets) {
                        let target = target.get_mut(component).and_then(|target| window(target, begin));
                        let (Some(factors), Some(target)) = (outer.get(row), target) else { continue };
                        // Copied, so that the compiler sees that nothing overlaps.
                        let (factors, mut next): ([f64; LANES], [f64; LANES]) = (**factors, *target);
                        for ((next, sum), factor) in next.iter_mut().zip(&sum).zip(&factors) {
                            *next = factor.mul_add(*sum, *next);
                        }
                        *target = next;
                    }
                }
            }
        }
    }
}

/// `Σ c inner_j` at some points, for the entries `(j, c)`.
#[inline(always)]
fn weighted(entries: &[(usize, f64)], inner: &[&[f64; LANES]]) -> [f64; LANES] {
    let mut sum = [0.0; LANES];
    for (j, factor) in entries {
        let Some(values) = inner.get(*j) else { continue };
        for (sum, value) in sum.iter_mut().zip(*values) {
            *sum = factor.mul_add(*value, *sum);
        }
    }
    sum
}

/// Some numbers of a row, to be written.
#[inline(always)]
fn window<'a>(row: &'a mut &mut [f64], begin: usize) -> Option<&'a mut [f64; LANES]> {
    row.get_mut(begin..).and_then(|rest| rest.first_chunk_mut())
}

/// The numbers of every row from `begin` on.
#[inline(always)]
fn look<'a>(rows: &[&'a [f64]], begin: usize, windows: &mut Vec<&'a [f64; LANES]>) {
    let window = |row: &&'a [f64]| row.get(begin..).and_then(|rest| rest.first_chunk()).unwrap_or(&[0.0; LANES]);
    windows.clear();
    windows.extend(rows.iter().map(window));
}

/// The numbers of a row, and zeros after its end.
fn padded(row: &[f64]) -> [f64; LANES] {
    let mut some = [0.0; LANES];
    some.iter_mut().zip(row).for_each(|(slot, value)| *slot = *value);
    some
}

multiversion! {
    /// Writes rows of x, y and z as points, as far as all reach.
    pub fn assemble(points: &mut [[f64; 3]], rows: [&[f64]; 3]) {
        const TOGETHER: usize = 8;
        let [x, y, z] = rows;
        let (whole, rest) = points.as_chunks_mut::<TOGETHER>();
        let begin = whole.len() * TOGETHER;
        let [xs, ys, zs] = rows.map(|row| row.as_chunks::<TOGETHER>().0);
        for (points, ((x, y), z)) in whole.iter_mut().zip(xs.iter().zip(ys).zip(zs)) {
            // Of a known number, so that the compiler shuffles whole vectors.
            let mut some = [[0.0; 3]; TOGETHER];
            for (point, ((x, y), z)) in some.iter_mut().zip(x.iter().zip(y).zip(z)) {
                *point = [*x, *y, *z];
            }
            *points = some;
        }
        let after = |row: &[f64], index: usize| row.get(begin + index).copied();
        for (index, point) in rest.iter_mut().enumerate() {
            if let (Some(x), Some(y), Some(z)) = (after(x, index), after(y, index), after(z, index)) {
                *point = [x, y, z];
            }
        }
    }
}
