//! What `check` and `solve` say of B-spline nets.

use std::fmt::Write;
use std::time::Instant;

use serde::Serialize;

use trimline::diagnostic::Shortest;
use trimline::net::METHOD;
use trimline::surface::KnotVector;

use crate::check::instants_text;
use crate::failure::{Failure, Said, print_warnings};
use crate::finding::Findings;
use crate::options::Terminal;
use crate::output::rounded;
use crate::parts::{Located, Part};
use crate::solve::{Warning, columns};
use crate::workflow::Spec;

/// A net as `check` reports it. Its equation has no residual worth a word, and its layers are met by construction.
#[derive(Serialize)]
pub struct NetReport {
    name: String,
    method: &'static str,
    control_points: [usize; 2],
    /// The largest Σ_a |L_a(i)| in u and in v.
    amplification: [f64; 2],
    times: Vec<f64>,
}

/// Fills the net at all `times`.
pub fn report(spec: &Spec, part: &Part, times: Vec<f64>, findings: &mut Findings<'_>) -> Result<NetReport, Failure> {
    let mut said = Said::default();
    let (mut control_points, mut amplification) = ([0; 2], [0.0; 2]);
    for &time in &times {
        let shape = spec.shape(part, time)?;
        findings.warn(&said.news(shape.warnings), &spec.source);
        if let Some(net) = shape.net {
            control_points = net.filled.surface.knots().map(KnotVector::points);
            amplification = net.filled.amplification;
        }
    }
    Ok(NetReport { name: part.name().to_owned(), method: METHOD, control_points, amplification, times })
}

/// Writing to a string does not fail.
pub fn write_report(text: &mut String, net: &NetReport) {
    let [rows, columns] = net.control_points;
    let when = instants_text(&net.times);
    let _ = writeln!(text, "net {}: method {}, {rows} x {columns} points, {when}", net.name, net.method);
    write_amplification(text, net.amplification);
}

fn write_amplification(text: &mut String, [in_u, in_v]: [f64; 2]) {
    let (in_u, in_v) = (rounded(in_u), rounded(in_v));
    let _ = writeln!(text, "  {:20} {in_u} in u, {in_v} in v: what a change of a layer may grow to", "amplification");
}

/// A net as `solve` prints it.
#[derive(Serialize)]
pub struct NetSolution {
    name: String,
    method: &'static str,
    time: f64,
    degree: [usize; 2],
    knots_u: Vec<f64>,
    knots_v: Vec<f64>,
    /// Rows of equal i.
    control_net: Vec<Vec<[f64; 3]>>,
    amplification: [f64; 2],
    warnings: Vec<Warning>,
    seconds: NetSeconds,
}

#[derive(Serialize)]
struct NetSeconds {
    parse: f64,
    solve: f64,
}

/// Fills the net at `time`.
pub fn solution(spec: &Spec, part: &Part, time: f64, terminal: &Terminal) -> Result<NetSolution, Failure> {
    let start = Instant::now();
    let shape = spec.shape(part, time)?;
    let solve = start.elapsed().as_secs_f64();
    let net = shape.net.ok_or_else(|| Failure::Machine(format!("`{}` is no net", part.name())))?;
    print_warnings(&shape.warnings, &spec.source, terminal);
    let [u, v] = net.filled.surface.knots();
    let warnings = shape.warnings.iter();
    Ok(NetSolution {
        name: part.name().to_owned(),
        method: METHOD,
        time,
        degree: [u.degree(), v.degree()],
        knots_u: u.as_slice().to_vec(),
        knots_v: v.as_slice().to_vec(),
        control_net: net.filled.surface.net().chunks(v.points()).map(<[_]>::to_vec).collect(),
        amplification: net.filled.amplification,
        warnings: warnings.map(|w| Warning { code: w.code.as_str(), message: w.message.clone() }).collect(),
        seconds: NetSeconds { parse: spec.parse_seconds, solve },
    })
}

/// Writing to a string does not fail.
pub fn write_solution(text: &mut String, net: &NetSolution) {
    let (rows, per_row) = (net.control_net.len(), net.control_net.first().map_or(0, Vec::len));
    let _ = writeln!(
        text,
        "net {}: method {}, {rows} x {per_row} points, at t = {}",
        net.name,
        net.method,
        Shortest(net.time)
    );
    write_amplification(text, net.amplification);
    for (name, knots) in [("u", &net.knots_u), ("v", &net.knots_v)] {
        let knots: Vec<String> = knots.iter().map(f64::to_string).collect();
        let _ = writeln!(text, "  {:20} {}", format!("knots of {name}"), knots.join(", "));
    }
    for (i, row) in net.control_net.iter().enumerate() {
        for (j, point) in row.iter().enumerate() {
            let _ = writeln!(text, "  {:10} {}", format!("P({i}, {j})"), columns(point));
        }
    }
}
