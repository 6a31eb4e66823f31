//! Where the patches of a spec meet: the seams it states, and those that are there.

use std::sync::Arc;

use serde::Serialize;

use trimline::diagnostic::{Code, Diagnostic};
use trimline::problem::Seam;
use trimline::surface::Surface;
use trimline::verify::{Edge, SeamDeviation};

use crate::failure::Failure;
use crate::parts::Located;
use crate::workflow::Spec;

/// Of the size of the edges: what is nearer than this is a seam, whose gap is worth knowing.
pub const NEAR: f64 = 1e-3;

/// Of the size of the edges: a seam that is stated must close as well as this.
const CLOSED: f64 = 1e-6;

/// An edge of constant u.
#[derive(Clone, Serialize)]
pub struct EdgePlace {
    pub patch: String,
    pub u: f64,
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

/// An edge to be measured: its patch among those that were solved, and its u.
pub type Place = (usize, f64);

/// A pair of edges and, if it is stated, the statement.
struct Pair<'a> {
    between: [Place; 2],
    stated: Option<&'a Seam>,
    worst: Option<SeamDeviation>,
    gaps: [Vec<f64>; 2],
}

/// Measures the seams at `times`, at which `surfaces_at` gives those of all patches, and says which of the stated ones
/// are open.
pub fn measure<P: Located>(
    spec: &Spec,
    parts: &[&P],
    times: &[f64],
    surfaces_at: impl Fn(f64) -> Result<Vec<Arc<dyn Surface + Send + Sync>>, Failure>,
) -> Result<(Vec<SeamReport>, Vec<Diagnostic>), Failure> {
    let mut pairs = pairs(spec, parts)?;
    let mut size = 0.0_f64;
    for &time in times {
        let surfaces = surfaces_at(time)?;
        let sample = |(patch, u): Place| -> Result<Edge, Failure> {
            let (Some(surface), Some(part)) = (surfaces.get(patch), parts.get(patch)) else {
                return Err(Failure::Machine("an edge of a patch that was not solved".to_owned()));
            };
            let domain = part.domain();
            Edge::sample(&**surface, (u, domain.u), domain.v, time).map_err(|finding| spec.fault(finding))
        };
        // Each edge once, however many pairs it is in.
        let mut edges: Vec<(Place, Edge)> = Vec::new();
        for place in pairs.iter().flat_map(|pair| pair.between) {
            if edges.iter().all(|(known, _)| *known != place) {
                edges.push((place, sample(place)?));
            }
        }
        size = edges.iter().fold(size, |most, (_, edge)| most.max(edge.extent()));
        for pair in &mut pairs {
            let [a, b] = pair.between.map(|place| edges.iter().find(|(known, _)| *known == place));
            let (Some((_, a)), Some((_, b))) = (a, b) else { continue };
            let here = a.meet(b);
            pair.gaps = a.gaps(b);
            pair.worst = Some(pair.worst.map_or(here, |before| before.worst(&here)));
        }
        // Edges that shrink to a point have no direction to meet in.
        let is_point =
            |place: &Place| edges.iter().any(|(known, edge)| known == place && edge.extent() <= CLOSED * size);
        pairs.retain(|pair| {
            let is_near = pair.worst.is_some_and(|worst| worst.gap <= NEAR * size);
            pair.stated.is_some() || (is_near && !pair.between.iter().any(is_point))
        });
    }
    let open = pairs.iter().filter(|pair| pair.worst.is_some_and(|worst| worst.gap > CLOSED * size));
    let open = open.filter_map(|pair| Some((pair.stated?, pair.worst?)));
    let open = open.map(|(seam, worst)| {
        let message = format!("the patches do not meet here: they are up to {:.1e} apart", worst.gap);
        Diagnostic::new(Code::SeamApart, message).at(seam.origin).hint("state the same boundary at both edges")
    });
    let open = open.collect();
    Ok((pairs.into_iter().filter_map(|pair| report(pair, parts)).collect(), open))
}

fn report<P: Located>(pair: Pair<'_>, parts: &[&P]) -> Option<SeamReport> {
    let place = |(patch, u): Place| {
        let name = parts.get(patch).map(|part| part.name().to_owned());
        EdgePlace { patch: name.unwrap_or_default(), u }
    };
    let SeamDeviation { gap, angle_degrees } = pair.worst?;
    let ([first, second], [of_first, of_second]) = (pair.between, pair.gaps);
    Some(SeamReport {
        between: pair.between.map(place),
        stated: pair.stated.is_some(),
        gap,
        angle_degrees,
        along: [(first, of_first), (second, of_second)],
    })
}

/// The stated seams of the chosen patches, then every other pair of ends.
fn pairs<'a, P: Located>(spec: &'a Spec, parts: &[&P]) -> Result<Vec<Pair<'a>>, Failure> {
    let mut pairs: Vec<Pair<'a>> = Vec::new();
    for seam in &spec.problem.seams {
        let mut between = Vec::with_capacity(2);
        for (patch, u) in seam.edges {
            let name = spec.problem.part_name(patch);
            let chosen = parts.iter().position(|part| Some(part.name()) == name);
            let u = spec.bindings.constant(&spec.problem, u, seam.origin, "the position of a seam");
            between.extend(chosen.zip(Some(u.map_err(|finding| spec.fault(finding))?)));
        }
        if let Ok(between) = <[Place; 2]>::try_from(between) {
            pairs.push(Pair { between, stated: Some(seam), worst: None, gaps: Default::default() });
        }
    }
    let stated = pairs.len();
    let ends = parts.iter().enumerate().flat_map(|(index, part)| part.domain().u.map(|u| (index, u)));
    let ends: Vec<Place> = ends.collect();
    for (index, &first) in ends.iter().enumerate() {
        for &second in ends.iter().skip(index + 1) {
            let is_known = |pair: &Pair<'_>| pair.between == [first, second] || pair.between == [second, first];
            if !pairs.iter().take(stated).any(is_known) {
                pairs.push(Pair { between: [first, second], stated: None, worst: None, gaps: Default::default() });
            }
        }
    }
    Ok(pairs)
}
