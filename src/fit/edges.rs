//! Edges that targets have in common: found on the surfaces, and given one row of control points.

use crate::diagnostic::Diagnostic;
use crate::expr::Derivative;
use crate::numeric::{NodeKind, nodes};
use crate::surface::BsplineSurface;

use super::Target;
use super::breakpoints::Link;
use super::measure::distance;

/// Of the extent of a model: places that are this close are one. Patches with a common edge have it in common to rounding;
/// what is further apart is meant to be.
pub const SAME_PLACE: f64 = 1e-9;

/// Places on an edge, besides its ends, at which it is compared: at no regular shares, symmetric.
const LOOKS: usize = 11;

/// A side of a target: the curve along u (axis 0) or v (axis 1) at an end of the other parameter.
#[derive(Clone, Copy)]
struct Side {
    target: usize,
    axis: usize,
    is_high: bool,
}

/// Two sides that are one curve at equal shares of their ranges, or at opposite ones if reversed.
struct Common {
    sides: [Side; 2],
    is_reversed: bool,
}

/// All edges that sides have in common.
pub(super) struct Edges {
    common: Vec<Common>,
    tolerance: f64,
}

impl Edges {
    /// Looks for sides that are one. Sides that are points have nothing in common.
    ///
    /// Quadratic in the number of targets.
    pub fn new(targets: &[Target], t: f64) -> Result<Edges, Diagnostic> {
        let mut sides: Vec<(Side, Vec<[f64; 3]>)> = Vec::with_capacity(4 * targets.len());
        for (target, one) in targets.iter().enumerate() {
            for axis in 0..2 {
                for is_high in [false, true] {
                    sides.push((Side { target, axis, is_high }, looked_at(one, axis, is_high, t)?));
                }
            }
        }
        let tolerance = SAME_PLACE * extent(sides.iter().flat_map(|(_, places)| places));
        let are_close = |p: &[f64; 3], q: &[f64; 3]| distance(p, q) <= tolerance;
        sides.retain(|(_, places)| {
            places.first().is_some_and(|first| !places.iter().all(|place| are_close(first, place)))
        });
        let mut common = Vec::new();
        for (index, (side, places)) in sides.iter().enumerate() {
            for (other, others) in sides.iter().skip(index + 1) {
                let meets = |is_reversed: bool| {
                    let at = |index: usize| if is_reversed { others.len() - 1 - index } else { index };
                    let mut pairs = places.iter().enumerate().map(|(index, place)| (place, others.get(at(index))));
                    pairs.all(|(place, other)| other.is_some_and(|other| are_close(place, other)))
                };
                if let Some(is_reversed) = [false, true].into_iter().find(|is_reversed| meets(*is_reversed)) {
                    common.push(Common { sides: [*side, *other], is_reversed });
                }
            }
        }
        Ok(Edges { common, tolerance })
    }

    /// Which parameters need breakpoints in common; the members are u and v of each target, in order.
    pub fn links(&self) -> Vec<Link> {
        let member = |side: Side| 2 * side.target + side.axis;
        let link = |common: &Common| Link { members: common.sides.map(member), is_reversed: common.is_reversed };
        self.common.iter().map(link).collect()
    }

    /// Gives clamped fits, one for each target, equal control points along common edges: those of the first side.
    ///
    /// They are equal but for what their surfaces differ by; where they are not, they stay as they are.
    pub fn unite(&self, fits: Vec<BsplineSurface>) -> Vec<BsplineSurface> {
        let mut nets: Vec<Net> = fits.into_iter().map(Net::new).collect();
        // Corners first: an edge that is copied then changes no corner of another.
        let mut corners: Vec<Vec<(usize, usize)>> = Vec::new();
        let mut edges = Vec::with_capacity(self.common.len());
        for common in &self.common {
            let [first, mut second] =
                common.sides.map(|side| nets.get(side.target).map(|net| net.side(side)).unwrap_or_default());
            if common.is_reversed {
                second.reverse();
            }
            let [one, other] = common.sides.map(|side| side.target);
            let point = |target: usize, place: usize| nets.get(target).and_then(|net| net.points.get(place));
            let is_close = |(p, q): (&usize, &usize)| match (point(one, *p), point(other, *q)) {
                (Some(p), Some(q)) => distance(p, q) <= self.tolerance,
                _ => false,
            };
            if first.len() != second.len() || !first.iter().zip(&second).all(is_close) {
                continue;
            }
            for ends in [(first.first(), second.first()), (first.last(), second.last())] {
                if let (Some(p), Some(q)) = ends {
                    merge(&mut corners, [(one, *p), (other, *q)]);
                }
            }
            edges.push(([one, other], first, second));
        }
        for corner in corners {
            let place = corner.first().and_then(|(target, place)| nets.get(*target)?.points.get(*place)).copied();
            for (target, at) in corner {
                set(&mut nets, target, at, place);
            }
        }
        for ([one, other], first, second) in edges {
            for (from, to) in first.into_iter().zip(second) {
                let place = nets.get(one).and_then(|net| net.points.get(from)).copied();
                set(&mut nets, other, to, place);
            }
        }
        nets.into_iter().map(Net::into_surface).collect()
    }
}

/// A surface whose control points can be moved.
struct Net {
    surface: BsplineSurface,
    points: Vec<[f64; 3]>,
}

impl Net {
    fn new(surface: BsplineSurface) -> Net {
        Net { points: surface.net().to_vec(), surface }
    }

    /// Where the control points of a side are.
    fn side(&self, side: Side) -> Vec<usize> {
        let [rows, columns] = self.surface.knots().map(|knots| knots.points());
        match (side.axis, side.is_high) {
            (0, false) => (0..rows).map(|i| i * columns).collect(),
            (0, true) => (0..rows).map(|i| (i + 1) * columns - 1).collect(),
            (_, false) => (0..columns).collect(),
            (_, true) => ((rows - 1) * columns..rows * columns).collect(),
        }
    }

    fn into_surface(self) -> BsplineSurface {
        let [u, v] = self.surface.knots().map(Clone::clone);
        // As many points as before, and finite.
        BsplineSurface::new(u, v, self.points).unwrap_or(self.surface)
    }
}

fn set(nets: &mut [Net], target: usize, at: usize, place: Option<[f64; 3]>) {
    let slot = nets.get_mut(target).and_then(|net| net.points.get_mut(at));
    if let (Some(slot), Some(place)) = (slot, place) {
        *slot = place;
    }
}

/// Puts two corners into one set.
fn merge(sets: &mut Vec<Vec<(usize, usize)>>, corners: [(usize, usize); 2]) {
    let mut united: Vec<(usize, usize)> = Vec::new();
    sets.retain(|set| {
        let is_met = corners.iter().any(|corner| set.contains(corner));
        if is_met {
            united.extend(set);
        }
        !is_met
    });
    united.extend(corners);
    united.sort_unstable();
    united.dedup();
    sets.push(united);
}

/// Points along a side, at symmetric shares of its range.
fn looked_at(target: &Target, axis: usize, is_high: bool, t: f64) -> Result<Vec<[f64; 3]>, Diagnostic> {
    let (along, across) = if axis == 0 { (target.u, target.v) } else { (target.v, target.u) };
    let inner = nodes(NodeKind::Chebyshev, LOOKS, along);
    let places: Vec<f64> = along.into_iter().take(1).chain(inner).chain(along.into_iter().skip(1)).collect();
    let [low, high] = across;
    let fixed = [if is_high { high } else { low }];
    let axes = if axis == 0 { (places.as_slice(), &fixed[..], t) } else { (&fixed[..], places.as_slice(), t) };
    let mut values = vec![[0.0; 3]; places.len()];
    target.surface.evaluate_grid(Derivative::NONE, axes, &mut values)?;
    Ok(values)
}

fn extent<'a>(points: impl Iterator<Item = &'a [f64; 3]> + Clone) -> f64 {
    let along = |axis: usize| points.clone().filter_map(move |point| point.get(axis)).copied();
    let side = |axis| along(axis).fold(f64::NEG_INFINITY, f64::max) - along(axis).fold(f64::INFINITY, f64::min);
    (0..3).map(side).fold(0.0, f64::max)
}
