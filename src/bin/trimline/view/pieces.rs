//! What the page shows: patches, B-spline nets and copies of both, compiled once and solved for the page's values.

use std::sync::Arc;

use trimline::net::{NetSolver, SolvedNet};
use trimline::problem::{DomainValues, PatchCopy};
use trimline::surface::{CompiledPlacement, PlacedSurface, Surface};

use crate::failure::Failure;
use crate::options::Solving;
use crate::parts::{Located, Part};
use crate::workflow::{Patched, Solved, Spec};

/// The parts of a spec, ready to be solved for any values.
pub struct Compiled {
    originals: Vec<Original>,
    members: Vec<Member>,
}

/// What is solved.
enum Original {
    Patch(Box<Patched>),
    Net(Box<NetSolver>),
}

/// What is shown: an original, or a copy of one that need not be shown itself.
struct Member {
    original: usize,
    copy: Option<PlacedCopy>,
}

/// Where a copy is.
struct PlacedCopy {
    copy: PatchCopy,
    placement: Arc<CompiledPlacement>,
}

/// The originals, solved at one instant.
pub struct Solutions(Vec<Solution>);

enum Solution {
    Patch(Box<Solved>),
    Net(Box<SolvedNet>),
}

/// One part, solved.
pub struct Piece<'a> {
    /// What was solved for it.
    pub of: Of<'a>,
    /// The place of that among everything that was solved: copies share it with their originals.
    pub original: usize,
    /// Where it is, for a copy.
    pub copy: Option<&'a PatchCopy>,
    /// Itself; what was solved is its base.
    pub surface: Arc<dyn Surface + Send + Sync>,
    /// Whether its outside is on the other side of its base.
    pub is_reflection: bool,
}

/// A patch or net with its solution.
#[derive(Clone, Copy)]
pub enum Of<'a> {
    Patch(&'a Patched, &'a Solved),
    Net(&'a NetSolver, &'a SolvedNet),
}

impl Compiled {
    /// Compiles what the user asked for.
    pub fn new(spec: &Spec, solving: &Solving, points: Option<&str>) -> Result<Compiled, Failure> {
        let mut originals: Vec<Part> = Vec::new();
        let mut members = Vec::new();
        for part in spec.parts(solving, points)? {
            let Part::Copy(copied) = part else {
                members.push(Member { original: originals.len(), copy: None });
                originals.push(part);
                continue;
            };
            let known = originals.iter().position(|part| part.name() == copied.original.name());
            let original = known.unwrap_or_else(|| {
                originals.push(copied.original.clone());
                originals.len() - 1
            });
            let copy = PlacedCopy { copy: copied.copy.clone(), placement: Arc::clone(&copied.placement) };
            members.push(Member { original, copy: Some(copy) });
        }
        // Copies are gone, and nobody else holds what they were made of.
        let own = |part| match part {
            Part::Patch(patch) => Arc::into_inner(patch).map(|patch| Original::Patch(Box::new(patch))),
            Part::Net(net) => Arc::into_inner(net).map(|net| Original::Net(Box::new(net))),
            Part::Copy(_) => None,
        };
        let originals: Option<Vec<Original>> = originals.into_iter().map(own).collect();
        let originals = originals.ok_or_else(|| Failure::Machine("a part that is held elsewhere".to_owned()))?;
        Ok(Compiled { originals, members })
    }

    /// Takes the values of `spec`.
    pub fn refresh(&mut self, spec: &Spec) -> Result<(), Failure> {
        for original in &mut self.originals {
            let refreshed = match original {
                Original::Patch(patched) => patched.prepared.refresh(&spec.problem, &spec.bindings),
                Original::Net(solver) => solver.domain_for(&spec.bindings).map(|domain| solver.domain = domain),
            };
            refreshed.map_err(|finding| spec.fault(finding))?;
        }
        Ok(())
    }

    /// The instants that everything has.
    pub fn times(&self, spec: &Spec) -> Result<[f64; 2], Failure> {
        spec.times(&self.originals)
    }

    /// Solves everything at `time`.
    pub fn solve(&self, spec: &Spec, time: f64) -> Result<Solutions, Failure> {
        let solve = |original: &Original| match original {
            Original::Patch(patched) => spec.solve(patched, time).map(|solved| Solution::Patch(Box::new(solved))),
            Original::Net(solver) => {
                let solved = solver.solve(&spec.bindings, time).map_err(|finding| spec.fault(finding))?;
                Ok(Solution::Net(Box::new(solved)))
            }
        };
        self.originals.iter().map(solve).collect::<Result<_, _>>().map(Solutions)
    }

    /// The parts with what was solved for them at `time`.
    pub fn pieces<'a>(&'a self, spec: &Spec, solutions: &'a Solutions, time: f64) -> Result<Vec<Piece<'a>>, Failure> {
        let mut pieces = Vec::with_capacity(self.members.len());
        for Member { original, copy } in &self.members {
            let of = match (self.originals.get(*original), solutions.0.get(*original)) {
                (Some(Original::Patch(patched)), Some(Solution::Patch(solved))) => Of::Patch(patched, solved),
                (Some(Original::Net(solver)), Some(Solution::Net(solved))) => Of::Net(solver, solved),
                _ => return Err(Failure::Machine("a part that was not solved".to_owned())),
            };
            let (mut surface, mut is_reflection) = (of.surface(), false);
            if let Some(PlacedCopy { placement, .. }) = copy {
                let params = spec.bindings.as_slice();
                is_reflection = placement.is_reflection(params, time).map_err(|finding| spec.fault(finding))?;
                surface = Arc::new(PlacedSurface::new(surface, Arc::clone(placement), params));
            }
            let copy = copy.as_ref().map(|copy| &copy.copy);
            pieces.push(Piece { of, original: *original, copy, surface, is_reflection });
        }
        Ok(pieces)
    }
}

impl Located for Original {
    fn name(&self) -> &str {
        match self {
            Original::Patch(patched) => patched.name(),
            Original::Net(solver) => &solver.net.name,
        }
    }

    fn domain(&self) -> &DomainValues {
        match self {
            Original::Patch(patched) => patched.domain(),
            Original::Net(solver) => &solver.domain,
        }
    }

    fn is_four_sided(&self) -> bool {
        match self {
            Original::Patch(patched) => patched.is_four_sided(),
            Original::Net(_) => true,
        }
    }
}

impl Of<'_> {
    /// What was solved.
    pub fn surface(&self) -> Arc<dyn Surface + Send + Sync> {
        match self {
            Of::Patch(_, solved) => Arc::clone(&solved.solution.surface),
            Of::Net(_, solved) => solved.surface.clone(),
        }
    }

    /// What it is called.
    pub fn name(&self) -> &str {
        match self {
            Of::Patch(patched, _) => patched.name(),
            Of::Net(solver, _) => &solver.net.name,
        }
    }

    /// Its largest extent, or coordinate.
    pub fn size(&self) -> f64 {
        match self {
            Of::Patch(_, solved) => solved.measured.size,
            Of::Net(_, solved) => solved.filled.surface.size(),
        }
    }
}

impl Located for Piece<'_> {
    fn name(&self) -> &str {
        self.copy.map_or_else(|| self.of.name(), |copy| &copy.name)
    }

    fn domain(&self) -> &DomainValues {
        match self.of {
            Of::Patch(patched, _) => patched.domain(),
            Of::Net(solver, _) => &solver.domain,
        }
    }

    fn is_four_sided(&self) -> bool {
        match self.of {
            Of::Patch(patched, _) => patched.is_four_sided(),
            Of::Net(..) => true,
        }
    }
}
