//! The kernels: tiles of the grid in registers, written once.
//!
//! A tile is some rows by as many columns as a vector has numbers. Streamed stores want whole cache lines; rows of the
//! output begin anywhere in one, but every so many rows (at most 16) begin at the same place. Tiles are made of such rows,
//! and begin with the first column that begins a line. Vertices before and after the whole tiles go through memory.

use std::ops::Range;

use super::lanes::{Lanes, Number};
use super::tables::{Across, Along};
use super::{Kernel, Outputs, Stores};

/// Bytes of a cache line.
const LINE: usize = 64;

/// See [`positions`](super::positions).
pub(super) struct Positions<'a, N> {
    pub stores: Stores,
    pub across: &'a Across<N>,
    pub along: &'a Along<N>,
    pub rows: Range<usize>,
    pub points: &'a mut [[N; 3]],
}

/// See [`shape`](super::shape).
pub(super) struct Shape<'a, N> {
    pub stores: Stores,
    pub across: [&'a Across<N>; 2],
    pub along: [&'a Along<N>; 2],
    pub rows: Range<usize>,
    pub outputs: Outputs<'a, N>,
}

/// Rows so far apart begin at the same place of a cache line.
fn period<N: Number>(columns: usize) -> usize {
    let bytes = columns * size_of::<[N; 3]>();
    LINE >> bytes.trailing_zeros().min(LINE.trailing_zeros())
}

/// See [`Stores::rows_together`].
pub(super) fn rows_together<N: Number>(stores: Stores, columns: usize) -> usize {
    match stores {
        Stores::Cached => NEAR_ROWS,
        Stores::Streamed => NEAR_ROWS * period::<N>(columns),
    }
}

/// How rows are put together to tiles.
#[derive(Clone, Copy)]
struct Places {
    /// Rows so far apart begin at the same place of a cache line.
    period: usize,
    is_streamed: bool,
}

impl Places {
    /// For `rows` of `columns` points, at least `together` of them in a tile.
    fn new<N: Number>(stores: Stores, (rows, columns): (usize, usize), together: usize) -> Places {
        let period = period::<N>(columns);
        // With few rows most of a tile would be empty, and stores are not what takes the time.
        let is_streamed = stores == Stores::Streamed && rows >= together * period;
        Places { period: if is_streamed { period } else { 1 }, is_streamed }
    }

    /// The rows of one tile after the other, of which the last is repeated to make `ROWS`.
    fn tiles<const ROWS: usize>(self, rows: usize) -> impl Iterator<Item = [usize; ROWS]> {
        let period = self.period;
        (0..period).flat_map(move |first| {
            let count = rows.saturating_sub(first).div_ceil(period);
            (0..count).step_by(ROWS).map(move |begin| {
                let mut tile = [0; ROWS];
                for (row, k) in tile.iter_mut().zip(begin..) {
                    *row = first + period * k.min(count - 1);
                }
                tile
            })
        })
    }

    /// How many points of a row lie before the first that begins where whole vectors can be streamed to, fewer than a
    /// vector has numbers; `None` without such a point.
    fn head<L: Lanes>(self, row: *const [L::Number; 3]) -> Option<usize> {
        let bytes = L::COUNT * size_of::<L::Number>();
        let head = (0..L::COUNT).find(|points| row.wrapping_add(*points).addr().is_multiple_of(bytes));
        if self.is_streamed { head } else { None }
    }
}

/// Writes three vectors of one row's points: all, or the first `kept` points.
///
/// # Safety
/// As for [`Lanes`]. `to` is the place of as many points; with `STREAM` it begins a cache line and all are kept.
#[inline(always)]
unsafe fn put<L: Lanes, const STREAM: bool>(points: [L; 3], to: *mut L::Number, kept: Option<usize>) {
    let [a, b, c] = points;
    match kept {
        // SAFETY: the caller's, of three times `COUNT` numbers.
        None if STREAM => unsafe {
            a.stream(to);
            b.stream(to.add(L::COUNT));
            c.stream(to.add(2 * L::COUNT));
        },
        // SAFETY: the caller's, of three times `COUNT` numbers.
        None => unsafe {
            a.store(to);
            b.store(to.add(L::COUNT));
            c.store(to.add(2 * L::COUNT));
        },
        Some(kept) => {
            let mut whole = [L::Number::default(); 48];
            let from = whole.as_mut_ptr();
            // SAFETY: no vector has more than 16 numbers, and `to` is the place of `kept` points.
            unsafe {
                a.store(from);
                b.store(from.add(L::COUNT));
                c.store(from.add(2 * L::COUNT));
                to.copy_from_nonoverlapping(from, 3 * kept);
            }
        }
    }
}

/// `multiplied * splat(*factor) + sum`
///
/// # Safety
/// As for [`Lanes`], and `factor` may be read.
#[inline(always)]
unsafe fn step<L: Lanes>(vector: L, factor: *const L::Number, sum: L) -> L {
    // SAFETY: the caller's.
    unsafe { vector.mul_add(L::splat(*factor), sum) }
}

macro_rules! position_tile {
    ($name:ident $all:ident, $rows:literal: $($sum:ident $row:literal)*) => {
        /// One tile of points. `left` holds, for number after number of a row, that of each row; `right` the first column's.
        ///
        /// # Safety
        /// As for [`put`] and every row of `to`; the tables have the rows of `parts`, and `left` as many numbers.
        #[inline(always)]
        unsafe fn $name<L: Lanes, const VECTORS_ALONG: bool, const STREAM: bool>(
            (mut left, right): (*const L::Number, *const L::Number),
            (parts, stride): (&[Vec<usize>], usize),
            to: &[*mut L::Number; $rows],
            kept: Option<usize>,
        ) {
            // SAFETY: the caller's; both pointers stay within the tables.
            unsafe {
                if VECTORS_ALONG {
                    $(let mut $sum = [L::splat(L::Number::default()); 3];)*
                    let mut right = right;
                    for _ in parts.iter().flatten() {
                        let (a, b, c) = (L::load(right), L::load(right.add(L::COUNT)), L::load(right.add(2 * L::COUNT)));
                        $(
                            let factor = left.add($row);
                            $sum = [step(a, factor, $sum[0]), step(b, factor, $sum[1]), step(c, factor, $sum[2])];
                        )*
                        left = left.add($rows);
                        right = right.wrapping_add(stride);
                    }
                    $(put::<L, STREAM>($sum, to[$row], kept);)*
                } else {
                    let [x, y, z] = parts else { return };
                    macro_rules! component {
                        ($part:ident) => {{
                            $(let mut $sum = L::splat(L::Number::default());)*
                            for r in $part {
                                let a = L::load(right.wrapping_add(r * stride));
                                $($sum = step(a, left.add($row), $sum);)*
                                left = left.add($rows);
                            }
                            [$($sum),*]
                        }};
                    }
                    let (x, y, z) = (component!(x), component!(y), component!(z));
                    $(put::<L, STREAM>(L::interleaved([x[$row], y[$row], z[$row]]), to[$row], kept);)*
                }
            }
        }

        /// All tiles.
        ///
        /// # Safety
        /// As for [`Lanes`]; the rows are in the tables and in the output.
        #[inline(always)]
        unsafe fn $all<L: Lanes, const VECTORS_ALONG: bool>(task: Positions<'_, L::Number>) {
            let Positions { stores, across, along, rows: Range { start, end }, points } = task;
            let columns = along.columns();
            let places = Places::new::<L::Number>(stores, (end - start, columns), $rows);
            let (parts, spread) = ((across.parts(), along.stride()), if VECTORS_ALONG { 3 } else { 1 });
            let (right, points) = (along.numbers().as_ptr(), points.as_mut_ptr());
            let mut packed = Vec::with_capacity(across.width() * $rows);
            for rows in places.tiles::<$rows>(end - start) {
                pack(&[across], rows.map(|row| start + row), &mut packed);
                let to = rows.map(|row| points.wrapping_add(row * columns));
                let at = |j: usize| to.map(|row| row.wrapping_add(j).cast::<L::Number>());
                let part = |j: usize| (packed.as_ptr(), right.wrapping_add(spread * j));
                let head = to.first().and_then(|row| places.head::<L>(*row)).filter(|head| head + L::COUNT <= columns);
                let mut j = head.unwrap_or(0);
                // SAFETY: `j` and what is kept stay below `columns`, and the tables can be read beyond by a tile. All
                // rows of a tile begin at the same place of a line, so that `head` fits all of them.
                unsafe {
                    if j > 0 {
                        $name::<L, VECTORS_ALONG, false>(part(0), parts, &at(0), Some(j));
                    }
                    while j + L::COUNT <= columns {
                        if head.is_some() {
                            $name::<L, VECTORS_ALONG, true>(part(j), parts, &at(j), None);
                        } else {
                            $name::<L, VECTORS_ALONG, false>(part(j), parts, &at(j), None);
                        }
                        j += L::COUNT;
                    }
                    if j < columns {
                        $name::<L, VECTORS_ALONG, false>(part(j), parts, &at(j), Some(columns - j));
                    }
                }
            }
        }
    };
}

position_tile!(tile_of_8 tiles_of_8, 8: a 0 b 1 c 2 d 3 e 4 f 5 g 6 h 7);
position_tile!(tile_of_4 tiles_of_4, 4: a 0 b 1 c 2 d 3);

impl<N: Number> Kernel<N> for Positions<'_, N> {
    #[inline(always)]
    unsafe fn run<L: Lanes<Number = N>>(self) -> f64 {
        // SAFETY: the caller's; whoever made this counted the rows.
        unsafe {
            match (L::HAS_MANY, self.along.components() == 3) {
                (true, true) => tiles_of_8::<L, true>(self),
                (true, false) => tiles_of_8::<L, false>(self),
                (false, true) => tiles_of_4::<L, true>(self),
                (false, false) => tiles_of_4::<L, false>(self),
            }
        }
        0.0
    }
}

/// For number after number of a row that of every row in a tile, one row after the other.
fn pack<N: Number, const ROWS: usize>(tables: &[&Across<N>], rows: [usize; ROWS], packed: &mut Vec<N>) {
    packed.clear();
    for index in 0..tables.first().map_or(0, |table| table.width()) {
        for row in rows {
            packed.extend(tables.iter().filter_map(|table| table.row(row).get(index)));
        }
    }
}

/// Rows of a shape that go through the same columns one after the other, while these are in the first-level cache.
const NEAR_ROWS: usize = 8;
/// Tiles along v that are near in the same sense.
const NEAR_TILES: usize = 4;

macro_rules! shape_tile {
    ($name:ident $all:ident, $rows:literal: $($s:ident $su:ident $sv:ident $row:literal)*) => {
        /// One tile of points, normals and perhaps tangents; the least square of a normal's length before it is made one.
        /// `left` holds, for number after number of a row, that and its slope of each row; `right` those of the first column.
        ///
        /// # Safety
        /// As for [`put`] and every row of every output; the tables have the rows of `parts`, and `left` as many numbers.
        #[inline(always)]
        unsafe fn $name<L: Lanes, const VECTORS_ALONG: bool, const STREAM: bool>(
            mut left: *const L::Number,
            [mut right, mut slope]: [*const L::Number; 2],
            (parts, stride): (&[Vec<usize>], usize),
            (to, has_tangents): ([[*mut L::Number; 4]; $rows], bool),
            kept: Option<usize>,
            least: L,
        ) -> L {
            // SAFETY: the caller's; all pointers stay within the tables.
            unsafe {
                let zero = [L::splat(L::Number::default()); 3];
                $(let (mut $s, mut $su, mut $sv) = (zero, zero, zero);)*
                if VECTORS_ALONG {
                    for _ in parts.iter().flatten() {
                        for d in 0..3 {
                            let (value, derivative) = (L::load(right), L::load(slope));
                            $(
                                let factor = left.add(2 * $row);
                                $s[d] = step(value, factor, $s[d]);
                                $su[d] = step(value, factor.add(1), $su[d]);
                                $sv[d] = step(derivative, factor, $sv[d]);
                            )*
                            (right, slope) = (right.wrapping_add(stride), slope.wrapping_add(stride));
                        }
                        left = left.add(2 * $rows);
                    }
                } else {
                    let [x, y, z] = parts else { return least };
                    macro_rules! component {
                        ($part:ident $d:literal) => {
                            for r in $part {
                                let at = r * stride;
                                let (value, derivative) =
                                    (L::load(right.wrapping_add(at)), L::load(slope.wrapping_add(at)));
                                $(
                                    let factor = left.add(2 * $row);
                                    $s[$d] = step(value, factor, $s[$d]);
                                    $su[$d] = step(value, factor.add(1), $su[$d]);
                                    $sv[$d] = step(derivative, factor, $sv[$d]);
                                )*
                                left = left.add(2 * $rows);
                            }
                        };
                    }
                    component!(x 0);
                    component!(y 1);
                    component!(z 2);
                }
                let mut least = least;
                $(
                    let [positions, normals, tangents_u, tangents_v] = to[$row];
                    put::<L, STREAM>(L::interleaved($s), positions, kept);
                    if has_tangents {
                        put::<L, STREAM>(L::interleaved($su), tangents_u, kept);
                        put::<L, STREAM>(L::interleaved($sv), tangents_v, kept);
                    }
                    let (normal, square) = unit_normal($su, $sv);
                    put::<L, STREAM>(L::interleaved(normal), normals, kept);
                    least = least.min(among_kept(square, kept));
                )*
                least
            }
        }

        /// All tiles.
        ///
        /// # Safety
        /// As for [`Lanes`]; the rows are in the tables and in the outputs.
        #[inline(always)]
        unsafe fn $all<L: Lanes, const VECTORS_ALONG: bool>(task: Shape<'_, L::Number>) -> f64 {
            let Shape { stores, across, along, rows: Range { start, end }, outputs } = task;
            let [right, slope] = along.map(|along| along.numbers().as_ptr());
            let along = along[0];
            let (columns, sizes) = (along.columns(), (across[0].parts(), along.stride()));
            let places = Places::new::<L::Number>(stores, (end - start, columns), $rows);
            let has_tangents = outputs.tangents.is_some();
            let [p, n] = [outputs.positions.as_mut_ptr(), outputs.normals.as_mut_ptr()];
            let [u, v] = outputs.tangents.map_or([p, n], |[u, v]| [u.as_mut_ptr(), v.as_mut_ptr()]);
            // One head for all: outputs that begin at different places of a line are not streamed.
            let are_alike = [n, u, v].iter().all(|output| output.addr() % LINE == p.addr() % LINE);
            let length = across[0].width() * 2 * $rows;
            let mut packed: Vec<Vec<L::Number>> = vec![Vec::with_capacity(length); NEAR_ROWS / $rows];
            // SAFETY: reads nothing.
            let mut least = unsafe { L::splat(L::Number::rounded(f64::INFINITY)) };
            for near in places.tiles::<NEAR_ROWS>(end - start) {
                let mut groups = [[0; $rows]; NEAR_ROWS / $rows];
                groups.as_flattened_mut().copy_from_slice(&near);
                for (rows, packed) in groups.iter().zip(&mut packed) {
                    pack(&across, rows.map(|row| start + row), packed);
                }
                let head = near.first().and_then(|row| places.head::<L>(p.wrapping_add(row * columns)));
                let head = head.filter(|head| are_alike && head + L::COUNT <= columns);
                let mut begin = 0;
                while begin < columns {
                    let first = if begin == 0 { head.unwrap_or(0) } else { 0 };
                    let past = columns.min(begin + first + NEAR_TILES * L::COUNT);
                    for (rows, packed) in groups.iter().zip(&packed) {
                        let mut j = begin;
                        while j < past {
                            let (next, kept) = match first {
                                1.. if j == 0 => (first, Some(first)),
                                _ if j + L::COUNT <= past => (j + L::COUNT, None),
                                _ => (past, Some(past - j)),
                            };
                            let mut to = [[std::ptr::null_mut(); 4]; $rows];
                            for (to, row) in to.iter_mut().zip(rows) {
                                let at = row * columns + j;
                                for (to, output) in to.iter_mut().zip([p, n, u, v]) {
                                    *to = output.wrapping_add(at).cast::<L::Number>();
                                }
                            }
                            let (left, to) = (packed.as_ptr(), (to, has_tangents));
                            let from = [right.wrapping_add(j), slope.wrapping_add(j)];
                            // SAFETY: `j` and what is kept stay below `columns`, and the tables can be read beyond by
                            // a tile. All rows of a tile begin at the same place of a line, so `head` fits them all.
                            least = unsafe {
                                if head.is_some() && kept.is_none() {
                                    $name::<L, VECTORS_ALONG, true>(left, from, sizes, to, kept, least)
                                } else {
                                    $name::<L, VECTORS_ALONG, false>(left, from, sizes, to, kept, least)
                                }
                            };
                            j = next;
                        }
                    }
                    begin = past;
                }
            }
            let mut lanes = [L::Number::default(); 16];
            // SAFETY: no vector has more than 16 numbers.
            unsafe { least.store(lanes.as_mut_ptr()) };
            lanes.iter().take(L::COUNT).fold(f64::INFINITY, |least, lane| least.min(lane.to_f64()))
        }
    };
}

shape_tile!(shape_of_2 shapes_of_2, 2: s0 su0 sv0 0 s1 su1 sv1 1);
shape_tile!(shape_of_1 shapes_of_1, 1: s0 su0 sv0 0);

/// `S_u x S_v` at unit length, and the square of its length.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn unit_normal<L: Lanes>([ux, uy, uz]: [L; 3], [vx, vy, vz]: [L; 3]) -> ([L; 3], L) {
    // SAFETY: the caller's.
    unsafe {
        let (x, y, z) = (uy.mul_sub(vz, uz.mul(vy)), uz.mul_sub(vx, ux.mul(vz)), ux.mul_sub(vy, uy.mul(vx)));
        let square = x.mul_add(x, y.mul_add(y, z.mul(z)));
        let inverse = square.inverse_root();
        ([x.mul(inverse), y.mul(inverse), z.mul(inverse)], square)
    }
}

/// `square`, infinite in lanes that are not kept.
///
/// # Safety
/// As for [`Lanes`].
#[inline(always)]
unsafe fn among_kept<L: Lanes>(square: L, kept: Option<usize>) -> L {
    let Some(kept) = kept else { return square };
    let mut lanes = [L::Number::default(); 16];
    // SAFETY: no vector has more than 16 numbers.
    unsafe {
        square.store(lanes.as_mut_ptr());
        lanes.iter_mut().skip(kept).for_each(|lane| *lane = L::Number::rounded(f64::INFINITY));
        L::load(lanes.as_ptr())
    }
}

impl<N: Number> Kernel<N> for Shape<'_, N> {
    #[inline(always)]
    unsafe fn run<L: Lanes<Number = N>>(self) -> f64 {
        // SAFETY: the caller's; whoever made this counted the rows.
        unsafe {
            match (L::HAS_MANY, self.along[0].components() == 3) {
                (true, true) => shapes_of_2::<L, true>(self),
                (true, false) => shapes_of_2::<L, false>(self),
                (false, true) => shapes_of_1::<L, true>(self),
                (false, false) => shapes_of_1::<L, false>(self),
            }
        }
    }
}
