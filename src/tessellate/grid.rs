//! The resolution of a mesh, checked once.

use crate::diagnostic::{Code, Diagnostic};
use crate::limits::Limits;

/// How many quads a patch is cut into along u and along v.
///
/// Invariant: both counts are at least 1 and all vertices can be numbered by a `u32`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Grid {
    u_cells: u32,
    v_cells: u32,
    welds: bool,
}

impl Default for Grid {
    /// 64 quads across the blend, 128 along it.
    fn default() -> Self {
        Grid { u_cells: 64, v_cells: 128, welds: true }
    }
}

impl Grid {
    /// A grid of `u_cells` x `v_cells` quads.
    ///
    /// # Errors
    /// [`Code::SettingOutOfRange`] when a count is zero; [`Code::LimitReached`] when the
    /// `(u_cells + 1) * (v_cells + 1)` vertices are more than `limits.samples`, or than a `u32` can number.
    pub fn new(u_cells: usize, v_cells: usize, limits: &Limits) -> Result<Grid, Diagnostic> {
        for (cells, direction) in [(u_cells, "u"), (v_cells, "v")] {
            if cells == 0 {
                return Err(Diagnostic::new(
                    Code::SettingOutOfRange,
                    format!("the grid {u_cells}x{v_cells} has no quads along {direction}"),
                )
                .hint("a grid is NUxNV, both at least 1, for example 64x128"));
            }
        }
        let vertices = u_cells.checked_add(1).zip(v_cells.checked_add(1)).and_then(|(u, v)| u.checked_mul(v));
        let asked =
            vertices.map_or_else(|| "too many vertices to count".to_owned(), |count| format!("{count} vertices"));
        if vertices.is_none_or(|count| count > limits.samples) {
            return Err(Diagnostic::new(
                Code::LimitReached,
                format!("the grid {u_cells}x{v_cells} has {asked}, over the limit samples = {}", limits.samples),
            )
            .hint("choose a coarser grid, or raise the limit `samples`"));
        }
        let beyond_indices = || {
            Diagnostic::new(
                Code::LimitReached,
                format!(
                    "the grid {u_cells}x{v_cells} has {asked}, over the {} that 32-bit indices can number",
                    u32::MAX
                ),
            )
            .hint("choose a coarser grid")
        };
        if vertices.and_then(|count| u32::try_from(count).ok()).is_none() {
            return Err(beyond_indices());
        }
        match (u32::try_from(u_cells), u32::try_from(v_cells)) {
            (Ok(u_cells), Ok(v_cells)) => Ok(Grid { u_cells, v_cells, welds: true }),
            _ => Err(beyond_indices()),
        }
    }

    /// Quads along u.
    #[must_use]
    pub fn u_cells(self) -> usize {
        self.u_cells as usize
    }

    /// Quads along v.
    #[must_use]
    pub fn v_cells(self) -> usize {
        self.v_cells as usize
    }

    /// The same grid with every seam left open, so that the topology is the same whether a surface closes or not.
    ///
    /// A surface may close on itself at some instants only; the frames of an animation need one topology.
    #[must_use]
    pub fn with_open_seams(self) -> Grid {
        Grid { welds: false, ..self }
    }

    /// Whether surfaces that close on themselves are welded.
    pub(super) fn welds(self) -> bool {
        self.welds
    }

    /// The quads over u-major vertices; when closed in v there is no last column and the first stands in for it.
    pub(super) fn quads(self, is_closed_in_v: bool) -> Vec<[u32; 4]> {
        let columns = if is_closed_in_v { self.v_cells } else { self.v_cells + 1 };
        (0..self.u_cells)
            .flat_map(|i| (0..self.v_cells).map(move |j| (i * columns, j)))
            .map(|(row, j)| {
                let next = (j + 1) % columns;
                // First along u, then along v: counter-clockwise about S_u x S_v.
                [row + j, row + columns + j, row + columns + next, row + next]
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn limited(samples: usize) -> Limits {
        Limits { samples, ..Limits::default() }
    }

    #[test]
    fn default_grid_is_64_by_128_and_passes_its_own_check() {
        assert_eq!(Grid::new(64, 128, &Limits::default()), Ok(Grid::default()));
    }

    #[test]
    fn grid_without_quads_names_the_direction() {
        let refused = Grid::new(3, 0, &Limits::default()).unwrap_err();
        assert_eq!(refused.code, Code::SettingOutOfRange);
        assert_eq!(refused.message, "the grid 3x0 has no quads along v");
        assert!(Grid::new(0, 3, &Limits::default()).unwrap_err().message.ends_with("along u"));
    }

    #[test]
    fn grid_at_the_sample_limit_is_accepted() {
        assert!(Grid::new(3, 4, &limited(20)).is_ok());
    }

    #[test]
    fn grid_one_vertex_over_the_limit_says_limit_value_and_request() {
        let refused = Grid::new(3, 4, &limited(19)).unwrap_err();
        assert_eq!(refused.code, Code::LimitReached);
        assert_eq!(refused.message, "the grid 3x4 has 20 vertices, over the limit samples = 19");
    }

    #[test]
    fn grid_whose_vertex_count_overflows_is_refused() {
        for (u, v) in [(usize::MAX, 1), (1, usize::MAX), (usize::MAX / 2, 3), (usize::MAX, usize::MAX)] {
            assert_eq!(Grid::new(u, v, &limited(usize::MAX)).unwrap_err().code, Code::LimitReached);
        }
    }

    #[test]
    fn grid_beyond_32_bit_indices_is_refused_whatever_the_limit() {
        assert!(Grid::new(65_534, 65_536, &limited(usize::MAX)).is_ok(), "65535 * 65537 = u32::MAX vertices");
        let refused = Grid::new(65_535, 65_535, &limited(usize::MAX)).unwrap_err();
        assert_eq!(refused.code, Code::LimitReached);
        assert!(refused.message.contains("4294967296 vertices"), "{}", refused.message);
    }

    #[test]
    fn closed_quads_end_where_they_began() {
        let grid = Grid::new(1, 3, &Limits::default()).unwrap();
        assert_eq!(grid.quads(true), [[0, 3, 4, 1], [1, 4, 5, 2], [2, 5, 3, 0]]);
        assert_eq!(grid.quads(false), [[0, 4, 5, 1], [1, 5, 6, 2], [2, 6, 7, 3]]);
    }
}
