//! `trimline solve`: the solution's coefficients and its report.

use std::fmt::Write;

use clap::Args;
use serde::Serialize;
use trimline::diagnostic::Shortest;
use trimline::method::Report;
use trimline::surface::SeparableSurface;

use crate::Outcome;
use crate::failure::{print_warnings, say};
use crate::nets::{self, NetSolution};
use crate::options::{Collocation, Format, Solving, Terminal};
use crate::output::{self, rounded};
use crate::parts::{Located, Part};
use crate::workflow::{Patched, Solved, Spec};

#[derive(Args)]
pub struct Arguments {
    /// The spec file, or `-`.
    spec: String,

    #[command(flatten)]
    solving: Solving,

    #[command(flatten)]
    collocation: Collocation,

    /// How to print.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Serialize)]
struct Patches {
    patches: Vec<PatchSolution>,
    nets: Vec<NetSolution>,
}

#[derive(Serialize)]
struct PatchSolution {
    name: String,
    method: &'static str,
    exact: bool,
    time: f64,
    basis_size: usize,
    closure_size: Option<usize>,
    modes: usize,
    boundary_error: f64,
    pde_residual: f64,
    amplification: Option<f64>,
    condition: Option<f64>,
    truncation: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    force_truncation: Option<f64>,
    rank: usize,
    unknowns: usize,
    warnings: Vec<Warning>,
    coefficients: Vec<FunctionCoefficients>,
    seconds: Seconds,
}

#[derive(Serialize)]
pub struct Warning {
    pub code: &'static str,
    pub message: String,
}

/// What stands in front of one basis function: a vector per boundary condition, then one per term.
#[derive(Serialize)]
struct FunctionCoefficients {
    basis: String,
    boundary: Vec<[f64; 3]>,
    terms: Vec<[f64; 3]>,
}

#[derive(Serialize)]
struct Seconds {
    parse: f64,
    decompose: f64,
    compile: f64,
    solve: f64,
}

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    let spec = Spec::read(&arguments.spec, &arguments.solving.reading)?;
    let mut patches = Vec::new();
    let mut text = String::new();
    for patch in &spec.patches {
        let patched = spec.prepare(patch, &arguments.solving, arguments.collocation.points.as_deref())?;
        let time = patched.instant(arguments.solving.time)?;
        let solved = spec.solve(&patched, time)?;
        print_warnings(&solved.solution.report.warnings, &spec.source, terminal);
        let solution = patch_solution(&patched, &solved, spec.parse_seconds);
        if arguments.format == Format::Text {
            write_text(&mut text, &solution, &patched);
            if !terminal.quiet {
                let s = &solution.seconds;
                let all = [s.parse, s.decompose, s.compile, s.solve].map(|seconds| 1e3 * seconds);
                let [parse, decompose, compile, solve] = all;
                say(&format!(
                    "parse {parse:.2} ms, decompose {decompose:.2} ms, compile {compile:.2} ms, solve {solve:.2} ms"
                ));
            }
        }
        patches.push(solution);
    }
    let points = arguments.collocation.points.as_deref();
    let mut nets = Vec::new();
    for net in &spec.nets {
        let solver = spec.prepare_net(net, &arguments.solving, points)?;
        let part = Part::Net(std::sync::Arc::new(solver));
        let time = part.instant(arguments.solving.time)?;
        let solution = nets::solution(&spec, &part, time, terminal)?;
        if arguments.format == Format::Text {
            nets::write_solution(&mut text, &solution);
        }
        nets.push(solution);
    }
    match arguments.format {
        Format::Text => output::print(&text),
        Format::Json => output::print_json(&Patches { patches, nets }),
    }
}

fn patch_solution(patched: &Patched, solved: &Solved, parse_seconds: f64) -> PatchSolution {
    let (report, measured) = (&solved.solution.report, &solved.measured);
    let conditions = patched.prepared.patch().conditions.len();
    let surface = solved.solution.surface.as_separable();
    let warnings = report.warnings.iter();
    PatchSolution {
        name: patched.prepared.patch().name.clone(),
        method: report.method,
        exact: report.is_exact,
        time: solved.time,
        basis_size: report.basis_size,
        closure_size: report.closure_size,
        modes: report.modes,
        boundary_error: measured.boundary_error(),
        pde_residual: measured.relative_residual(),
        amplification: report.amplification,
        truncation: report.truncation.as_ref().map(|truncation| truncation.left_out),
        force_truncation: report.truncation.as_ref().and_then(|truncation| truncation.of_force),
        condition: report.condition.filter(|condition| condition.is_finite()),
        rank: report.rank,
        unknowns: report.unknowns,
        warnings: warnings.map(|w| Warning { code: w.code.as_str(), message: w.message.clone() }).collect(),
        coefficients: surface.map(|surface| function_coefficients(surface, conditions, report)).unwrap_or_default(),
        seconds: Seconds {
            parse: parse_seconds,
            decompose: patched.decompose_seconds,
            compile: patched.compile_seconds,
            solve: solved.solve_seconds,
        },
    }
}

/// What stands in front of every basis function of a surface with `conditions` boundary conditions.
fn function_coefficients(surface: &SeparableSurface, conditions: usize, report: &Report) -> Vec<FunctionCoefficients> {
    let count = surface.basis.len();
    let all = surface.coefficients.first().map_or(&[][..], Vec::as_slice);
    let of_function = |(j, name): (usize, &String)| {
        let vectors: Vec<[f64; 3]> = all.iter().skip(j).step_by(count.max(1)).copied().collect();
        // A series without a closure has for each wave number functions of u of its own, as many as there are conditions.
        let (boundary, terms) = match report.truncation.is_some() && report.closure_size.is_none() {
            false => vectors.split_at_checked(conditions).unwrap_or_default(),
            true => {
                let mut each = vectors.chunks(conditions.max(1));
                (each.find(|own| own.iter().any(|vector| *vector != [0.0; 3])).unwrap_or_default(), &[][..])
            }
        };
        FunctionCoefficients { basis: name.clone(), boundary: boundary.to_vec(), terms: terms.to_vec() }
    };
    surface.basis.names().iter().enumerate().map(of_function).collect()
}

/// Writing to a string does not fail.
fn write_text(text: &mut String, solution: &PatchSolution, patched: &Patched) {
    let when = if solution.exact { "for every t".to_owned() } else { format!("at t = {}", Shortest(solution.time)) };
    let functions = match solution.closure_size {
        Some(closure) => format!("{} basis functions, {closure} with their closure", solution.basis_size),
        None => format!("{} basis functions", solution.basis_size),
    };
    let (name, method) = (&solution.name, solution.method);
    let size = match solution.truncation {
        Some(_) => format!("{} wave numbers", solution.modes),
        None => format!("{functions}, {} terms each", solution.modes),
    };
    let _ = writeln!(text, "patch {name}: method {method}, {size}, {when}");
    let _ = writeln!(text, "boundary error  {}", rounded(solution.boundary_error));
    let _ = writeln!(text, "PDE residual    {} of the largest term", rounded(solution.pde_residual));
    if let Some(truncation) = solution.truncation {
        let _ = writeln!(text, "series          leaves out {}", rounded(truncation));
    }
    if let Some(share) = solution.force_truncation {
        let _ = writeln!(text, "force's series  leaves out {} of it", rounded(share));
    }
    if let Some(amplification) = solution.amplification {
        let _ = writeln!(text, "amplification   {}", rounded(amplification));
    } else if solution.truncation.is_none() {
        let condition = solution.condition;
        let condition = condition.map_or_else(|| "unbounded".to_owned(), rounded);
        let _ = writeln!(text, "rank            {} of {}, condition {condition}", solution.rank, solution.unknowns);
    }
    for (index, function) in solution.coefficients.iter().enumerate() {
        let _ = writeln!(text, "\nF{} = {}", index + 1, function.basis);
        for (condition, vector) in function.boundary.iter().enumerate() {
            let symbol = patched.prepared.decomposition.symbol(condition);
            // A bar above a letter is a character without width.
            let width = 4 + symbol.chars().filter(|c| ('\u{300}'..='\u{36f}').contains(c)).count();
            let _ = writeln!(text, "  {symbol:width$} {}", columns(vector));
        }
        for (term, vector) in function.terms.iter().enumerate() {
            let _ = writeln!(text, "  P{:<3} {}", term + 1, columns(vector));
        }
    }
}

/// x, y and z in columns of one width, points below points; JSON has all digits.
pub fn columns(vector: &[f64; 3]) -> String {
    vector.map(number).concat().trim_end().to_owned()
}

/// Six decimals, in 15 places, with a power of ten where few digits would be left. Only what is exactly zero reads `0`.
fn number(value: f64) -> String {
    match value.abs() {
        0.0 => format!("{:>7}{:8}", 0, ""),
        1e-3..1e5 => format!("{value:>14.6} "),
        _ => format!("{value:>15.6e}"),
    }
}
