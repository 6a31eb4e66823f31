//! Where the patches of a spec meet: the seams it states, and those that are there.

use std::sync::Arc;

use serde::Serialize;

use trimline::diagnostic::{Code, Diagnostic, Shortest};
use trimline::expr::Variable;
use trimline::problem::{DomainValues, Seam, SeamEdge, SidePart};
use trimline::surface::Surface;
use trimline::threads;
use trimline::verify::{Curve, Edge, Line, Parts, SeamDeviation, common_part};

use crate::failure::Failure;
use crate::parts::Located;
use crate::workflow::Spec;

/// Of the size of the edges: what is nearer than this is a seam, whose gap is worth knowing.
pub const NEAR: f64 = 1e-3;

/// Of the size of the edges: a seam that is stated must close as well as this.
const CLOSED: f64 = 1e-6;

/// Degrees by which a surface may turn at an edge that is declared smooth: more can be seen in a reflection.
const SMOOTH: f64 = 1e-3;

/// Of [`NEAR`]: a part that two sides have in common is longer than this, or it is a corner at which they meet.
const LONG: f64 = 10.0;

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
    /// The same as values of the coordinate that runs along the side.
    #[serde(skip)]
    pub along: Option<[f64; 2]>,
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
    #[cfg_attr(not(feature = "view"), expect(dead_code, reason = "only the view colours edges"))]
    pub along: [(Place, Vec<f64>); 2],
}

/// An edge to be measured.
#[derive(Clone, Copy, PartialEq)]
pub struct Place {
    /// Its patch among those that were solved.
    pub patch: usize,
    pub across: Variable,
    pub position: f64,
    /// From where to where the other coordinate runs; `None` for all of the side.
    along: Option<[f64; 2]>,
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
        self.along.is_none()
    }

    /// Whether both lie on one side of a patch.
    fn is_beside(&self, other: &Place) -> bool {
        (self.patch, self.across) == (other.patch, other.across) && self.position == other.position
    }

    /// The range along it, in a patch with the ranges of `domain`.
    fn line(&self, domain: &DomainValues) -> Line {
        let ranges = [domain.u, domain.v];
        let [domain, side] = if self.across == Variable::U { ranges } else { [ranges[1], ranges[0]] };
        Line { across: self.across, position: self.position, domain, along: self.along.unwrap_or(side) }
    }
}

impl EdgePlace {
    /// `low at u = 1`, `low at u = 1, v in [0, 0.5]`
    pub fn describe(&self) -> String {
        let ([name, other], position) =
            if let Some(u) = self.u { (["u", "v"], u) } else { (["v", "u"], self.v.unwrap_or(f64::NAN)) };
        let part = match self.along {
            None => String::new(),
            Some([start, end]) => format!(", {other} in [{}, {}]", shown(start.min(end)), shown(start.max(end))),
        };
        format!("{} at {name} = {}{part}", self.patch, Shortest(position))
    }
}

/// Seven digits: parts that were found have rounding errors behind them.
fn shown(value: f64) -> f64 {
    format!("{value:.6e}").parse().unwrap_or(value)
}

impl SeamReport {
    /// `seam low at u = 1 with high at u = 1`
    pub fn describe(&self) -> String {
        let [a, b] = &self.between;
        format!("seam {} with {}", a.describe(), b.describe())
    }
}

/// Measures the seams at `times`, at which `surfaces_at` gives those of the patches that exist then, and says which of the
/// stated ones are open, or not smooth where they should be, or never there.
pub fn measure<P: Located + Sync>(
    spec: &Spec,
    parts: &[&P],
    times: &[f64],
    surfaces_at: impl Fn(f64) -> Result<Vec<Option<Arc<dyn Surface + Send + Sync>>>, Failure>,
) -> Result<(Vec<SeamReport>, Vec<Diagnostic>), Failure> {
    let (mut places, mut pairs) = pairs(spec, parts)?;
    let mut size = 0.0_f64;
    for &time in times {
        let surfaces = surfaces_at(time)?;
        let sample = |place: &Place| -> Result<Option<Edge>, Failure> {
            let (Some(surface), Some(part)) = (surfaces.get(place.patch), parts.get(place.patch)) else {
                return Err(Failure::Machine("an edge of a patch that was not solved".to_owned()));
            };
            let Some(surface) = surface else { return Ok(None) };
            let edge = Edge::sample(&**surface, place.line(part.domain()), time);
            edge.map(Some).map_err(|finding| spec.fault(finding))
        };
        // Each edge once, however many pairs it is in.
        let mut is_wanted = vec![false; places.len()];
        for index in pairs.iter().flat_map(|pair| pair.between) {
            is_wanted.get_mut(index).into_iter().for_each(|wanted| *wanted = true);
        }
        let wanted = places.iter().zip(is_wanted).collect();
        let mut edges =
            threads::try_map(wanted, |(place, is_wanted)| if is_wanted { sample(place) } else { Ok(None) })?;
        size = edges.iter().flatten().fold(size, |most, edge| most.max(edge.extent()));
        let curve = |index: usize| {
            let place = places.get(index)?;
            let (surface, part) = (surfaces.get(place.patch)?.as_ref()?, parts.get(place.patch)?);
            let edge = edges.get(index)?.as_ref()?;
            Some(Curve { surface: &**surface, line: place.line(part.domain()), edge })
        };
        let found = overlaps(&places, &pairs, NEAR * size, |pair, gap| match pair.map(curve) {
            [Some(a), Some(b)] => common_part([a, b], time, gap).map_err(|finding| spec.fault(finding)),
            _ => Ok(None),
        })?;
        for between in found {
            let between = between.map(|place| index_of(place, &mut places));
            edges.resize(places.len(), None);
            for index in between {
                if let (Some(slot @ None), Some(place)) = (edges.get_mut(index), places.get(index)) {
                    *slot = sample(place)?;
                }
            }
            pairs.push(Pair { between, stated: None, worst: None, gaps: Default::default() });
        }
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
        // Edges that shrink to a point have no direction to meet in, and parts as short as what is near have none that is known.
        let is_point = |index: &usize| {
            let is_whole = places.get(*index).is_some_and(Place::is_whole);
            let least = if is_whole { CLOSED } else { LONG * NEAR };
            of(*index).is_some_and(|edge| edge.extent() <= least * size)
        };
        pairs.retain(|pair| {
            if pair.between.iter().any(|index| of(*index).is_none()) {
                return true;
            }
            let is_near = pair.worst.is_some_and(|worst| worst.gap <= NEAR * size);
            pair.stated.is_some() || (is_near && !pair.between.iter().any(is_point))
        });
    }
    let faults = pairs.iter().filter_map(|pair| fault(pair.stated?, pair.worst, size)).collect();
    Ok((pairs.into_iter().filter_map(|pair| report(&pair, &places, parts)).collect(), faults))
}

/// What is wrong with a stated seam.
fn fault(seam: &Seam, worst: Option<SeamDeviation>, size: f64) -> Option<Diagnostic> {
    let Some(worst) = worst else {
        let message = "the patches have no instant in common, so that they do not meet here";
        let finding = Diagnostic::new(Code::SeamApart, message).at(seam.origin);
        return Some(finding.hint("give both the same `domain t in [..]`, or leave out the seam"));
    };
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
        let domain = parts.get(place.patch)?.domain();
        let [low, high] = if is_at_u { domain.v } else { domain.u };
        let part = place.along.map(|ends| ends.map(|end| (end - low) / (high - low)));
        Some(EdgePlace { patch, u, v, part, along: place.along })
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
            places.extend(ends.map(|position| Place { patch, across, position, along: None }));
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
            let Some((patch, of)) = chosen.and_then(|patch| Some((patch, parts.get(patch)?))) else { continue };
            let domain = of.domain();
            let along = along(spec, part, if across == Variable::U { domain.v } else { domain.u }, seam)?;
            let place = Place { patch, across, position, along };
            between.push(index_of(place, &mut places));
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

/// The index of `place`, which is added if it is new.
fn index_of(place: Place, places: &mut Vec<Place>) -> usize {
    places.iter().position(|known| *known == place).unwrap_or_else(|| {
        places.push(place);
        places.len() - 1
    })
}

/// The ends of a part of a side with the range `[low, high]`; `None` if it is all of it.
fn along(spec: &Spec, part: SidePart, [low, high]: [f64; 2], seam: &Seam) -> Result<Option<[f64; 2]>, Failure> {
    let ends = match part {
        SidePart::Shares(shares) => shares.map(|share| if share == 1.0 { high } else { low + (high - low) * share }),
        SidePart::Values(ends) => {
            let value = |end| spec.bindings.constant(&spec.problem, end, seam.origin, "a part of a seam");
            let [start, end] = ends.map(value);
            [start.map_err(|finding| spec.fault(finding))?, end.map_err(|finding| spec.fault(finding))?]
        }
    };
    Ok((ends != [low, high] && ends != [high, low]).then_some(ends))
}

/// The parts that sides have in common, of all `pairs` of sides that are not stated and were not measured yet, by what
/// `common` says of two.
fn overlaps(
    places: &[Place],
    pairs: &[Pair<'_>],
    gap: f64,
    common: impl Fn([usize; 2], f64) -> Result<Option<Parts>, Failure>,
) -> Result<Vec<[Place; 2]>, Failure> {
    let place = |index: usize| places.get(index).copied();
    let of = |pair: &Pair<'_>| Some([place(pair.between[0])?, place(pair.between[1])?]);
    let stated: Vec<[Place; 2]> = pairs.iter().filter(|pair| pair.stated.is_some()).filter_map(of).collect();
    let mut found = Vec::new();
    for pair in pairs.iter().filter(|pair| pair.stated.is_none() && pair.worst.is_none()) {
        let Some([a, b]) = of(pair) else { continue };
        let Some([first, second]) = common(pair.between, gap)? else { continue };
        let is_known = |[one, other]: &[Place; 2]| {
            (one.is_beside(&a) && other.is_beside(&b)) || (one.is_beside(&b) && other.is_beside(&a))
        };
        if !stated.iter().any(is_known) {
            found.push([Place { along: first, ..a }, Place { along: second, ..b }]);
        }
    }
    Ok(found)
}
