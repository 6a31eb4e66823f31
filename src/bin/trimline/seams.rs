//! Where the patches of a spec meet: the seams it states, and those that are there.

use std::sync::Arc;

use serde::Serialize;

use trimline::diagnostic::{Code, Diagnostic, Shortest};
use trimline::expr::Variable;
use trimline::problem::{Seam, SeamEdge};
use trimline::surface::Surface;
use trimline::verify::{Edge, Line, SeamDeviation};

use crate::failure::Failure;
use crate::parts::Located;
use crate::workflow::Spec;

/// Of the size of the edges: what is nearer than this is a seam, whose gap is worth knowing.
pub const NEAR: f64 = 1e-3;

/// Of the size of the edges: a seam that is stated must close as well as this.
const CLOSED: f64 = 1e-6;

/// Degrees by which a surface may turn at an edge that is declared smooth: more can be seen in a reflection.
const SMOOTH: f64 = 1e-3;

/// All of a side.
const WHOLE: [f64; 2] = [0.0, 1.0];

/// An edge of constant u or v.
#[derive(Clone, Serialize)]
pub struct EdgePlace {
    pub patch: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub u: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub v: Option<f64>,
    /// Which part of the side, as shares of it; not there for a whole side.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<[f64; 2]>,
}

/// Two edges with what was measured between them.
#[derive(Serialize)]
pub struct SeamReport {
    pub between: [EdgePlace; 2],
    pub stated: bool,
    pub gap: f64,
    pub angle_degrees: Option<f64>,
    /// The edges among the patches that were measured, and the gap along each at the last instant.
    #[serde(skip)]
    pub along: [(Place, Vec<f64>); 2],
}

/// An edge to be measured.
#[derive(Clone, Copy, PartialEq)]
pub struct Place {
    /// Its patch among those that were solved.
    pub patch: usize,
    pub across: Variable,
    pub position: f64,
    part: [f64; 2],
}

/// A pair of edges, as their places in a list, and, if it is stated, the statement.
struct Pair<'a> {
    between: [usize; 2],
    stated: Option<&'a Seam>,
    worst: Option<SeamDeviation>,
    gaps: [Vec<f64>; 2],
}

impl Place {
    /// Whether this is all of a side.
    pub fn is_whole(&self) -> bool {
        self.part == WHOLE
    }
}

impl EdgePlace {
    /// `low at u = 1`
    pub fn describe(&self) -> String {
        let (name, position) = if let Some(u) = self.u { ("u", u) } else { ("v", self.v.unwrap_or(f64::NAN)) };
        let part = match self.part {
            None => String::new(),
            Some([start, end]) => format!(" from {start} to {end} of its length"),
        };
        format!("{} at {name} = {}{part}", self.patch, Shortest(position))
    }
}

/// Measures the seams at `times`, at which `surfaces_at` gives those of all patches, and says which of the stated ones
/// are open, or not smooth where they should be.
pub fn measure<P: Located>(
    spec: &Spec,
    parts: &[&P],
    times: &[f64],
    surfaces_at: impl Fn(f64) -> Result<Vec<Arc<dyn Surface + Send + Sync>>, Failure>,
) -> Result<(Vec<SeamReport>, Vec<Diagnostic>), Failure> {
    let (places, mut pairs) = pairs(spec, parts)?;
    let mut size = 0.0_f64;
    for &time in times {
        let surfaces = surfaces_at(time)?;
        let sample = |place: &Place| -> Result<Edge, Failure> {
            let (Some(surface), Some(part)) = (surfaces.get(place.patch), parts.get(place.patch)) else {
                return Err(Failure::Machine("an edge of a patch that was not solved".to_owned()));
            };
            let ranges = [part.domain().u, part.domain().v];
            let [domain, [low, high]] = if place.across == Variable::U { ranges } else { [ranges[1], ranges[0]] };
            let along = place.part.map(|share| if share == 1.0 { high } else { low + (high - low) * share });
            let line = Line { across: place.across, position: place.position, domain, along };
            Edge::sample(&**surface, line, time).map_err(|finding| spec.fault(finding))
        };
        // Each edge once, however many pairs it is in.
        let mut edges: Vec<Option<Edge>> = vec![None; places.len()];
        for index in pairs.iter().flat_map(|pair| pair.between) {
            if let (Some(slot @ None), Some(place)) = (edges.get_mut(index), places.get(index)) {
                *slot = Some(sample(place)?);
            }
        }
        size = edges.iter().flatten().fold(size, |most, edge| most.max(edge.extent()));
        let of = |index: usize| edges.get(index).and_then(Option::as_ref);
        for pair in &mut pairs {
            let [Some(a), Some(b)] = pair.between.map(of) else { continue };
            if pair.stated.is_none() && !a.may_meet(b, NEAR * size) {
                pair.worst = None;
                continue;
            }
            let here = a.meet(b);
            pair.gaps = a.gaps(b);
            pair.worst = Some(pair.worst.map_or(here, |before| before.worst(&here)));
        }
        // Edges that shrink to a point have no direction to meet in.
        let is_point = |index: &usize| of(*index).is_some_and(|edge| edge.extent() <= CLOSED * size);
        pairs.retain(|pair| {
            let is_near = pair.worst.is_some_and(|worst| worst.gap <= NEAR * size);
            pair.stated.is_some() || (is_near && !pair.between.iter().any(is_point))
        });
    }
    let faults = pairs.iter().filter_map(|pair| fault(pair.stated?, pair.worst?, size)).collect();
    Ok((pairs.into_iter().filter_map(|pair| report(&pair, &places, parts)).collect(), faults))
}

/// What is wrong with a stated seam.
fn fault(seam: &Seam, worst: SeamDeviation, size: f64) -> Option<Diagnostic> {
    if worst.gap > CLOSED * size {
        let message = format!("the patches do not meet here: they are up to {:.1e} apart", worst.gap);
        let finding = Diagnostic::new(Code::SeamApart, message).at(seam.origin);
        return Some(finding.hint("state the same boundary at both edges"));
    }
    let angle = worst.angle_degrees.filter(|angle| seam.is_smooth && *angle > SMOOTH)?;
    let message = format!("the two sides of this edge differ: the surface turns there by up to {angle:.3} degrees");
    Some(Diagnostic::new(Code::EdgeSidesDiffer, message).at(seam.origin).hint(
        "one patch must leave the edge against the other, with `flip` where both begin or both end there; `keeping C0` allows a crease",
    ))
}

fn report<P: Located>(pair: &Pair<'_>, places: &[Place], parts: &[&P]) -> Option<SeamReport> {
    let of = |index: usize| {
        let place = places.get(index)?;
        let patch = parts.get(place.patch)?.name().to_owned();
        let is_at_u = place.across == Variable::U;
        let (u, v) = (is_at_u.then_some(place.position), (!is_at_u).then_some(place.position));
        Some(EdgePlace { patch, u, v, part: Some(place.part).filter(|part| *part != WHOLE) })
    };
    let SeamDeviation { gap, angle_degrees } = pair.worst?;
    let ([a, b], [of_a, of_b]) = (pair.between, &pair.gaps);
    Some(SeamReport {
        between: [of(a)?, of(b)?],
        stated: pair.stated.is_some(),
        gap,
        angle_degrees,
        along: [(*places.get(a)?, of_a.clone()), (*places.get(b)?, of_b.clone())],
    })
}

/// The edges; then the stated seams of the chosen patches and every other pair of ends.
fn pairs<'a, P: Located>(spec: &'a Spec, parts: &[&P]) -> Result<(Vec<Place>, Vec<Pair<'a>>), Failure> {
    let mut places: Vec<Place> = Vec::new();
    for (patch, part) in parts.iter().enumerate() {
        let domain = part.domain();
        // Where data stand at fixed u only, the patch may close on itself in v.
        let at_v = part.is_four_sided().then_some((Variable::V, domain.v));
        for (across, ends) in [(Variable::U, domain.u)].into_iter().chain(at_v) {
            places.extend(ends.map(|position| Place { patch, across, position, part: WHOLE }));
        }
    }
    let ends = places.len();
    let mut pairs: Vec<Pair<'a>> = Vec::new();
    for seam in &spec.problem.seams {
        let mut between = Vec::with_capacity(2);
        for SeamEdge { patch, across, position, part } in seam.edges {
            let name = spec.problem.part_name(patch);
            let chosen = parts.iter().position(|part| Some(part.name()) == name);
            let position = spec.bindings.constant(&spec.problem, position, seam.origin, "the position of a seam");
            let position = position.map_err(|finding| spec.fault(finding))?;
            let Some(patch) = chosen else { continue };
            let place = Place { patch, across, position, part: if part == [1.0, 0.0] { WHOLE } else { part } };
            let known = places.iter().position(|known| *known == place);
            between.push(known.unwrap_or_else(|| {
                places.push(place);
                places.len() - 1
            }));
        }
        if let Ok(between) = <[usize; 2]>::try_from(between) {
            pairs.push(Pair { between, stated: Some(seam), worst: None, gaps: Default::default() });
        }
    }
    let stated: Vec<[usize; 2]> = pairs.iter().map(|pair| pair.between).collect();
    for first in 0..ends {
        for second in first + 1..ends {
            if !stated.iter().any(|known| *known == [first, second] || *known == [second, first]) {
                pairs.push(Pair { between: [first, second], stated: None, worst: None, gaps: Default::default() });
            }
        }
    }
    Ok((places, pairs))
}
