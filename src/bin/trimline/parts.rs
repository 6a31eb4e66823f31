//! The parts of a document as commands see them: patches, B-spline nets and copies of both, each a surface at every
//! instant.

use std::sync::Arc;

use trimline::blend::prepare_net;
use trimline::diagnostic::{Code, Diagnostic, Diagnostics, Shortest};
use trimline::eval::Backend;
use trimline::method::Options;
use trimline::net::{NetSolver, SolvedNet};
use trimline::problem::{DomainValues, Net, PatchCopy};
use trimline::surface::{BsplineSurface, CompiledPlacement, PlacedSurface, Surface};
use trimline::threads;

use crate::failure::Failure;
use crate::options::{Solving, option_finding};
use crate::workflow::{Patched, Spec};

/// What has a name and a domain.
pub trait Located {
    fn name(&self) -> &str;

    fn domain(&self) -> &DomainValues;

    /// Whether data stand at fixed v as well, so that its ends in v are edges.
    fn is_four_sided(&self) -> bool;

    /// The instant the user asked for, which must lie in the time domain, or the domain's start.
    fn instant(&self, time: Option<f64>) -> Result<f64, Failure> {
        let [start, end] = self.domain().t;
        match time {
            None => Ok(start),
            Some(time) if (start..=end).contains(&time) => Ok(time),
            Some(time) => {
                let (time, start, end) = (Shortest(time), Shortest(start), Shortest(end));
                let message = format!("t = {time} lies outside the time domain [{start}, {end}] of `{}`", self.name());
                let finding = Diagnostic::new(Code::PointOutsideDomain, message)
                    .hint("choose an instant inside, or widen `domain t in [..]` in the spec");
                Err(option_finding("time", &time.to_string(), finding))
            }
        }
    }
}

impl<P: Located> Located for &P {
    fn name(&self) -> &str {
        (**self).name()
    }

    fn domain(&self) -> &DomainValues {
        (**self).domain()
    }

    fn is_four_sided(&self) -> bool {
        (**self).is_four_sided()
    }
}

impl Located for Patched {
    fn name(&self) -> &str {
        &self.prepared.patch().name
    }

    fn domain(&self) -> &DomainValues {
        &self.prepared.domain
    }

    fn is_four_sided(&self) -> bool {
        self.prepared.patch().is_four_sided()
    }
}

/// A part that is ready at any instant.
#[derive(Clone)]
pub enum Part {
    Patch(Arc<Patched>),
    Net(Arc<NetSolver>),
    Copy(Arc<Copied>),
}

/// A copy, which is solved with its original.
pub struct Copied {
    pub copy: PatchCopy,
    pub original: Part,
    /// Whether it speaks for its original, which is not among the parts: what is to be said and measured of it.
    pub stands_in: bool,
    pub placement: Arc<CompiledPlacement>,
}

impl Located for Part {
    fn name(&self) -> &str {
        match self {
            Part::Patch(patch) => patch.name(),
            Part::Net(net) => &net.net.name,
            Part::Copy(copied) => &copied.copy.name,
        }
    }

    fn domain(&self) -> &DomainValues {
        match self {
            Part::Patch(patch) => patch.domain(),
            Part::Net(net) => &net.domain,
            Part::Copy(copied) => copied.original.domain(),
        }
    }

    fn is_four_sided(&self) -> bool {
        match self {
            Part::Patch(patch) => patch.is_four_sided(),
            Part::Net(_) => true,
            Part::Copy(copied) => copied.original.is_four_sided(),
        }
    }
}

/// A part at one instant.
pub struct Shape {
    pub surface: Arc<dyn Surface + Send + Sync>,
    pub warnings: Diagnostics,
    /// The net behind it, if it is one.
    pub net: Option<SolvedNet>,
    /// The B-spline that it is, if it is one: a net, or a copy of one.
    pub bspline: Option<BsplineSurface>,
}

impl Spec {
    /// Everything the user asked for, compiled: patches, then nets, then copies.
    pub fn parts(&self, solving: &Solving, points: Option<&str>) -> Result<Vec<Part>, Failure> {
        let prepare = |patch| self.prepare(patch, solving, points).map(|patched| Part::Patch(Arc::new(patched)));
        let mut parts = threads::try_map(self.patches.iter().collect(), prepare)?;
        for net in &self.nets {
            parts.push(Part::Net(Arc::new(self.prepare_net(net, solving, points)?)));
        }
        if self.copies.is_empty() {
            return Ok(parts);
        }
        let graph = Arc::new(self.problem.graph.clone());
        let mut originals = parts.clone();
        for copy in &self.copies {
            let name = self.problem.part_name(copy.original);
            let known = originals.iter().find(|part| Some(part.name()) == name).cloned();
            // The user asked for the copy alone.
            let stands_in = known.is_none();
            let original = match known {
                Some(original) => original,
                None => self.original(copy, solving, points)?,
            };
            if stands_in {
                originals.push(original.clone());
            }
            let placement = Arc::new(CompiledPlacement::new(&graph, copy, &self.limits));
            parts.push(Part::Copy(Arc::new(Copied { copy: copy.clone(), original, stands_in, placement })));
        }
        Ok(parts)
    }

    fn original(&self, copy: &PatchCopy, solving: &Solving, points: Option<&str>) -> Result<Part, Failure> {
        let patches = self.problem.patches.len();
        if let Some(patch) = self.problem.patches.get(copy.original) {
            return Ok(Part::Patch(Arc::new(self.prepare(patch, solving, points)?)));
        }
        let net = copy.original.checked_sub(patches).and_then(|index| self.problem.nets.get(index));
        let net = net.ok_or_else(|| Failure::Machine("a copy without an original".to_owned()))?;
        Ok(Part::Net(Arc::new(self.prepare_net(net, solving, points)?)))
    }

    /// Compiles a net, which has no settings.
    pub fn prepare_net(&self, net: &Net, solving: &Solving, points: Option<&str>) -> Result<NetSolver, Failure> {
        let method = solving.method.clone();
        let options = Options {
            method,
            backend: Backend::Auto,
            limits: self.limits.clone(),
            settings: solving.settings(points)?,
            ..Options::default()
        };
        prepare_net(&self.problem, net, &self.bindings, &options).map_err(|finding| match finding.span {
            None => solving.fault(points, finding),
            Some(_) => self.fault(finding),
        })
    }

    /// A part at `time`, solved and judged, or filled.
    pub fn shape(&self, part: &Part, time: f64) -> Result<Shape, Failure> {
        match part {
            Part::Patch(patched) => {
                let solution = self.solve(patched, time)?.solution;
                Ok(Shape { surface: solution.surface, warnings: solution.report.warnings, net: None, bspline: None })
            }
            Part::Net(solver) => {
                let net = solver.solve(&self.bindings, time).map_err(|finding| self.fault(finding))?;
                let warnings = net.filled.warnings.clone();
                let bspline = Some(net.filled.surface.clone());
                Ok(Shape { surface: net.surface.clone(), warnings, net: Some(net), bspline })
            }
            Part::Copy(copied) => {
                let base = self.shape(&copied.original, time)?;
                let (placement, params) = (&copied.placement, self.bindings.as_slice());
                let bspline = base.bspline.map(|bspline| placement.place_bspline(&bspline, params, time)).transpose();
                let bspline = bspline.map_err(|finding| self.fault(finding))?;
                let placed = PlacedSurface::new(base.surface, Arc::clone(placement), params);
                let domain = part.domain();
                placed.check_distance([domain.u, domain.v], time).map_err(|finding| self.fault(finding))?;
                let warnings = if copied.stands_in { base.warnings } else { Diagnostics::new() };
                Ok(Shape { surface: Arc::new(placed), warnings, net: None, bspline })
            }
        }
    }

    /// Refuses a document with copies, or a copy that is asked for, where `command` takes what is solved only.
    pub fn without_copies(&self, command: &str) -> Result<(), Failure> {
        let Some(copy) = self.copies.first() else { return Ok(()) };
        let original = self.problem.part_name(copy.original).unwrap_or_default();
        let message = format!("`{command}` takes what is solved, and `{}` is a copy of `{original}`", copy.name);
        let finding = Diagnostic::new(Code::UnsupportedByMethod, message).at(copy.origin);
        Err(self.fault(finding.hint(format!("choose the original: --patch {original}"))))
    }

    /// Refuses a document with nets, of which `command` can make nothing.
    pub fn without_nets(&self, command: &str) -> Result<(), Failure> {
        let Some(net) = self.nets.first() else { return Ok(()) };
        let message = format!("`{command}` is for patches, and `{}` is a B-spline net", net.name);
        let finding = Diagnostic::new(Code::UnsupportedByMethod, message).at(net.origin);
        let advice = "`check`, `solve`, `eval`, `mesh`, `render`, `view`, `fit` and `emit` take nets; choose a patch with --patch";
        Err(self.fault(finding.hint(advice)))
    }
}
