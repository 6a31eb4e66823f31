//! From text to a first value: what a user waits for before the first point.

use std::hint::black_box;

use trimline::diagnostic::Diagnostic;
use trimline::eval::{Backend, compile};
use trimline::expr::Derivative;

use crate::failure::Failure;
use crate::workflow::Spec;

use super::clock::Clock;
use super::{Row, Subject};

pub fn measure(subject: &Subject<'_>, clock: &Clock) -> Result<Vec<Row>, Failure> {
    let &Subject { arguments, spec, patched, solved, .. } = subject;
    let (solving, points) = (&arguments.solving, arguments.collocation.points.as_deref());
    let compiled = || {
        let spec = Spec::of(spec.source.clone(), &solving.reading)?;
        let patched = match spec.patches.first() {
            Some(patch) => spec.prepare(patch, solving, points)?,
            None => return Err(Failure::Usage("the spec has no patch".to_owned())),
        };
        Ok((spec, patched))
    };
    let domain = patched.prepared.domain;
    let middle = [domain.u, domain.v].map(|[from, to]| 0.5 * (from + to));
    let first_value = || {
        let (spec, patched) = compiled()?;
        let solved = spec.solve(&patched, solved.time)?;
        let mut point = [[0.0; 3]];
        let surface = &solved.solution.surface;
        let evaluated = surface.evaluate(Derivative::NONE, &[[middle[0], middle[1], solved.time]], &mut point);
        black_box(point);
        evaluated.map_err(|finding| spec.fault(finding))
    };
    let fault = |finding: Diagnostic| spec.fault(finding);
    let (prepared, bindings, time) = (&patched.prepared, &spec.bindings, solved.time);
    let solve = || prepared.solve(bindings, time).map(|solution| drop(black_box(solution)));
    let verify =
        || prepared.verify(&spec.problem, bindings, &solved.solution, time).map(|measured| drop(black_box(measured)));
    let mut rows = vec![
        Row::new(
            "compile_ms",
            "text to a problem ready to be solved",
            "ms",
            1e3 * clock.fastest(|| compiled().map(drop))?,
        ),
        Row::new("solve_us", "solution", "µs", 1e6 * clock.fastest(solve).map_err(fault)?),
        Row::new("verify_us", "measurement of the solution", "µs", 1e6 * clock.fastest(verify).map_err(fault)?),
        Row::new("first_value_ms", "text to a first value, measured", "ms", 1e3 * clock.fastest(first_value)?),
    ];
    rows.push(match code_generation(subject, clock) {
        Some(seconds) => Row::new("code_generation_ms", "machine code of basis and derivatives", "ms", 1e3 * seconds),
        None => Row::none("code_generation_ms", "machine code of basis and derivatives", "ms"),
    });
    Ok(rows)
}

/// Seconds to make machine code of the basis with the derivatives of the equation; `None` where there is neither.
fn code_generation(subject: &Subject<'_>, clock: &Clock) -> Option<f64> {
    let basis = &subject.solved.solution.surface.as_separable()?.basis;
    let program = basis.program(&subject.derivatives()).ok()?;
    let generate = || match compile(program.clone(), Backend::Jit) {
        (evaluator, None) => {
            drop(black_box(evaluator));
            Ok(())
        }
        (_, Some(note)) => Err(note),
    };
    clock.fastest(generate).ok()
}
