//! Sums of products at scattered points, and the sums that make the tables of grids.

use crate::kernels::multiversion;

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

/// Outer sums that share one inner sum.
const TOGETHER: usize = 3;

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

multiversion! {
    /// Writes `Σ_m outer_m Σ_j c_mj inner_j` to x, y and z for each of several `outers`. All rows are as long as these.
    pub fn contract(
        combination: &Combination,
        inner: &[&[f64]],
        outers: &[Vec<&[f64]>],
        targets: &mut [[&mut [f64]; 3]],
    ) {
        let length = targets.iter().flatten().map(|target| target.len()).min().unwrap_or(0);
        let is_short = length < LANES;
        let copies = |rows: &[&[f64]]| rows.iter().filter(|_| is_short).map(|row| padded(row)).collect::<Vec<_>>();
        let short = copies(inner);
        let short_outers: Vec<Vec<[f64; LANES]>> = outers.iter().map(|rows| copies(rows)).collect();
        let mut windows: Vec<&[f64; LANES]> = short.iter().collect();
        let mut outer_windows: Vec<Vec<&[f64; LANES]>> = short_outers.iter().map(|rows| rows.iter().collect()).collect();
        for begin in (0..length).step_by(LANES) {
            // The last points are treated with some before them, once more.
            let begin = begin.min(length.saturating_sub(LANES));
            if !is_short {
                look(inner, begin, &mut windows);
                outers.iter().zip(&mut outer_windows).for_each(|(outer, windows)| look(outer, begin, windows));
            }
            for (outers, targets) in outer_windows.chunks(TOGETHER).zip(targets.chunks_mut(TOGETHER)) {
                let totals = totals(combination, &windows, outers);
                for (targets, total) in targets.iter_mut().zip(&totals) {
                    for (target, total) in targets.iter_mut().zip(total) {
                        target.iter_mut().skip(begin).zip(total).for_each(|(slot, value)| *slot = *value);
                    }
                }
            }
        }
    }
}

/// The numbers of every row from `begin` on.
#[inline(always)]
fn look<'a>(rows: &[&'a [f64]], begin: usize, windows: &mut Vec<&'a [f64; LANES]>) {
    let window = |row: &&'a [f64]| row.get(begin..).and_then(|rest| rest.first_chunk()).unwrap_or(&[0.0; LANES]);
    windows.clear();
    windows.extend(rows.iter().map(window));
}

/// The numbers of a row, and zeros after its end.
#[inline(always)]
fn padded(row: &[f64]) -> [f64; LANES] {
    let mut some = [0.0; LANES];
    some.iter_mut().zip(row).for_each(|(slot, value)| *slot = *value);
    some
}

/// The sums at some points, for each outer sum and component.
#[inline(always)]
fn totals(
    combination: &Combination,
    inner: &[&[f64; LANES]],
    outers: &[Vec<&[f64; LANES]>],
) -> [[[f64; LANES]; 3]; TOGETHER] {
    let mut totals = [[[0.0; LANES]; 3]; TOGETHER];
    for row in 0..combination.rows() {
        for component in 0..3 {
            let entries = combination.entries(row, component);
            if entries.is_empty() {
                continue;
            }
            let mut sum = [0.0; LANES];
            for (j, factor) in entries {
                let Some(values) = inner.get(*j) else { continue };
                for (sum, value) in sum.iter_mut().zip(*values) {
                    *sum = factor.mul_add(*value, *sum);
                }
            }
            for (outer, total) in outers.iter().zip(&mut totals) {
                let (Some(factors), Some(total)) = (outer.get(row), total.get_mut(component)) else { continue };
                // Copied, so that the compiler sees that nothing overlaps.
                let (factors, mut next): ([f64; LANES], [f64; LANES]) = (**factors, *total);
                for ((next, sum), factor) in next.iter_mut().zip(&sum).zip(&factors) {
                    *next = factor.mul_add(*sum, *next);
                }
                *total = next;
            }
        }
    }
    totals
}

multiversion! {
    /// Writes rows of x, y and z as points, as far as all reach.
    pub fn assemble(points: &mut [[f64; 3]], rows: [&[f64]; 3]) {
        let [x, y, z] = rows;
        for (point, ((x, y), z)) in points.iter_mut().zip(x.iter().zip(y).zip(z)) {
            *point = [*x, *y, *z];
        }
    }
}
