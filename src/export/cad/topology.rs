//! Faces, their edges and vertices, and the shells they make.

use crate::fit::SAME_PLACE;
use crate::surface::{BsplineCurve, KnotVector};

use super::Face;

/// What is topologically one: vertices, edges and shells of some faces.
pub(super) struct Topology {
    pub vertices: Vec<[f64; 3]>,
    pub edges: Vec<Edge>,
    pub shells: Vec<Shell>,
}

/// A curve between two vertices, which may be one.
pub(super) struct Edge {
    pub curve: BsplineCurve,
    pub ends: [usize; 2],
}

/// Connected faces.
pub(super) struct Shell {
    pub faces: Vec<OrientedFace>,
    /// Whether every edge has two faces.
    pub is_closed: bool,
}

/// A face with its boundary: edges in order, each with whether it is run through forwards, around `S_u x S_v`.
pub(super) struct OrientedFace {
    pub face: usize,
    /// Whether the shell's outside is against `S_u x S_v`.
    pub is_reversed: bool,
    pub boundary: Vec<(usize, bool)>,
}

/// Of the largest coordinate: sums of a few terms are off by as much.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A side of a face in its boundary.
#[derive(Clone, Copy)]
struct Side {
    edge: usize,
    is_forward: bool,
}

/// The topology of clamped `faces`.
///
/// All of them have an area, so that each has an edge.
pub(super) fn topology(faces: &[Face]) -> Topology {
    let tolerance = tolerance(faces);
    let mut sewing = Sewing { tolerance, vertices: Vec::new(), edges: Vec::new(), users: Vec::new() };
    let mut boundaries: Vec<Vec<Side>> = Vec::with_capacity(faces.len());
    for (index, face) in faces.iter().enumerate() {
        let mut boundary = Vec::with_capacity(4);
        for (curve, is_forward) in sides(face) {
            if !is_point(&curve, tolerance) {
                boundary.push(sewing.side(index, curve, is_forward));
            }
        }
        boundaries.push(boundary);
    }
    let (components, turned) = sewing.orient(&mut boundaries);
    let shell = |members: &Vec<usize>| {
        let face = |&face: &usize| OrientedFace {
            face,
            is_reversed: turned.get(face).copied().unwrap_or(false),
            boundary: boundaries.get(face).into_iter().flatten().map(|side| (side.edge, side.is_forward)).collect(),
        };
        let is_full = |face: &OrientedFace| {
            face.boundary.iter().all(|(edge, _)| sewing.users.get(*edge).is_some_and(|users| users.len() == 2))
        };
        let faces: Vec<OrientedFace> = members.iter().map(face).collect();
        Shell { is_closed: faces.iter().all(is_full), faces }
    };
    let shells = components.iter().map(shell).collect();
    Topology { vertices: sewing.vertices, edges: sewing.edges, shells }
}

/// Places that are this close are one: a share of the model's extent, and what coordinates are rounded to.
pub(super) fn tolerance(faces: &[Face]) -> f64 {
    let size = faces.iter().map(|face| face.surface.size()).fold(0.0, f64::max);
    (SAME_PLACE * extent(faces)).max(ROUNDING * size)
}

/// The longest side of the box around the control points.
pub(super) fn extent(faces: &[Face]) -> f64 {
    let points = || faces.iter().flat_map(|face| face.surface.net());
    (0..3)
        .map(|axis| {
            let along = || points().filter_map(move |point| point.get(axis)).copied();
            along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
        })
        .fold(0.0, f64::max)
}

/// The curves around a clamped face, and whether each is run through in its own direction.
fn sides(face: &Face) -> Vec<(BsplineCurve, bool)> {
    let [u, v] = face.surface.knots();
    let turned = face.surface.transposed();
    let rows = [face.surface.rows().next(), face.surface.rows().next_back()];
    let columns = [turned.rows().next(), turned.rows().next_back()];
    let curve =
        |knots: &KnotVector, points: Option<&[[f64; 3]]>| BsplineCurve::new(knots.clone(), points?.to_vec()).ok();
    let ([first_row, last_row], [first_column, last_column]) = (rows, columns);
    let all = [(u, first_column, true), (v, last_row, true), (u, last_column, false), (v, first_row, false)];
    all.into_iter().filter_map(|(knots, points, is_forward)| Some((curve(knots, points)?, is_forward))).collect()
}

fn is_point(curve: &BsplineCurve, tolerance: f64) -> bool {
    let Some(first) = curve.points().first() else { return true };
    curve.points().iter().all(|point| are_close(point, first, tolerance))
}

fn are_close(p: &[f64; 3], q: &[f64; 3], tolerance: f64) -> bool {
    p.iter().zip(q).all(|(p, q)| (p - q).abs() <= tolerance)
}

/// Whether two curves are one, run through alike.
fn are_same(one: &BsplineCurve, other: &BsplineCurve, tolerance: f64) -> bool {
    let knots = |curve: &BsplineCurve| {
        let [start, end] = curve.knots().domain();
        curve.knots().as_slice().iter().map(move |knot| (knot - start) / (end - start)).collect::<Vec<f64>>()
    };
    one.points().len() == other.points().len()
        && one.knots().degree() == other.knots().degree()
        && one.points().iter().zip(other.points()).all(|(p, q)| are_close(p, q, tolerance))
        && knots(one).iter().zip(knots(other)).all(|(a, b)| (a - b).abs() <= SAME_PLACE)
}

/// Edges and vertices as they are found.
struct Sewing {
    tolerance: f64,
    vertices: Vec<[f64; 3]>,
    edges: Vec<Edge>,
    /// The faces at each edge, with the direction in which they run through it; at most two.
    users: Vec<Vec<(usize, bool)>>,
}

impl Sewing {
    /// The side of `face` along `curve`, on an edge that is there already or a new one.
    fn side(&mut self, face: usize, curve: BsplineCurve, is_forward: bool) -> Side {
        let backwards = curve.reversed();
        for (index, (edge, users)) in self.edges.iter().zip(&mut self.users).enumerate() {
            let is_same = are_same(&edge.curve, &curve, self.tolerance);
            if !is_same && !are_same(&edge.curve, &backwards, self.tolerance) {
                continue;
            }
            let is_forward = is_forward == is_same;
            // A third face, or a face that runs through its own seam twice the same way, does not make a surface.
            let fits = users.len() < 2 && !users.contains(&(face, is_forward));
            if fits {
                users.push((face, is_forward));
                return Side { edge: index, is_forward };
            }
        }
        let ends = [curve.points().first(), curve.points().last()].map(|end| end.copied().unwrap_or_default());
        let ends = ends.map(|end| self.vertex(end));
        self.edges.push(Edge { curve, ends });
        self.users.push(vec![(face, is_forward)]);
        Side { edge: self.edges.len() - 1, is_forward }
    }

    fn vertex(&mut self, place: [f64; 3]) -> usize {
        if let Some(index) = self.vertices.iter().position(|other| are_close(other, &place, self.tolerance)) {
            return index;
        }
        self.vertices.push(place);
        self.vertices.len() - 1
    }

    /// Connected faces, and which of them to turn, so that two faces run through their edge in opposite directions.
    ///
    /// Where that is impossible, as on a Möbius strip, an edge is taken apart.
    fn orient(&mut self, boundaries: &mut [Vec<Side>]) -> (Vec<Vec<usize>>, Vec<bool>) {
        let mut turned: Vec<Option<bool>> = vec![None; boundaries.len()];
        let mut components = Vec::new();
        for first in 0..boundaries.len() {
            if turned.get(first).is_none_or(Option::is_some) {
                continue;
            }
            let mut members = vec![first];
            set(&mut turned, first, false);
            let mut next = 0;
            while let Some(&face) = members.get(next) {
                next += 1;
                for (neighbour, is_turned) in self.neighbours(face, boundaries, &turned) {
                    if turned.get(neighbour).is_some_and(Option::is_none) {
                        set(&mut turned, neighbour, is_turned);
                        members.push(neighbour);
                    }
                }
            }
            components.push(members);
        }
        let turned: Vec<bool> = turned.into_iter().map(|turned| turned.unwrap_or(false)).collect();
        self.take_apart(boundaries, &turned);
        (components, turned)
    }

    /// The other faces at the edges of `face`, with how they must be turned.
    fn neighbours(&self, face: usize, boundaries: &[Vec<Side>], turned: &[Option<bool>]) -> Vec<(usize, bool)> {
        let is_turned = turned.get(face).copied().flatten().unwrap_or(false);
        let mut found = Vec::new();
        for side in boundaries.get(face).into_iter().flatten() {
            let users = self.users.get(side.edge).into_iter().flatten();
            for (other, is_forward) in users.filter(|(other, _)| *other != face) {
                found.push((*other, is_turned != (side.is_forward == *is_forward)));
            }
        }
        found
    }

    fn take_apart(&mut self, boundaries: &mut [Vec<Side>], turned: &[bool]) {
        let direction = |(face, is_forward): &(usize, bool)| turned.get(*face).copied().unwrap_or(false) != *is_forward;
        for index in 0..self.edges.len() {
            let Some([one, other]) = self.users.get(index).map(Vec::as_slice) else { continue };
            if direction(one) != direction(other) {
                continue;
            }
            let other = *other;
            let Some(Edge { curve, ends }) = self.edges.get(index) else { continue };
            let copy = Edge { curve: curve.clone(), ends: *ends };
            self.edges.push(copy);
            self.users.push(vec![other]);
            let own = self.edges.len() - 1;
            let sides = boundaries.get_mut(other.0).into_iter().flatten();
            sides.filter(|side| side.edge == index).for_each(|side| side.edge = own);
            if let Some(users) = self.users.get_mut(index) {
                users.truncate(1);
            }
        }
    }
}

fn set(turned: &mut [Option<bool>], face: usize, is_turned: bool) {
    if let Some(slot) = turned.get_mut(face) {
        *slot = Some(is_turned);
    }
}
