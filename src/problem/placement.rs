//! Where copies of patches are: rigid motions and reflections, symbolically.

use crate::diagnostic::Span;
use crate::expr::{ExprId, Function, Graph};

/// A copy of a patch.
#[derive(Debug, Clone)]
pub struct PatchCopy {
    /// What it is called.
    pub name: String,
    /// What it is a copy of, as its place among the problem's patches and nets.
    pub original: usize,
    /// Where it is.
    pub placement: Placement,
    /// Where it is stated.
    pub origin: Option<Span>,
}

/// The map `p -> linear p + offset`, which keeps lengths; constants, params and t may stand in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Placement {
    /// The rows of the matrix.
    pub linear: [[ExprId; 3]; 3],
    /// The image of the origin.
    pub offset: [ExprId; 3],
}

impl Placement {
    /// A copy that lies where the original does.
    pub fn identity(graph: &mut Graph) -> Placement {
        let (zero, one) = (graph.integer(0), graph.integer(1));
        Placement { linear: [[one, zero, zero], [zero, one, zero], [zero, zero, one]], offset: [zero; 3] }
    }

    /// The reflection in the plane where component number `axis` is `at`.
    pub fn mirrored(graph: &mut Graph, axis: usize, at: ExprId) -> Placement {
        let mut placement = Placement::identity(graph);
        let (minus, twice) = (graph.integer(-1), graph.sum([at, at]));
        if let Some(entry) = placement.linear.get_mut(axis).and_then(|row| row.get_mut(axis)) {
            *entry = minus;
        }
        if let Some(entry) = placement.offset.get_mut(axis) {
            *entry = twice;
        }
        placement
    }

    /// The rotation by `angle` about the line through the origin along component number `axis`, by the right-hand rule.
    pub fn rotated(graph: &mut Graph, axis: usize, angle: ExprId) -> Placement {
        let mut placement = Placement::identity(graph);
        let (cos, sin) = (graph.call(Function::Cos, &[angle]), graph.call(Function::Sin, &[angle]));
        let against = graph.neg(sin);
        let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
        for (row, column, value) in [(a, a, cos), (a, b, against), (b, a, sin), (b, b, cos)] {
            if let Some(entry) = placement.linear.get_mut(row).and_then(|row| row.get_mut(column)) {
                *entry = value;
            }
        }
        placement
    }

    /// The translation by a vector.
    pub fn moved(graph: &mut Graph, by: [ExprId; 3]) -> Placement {
        Placement { offset: by, ..Placement::identity(graph) }
    }

    /// The image of a point, or of a direction.
    pub fn image(&self, graph: &mut Graph, vector: [ExprId; 3], is_direction: bool) -> [ExprId; 3] {
        let mut image = self.offset;
        for (slot, row) in image.iter_mut().zip(self.linear) {
            let mut terms: Vec<ExprId> = row.into_iter().zip(vector).map(|(a, x)| graph.product([a, x])).collect();
            if !is_direction {
                terms.push(*slot);
            }
            *slot = graph.sum(terms);
        }
        image
    }

    /// This after `first`.
    pub fn after(&self, graph: &mut Graph, first: &Placement) -> Placement {
        let offset = self.image(graph, first.offset, false);
        let mut linear = first.linear;
        for column in 0..3 {
            let of = |row: &[ExprId; 3]| row.get(column).copied();
            let [Some(x), Some(y), Some(z)] = first.linear.each_ref().map(of) else { continue };
            let image = self.image(graph, [x, y, z], true);
            for (row, value) in linear.iter_mut().zip(image) {
                if let Some(entry) = row.get_mut(column) {
                    *entry = value;
                }
            }
        }
        Placement { linear, offset }
    }

    /// The twelve entries, row after row, the offset last.
    #[must_use]
    pub fn entries(&self) -> [ExprId; 12] {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.linear;
        let [x, y, z] = self.offset;
        [a, b, c, d, e, f, g, h, i, x, y, z]
    }
}
