//! Sums of products on a grid, `S(u_i, v_j) = Σ_r A_r(u_i) B_r(v_j)`, as products of small matrices.
//!
//! Either the A_r are numbers and the B_r vectors, or the other way round ([`Across`], [`Along`]); whichever sum is the
//! shorter. Points are written u-major, `[u][v][xyz]`, once and straight to where they belong, past the caches where
//! there is more to write than they hold ([`Stores`]).
//!
//! Every coordinate is a chain of fused multiplications and additions over r in ascending order, begun from zero. So
//! it depends neither on the instruction set, nor on where the grid lies in memory, nor on how its rows are shared
//! among threads.

mod cache;
mod lanes;
mod points;
mod tables;
mod tiles;

use std::ops::Range;

use super::InstructionSet;

use cache::last_cache;
use lanes::Lanes;
use tiles::{Positions, Shape};

pub use lanes::Number;
pub use points::{Combination, assemble, combine, contract};
pub use tables::{Across, Along, bound};

/// How points are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stores {
    /// Through the caches, for what is read again soon.
    Cached,
    /// Past the caches, for what they cannot hold: half the traffic, since nothing is read before it is overwritten.
    Streamed,
}

impl Stores {
    /// What suits an amount of bytes: what fills more than half of the last cache is not kept for who reads it next.
    #[must_use]
    pub fn suited_to(bytes: usize) -> Stores {
        if bytes > last_cache() / 2 { Stores::Streamed } else { Stores::Cached }
    }

    /// As many rows of `columns` points as kernels write together; other numbers of rows leave tiles with empty rows.
    #[must_use]
    pub fn rows_together<N: Number>(self, columns: usize) -> usize {
        tiles::rows_together::<N>(self, columns)
    }
}

/// Where a surface's points, unit normals and tangents go: rows of as many as there are columns.
pub struct Outputs<'a, N> {
    /// S.
    pub positions: &'a mut [[N; 3]],
    /// `S_u x S_v` at unit length; not finite where that is zero.
    pub normals: &'a mut [[N; 3]],
    /// S_u and S_v.
    pub tangents: Option<[&'a mut [[N; 3]]; 2]>,
}

/// Writes `Σ_r across_r(u_i) along_r(v_j)` for the `rows` i and every j.
///
/// That of row i and column j is at `points[(i - rows.start) * along.columns() + j]`. As many rows are written as are
/// whole in `points`; none where the tables have different ranks, or where not just one of them has vectors.
pub fn positions<N: Number>(
    set: InstructionSet,
    stores: Stores,
    (across, along): (&Across<N>, &Along<N>),
    rows: Range<usize>,
    points: &mut [[N; 3]],
) {
    let rows = written([across; 2], [along; 2], rows, &[points.len()]);
    dispatch(set, Positions { stores, across, along, rows, points });
}

/// Writes points, unit normals and perhaps tangents for the `rows` i and every j, as [`positions`] does.
///
/// `across` and `along` are each a table and that of its derivatives; `along` is planar. Returns the least of
/// `|S_u x S_v|²`, infinity without points. Fourth powers of tangents must not overflow: see [`Number::MODERATE`].
pub fn shape<N: Number>(
    set: InstructionSet,
    stores: Stores,
    (across, along): ([&Across<N>; 2], [&Along<N>; 2]),
    rows: Range<usize>,
    outputs: Outputs<'_, N>,
) -> f64 {
    let mut lengths = vec![outputs.positions.len(), outputs.normals.len()];
    lengths.extend(outputs.tangents.iter().flatten().map(|tangents| tangents.len()));
    let is_planar = along.iter().all(|along| !along.is_interleaved());
    let rows = if is_planar { written(across, along, rows, &lengths) } else { 0..0 };
    dispatch(set, Shape { stores, across, along, rows, outputs })
}

/// Those of `rows` that are in the tables and fit whole into slices of `lengths` points.
fn written<N: Number>(
    [across, slope]: [&Across<N>; 2],
    [along, along_slope]: [&Along<N>; 2],
    rows: Range<usize>,
    lengths: &[usize],
) -> Range<usize> {
    let fits = across.is_like(slope)
        && along.is_like(along_slope)
        && across.rank() == along.rank()
        && across.components() + along.components() == 4;
    let whole = lengths.iter().map(|length| length / along.columns().max(1)).min().unwrap_or(0);
    let end = rows.end.min(across.rows()).min(rows.start.saturating_add(whole));
    if fits && along.columns() > 0 && rows.start < end { rows.start..end } else { 0..0 }
}

/// Work that is compiled for every instruction set.
trait Kernel<N: Number> {
    /// Does it.
    ///
    /// # Safety
    /// The processor has the instructions that `L` is named for; the caller is compiled for them.
    unsafe fn run<L: Lanes<Number = N>>(self) -> f64;
}

fn dispatch<N: Number>(set: InstructionSet, kernel: impl Kernel<N>) -> f64 {
    #[cfg(target_arch = "x86_64")]
    {
        #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")]
        fn avx512<N: Number>(kernel: impl Kernel<N>) -> f64 {
            // SAFETY: this function is compiled for the instructions and runs only where they are.
            unsafe { kernel.run::<N::Avx512>() }
        }
        #[target_feature(enable = "avx2,fma")]
        fn avx2<N: Number>(kernel: impl Kernel<N>) -> f64 {
            // SAFETY: as above.
            unsafe { kernel.run::<N::Avx2>() }
        }
        if set.is_avx512() {
            // SAFETY: the only set for which `is_avx512` holds is made after the processor was found to have every
            // feature named above.
            return unsafe { avx512(kernel) };
        }
        if set.is_avx2() {
            // SAFETY: as above.
            return unsafe { avx2(kernel) };
        }
    }
    // The baseline needs no choice.
    let _ = set;
    // SAFETY: every processor of the target has these instructions.
    unsafe { kernel.run::<N::Baseline>() }
}
