//! The parts of a document as commands see them: patches and B-spline nets, each a surface at every instant.

use std::sync::Arc;

use trimline::blend::prepare_net;
use trimline::diagnostic::{Code, Diagnostic, Diagnostics};
use trimline::eval::Backend;
use trimline::method::Options;
use trimline::net::{NetSolver, SolvedNet};
use trimline::problem::{DomainValues, Net};
use trimline::surface::Surface;

use crate::failure::Failure;
use crate::options::{Solving, option_finding};
use crate::workflow::{Patched, Spec};

/// What has a name and a domain.
pub trait Located {
    fn name(&self) -> &str;

    fn domain(&self) -> &DomainValues;

    /// The instant the user asked for, which must lie in the time domain, or the domain's start.
    fn instant(&self, time: Option<f64>) -> Result<f64, Failure> {
        let [start, end] = self.domain().t;
        match time {
            None => Ok(start),
            Some(time) if (start..=end).contains(&time) => Ok(time),
            Some(time) => {
                let message = format!("t = {time} lies outside the time domain [{start}, {end}]");
                let finding = Diagnostic::new(Code::PointOutsideDomain, message)
                    .hint("choose an instant inside, or widen `domain t in [..]` in the spec");
                Err(option_finding("time", &time.to_string(), finding))
            }
        }
    }
}

impl Located for Patched {
    fn name(&self) -> &str {
        &self.prepared.patch().name
    }

    fn domain(&self) -> &DomainValues {
        &self.prepared.domain
    }
}

/// A part that is ready at any instant.
pub enum Part {
    Patch(Box<Patched>),
    Net(Box<NetSolver>),
}

impl Located for Part {
    fn name(&self) -> &str {
        match self {
            Part::Patch(patch) => patch.name(),
            Part::Net(net) => &net.net.name,
        }
    }

    fn domain(&self) -> &DomainValues {
        match self {
            Part::Patch(patch) => patch.domain(),
            Part::Net(net) => &net.domain,
        }
    }
}

/// A part at one instant.
pub struct Shape {
    pub surface: Arc<dyn Surface + Send + Sync>,
    pub warnings: Diagnostics,
    /// The net behind it, if it is one.
    pub net: Option<SolvedNet>,
}

impl Spec {
    /// Everything the user asked for, compiled: patches, then nets.
    pub fn parts(&self, solving: &Solving, points: Option<&str>) -> Result<Vec<Part>, Failure> {
        let mut parts = Vec::with_capacity(self.patches.len() + self.nets.len());
        for patch in &self.patches {
            parts.push(Part::Patch(Box::new(self.prepare(patch, solving, points)?)));
        }
        for net in &self.nets {
            parts.push(Part::Net(Box::new(self.prepare_net(net, solving, points)?)));
        }
        Ok(parts)
    }

    /// Compiles a net, which has no settings.
    pub fn prepare_net(&self, net: &Net, solving: &Solving, points: Option<&str>) -> Result<NetSolver, Failure> {
        let method = solving.method.clone();
        let options = Options {
            method,
            backend: Backend::Auto,
            limits: self.limits.clone(),
            settings: solving.settings(points)?,
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
                Ok(Shape { surface: solution.surface, warnings: solution.report.warnings, net: None })
            }
            Part::Net(solver) => {
                let net = solver.solve(&self.bindings, time).map_err(|finding| self.fault(finding))?;
                let warnings = net.filled.warnings.clone();
                Ok(Shape { surface: net.surface.clone(), warnings, net: Some(net) })
            }
        }
    }

    /// Refuses a document with nets, of which `command` can make nothing.
    pub fn without_nets(&self, command: &str) -> Result<(), Failure> {
        let Some(net) = self.nets.first() else { return Ok(()) };
        let message = format!("`{command}` is for patches, and `{}` is a B-spline net", net.name);
        let finding = Diagnostic::new(Code::UnsupportedByMethod, message).at(net.origin);
        let advice = "`check`, `solve`, `eval`, `mesh`, `render` and `fit` take nets; choose a patch with --patch";
        Err(self.fault(finding.hint(advice)))
    }
}
