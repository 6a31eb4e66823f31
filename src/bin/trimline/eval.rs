//! `trimline eval`: the surface and its derivatives at given points, CSV in and CSV out.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Cursor, Read};
use std::path::Path;

use clap::Args;

use trimline::diagnostic::{Code, Diagnostic, Shortest};
use trimline::expr::Derivative;
use trimline::method::Size;
use trimline::problem::COMPONENTS;

use crate::Outcome;
use crate::failure::{Failure, Said, print_warnings};
use crate::files;
use crate::options::{Solving, Terminal};
use crate::output;
use crate::parts::{Located, Part};
use crate::workflow::Spec;

#[derive(Args)]
pub struct Arguments {
    /// The spec file, or `-`.
    spec: String,

    #[command(flatten)]
    solving: Solving,

    /// A CSV file with a header that names u, v and, if needed, t and patch, or `-`; a value such as `11x11:ends` sets the
    /// collocation grid instead (write `./11x11` for a file of that name).
    #[arg(long, required = true, value_name = "FILE|LxM[:KIND]")]
    points: Vec<String>,

    /// Derivatives to add, for example `u,v,uu`.
    #[arg(long, value_delimiter = ',', value_name = "LIST")]
    derivatives: Vec<String>,

    /// The shape between, at this weight of the target, of a spec that states `morph from A to B`.
    #[arg(long, value_name = "EPS")]
    morph: Option<f64>,

    /// The result, instead of standard output.
    #[arg(long, short, value_name = "FILE")]
    output: Option<std::path::PathBuf>,
}

/// The input: its header, its rows, and patch and point of each row.
pub struct Table {
    /// Between the cells, as in the input.
    separator: u8,
    header: csv::StringRecord,
    rows: Vec<csv::StringRecord>,
    pub patches: Vec<usize>,
    pub points: Vec<[f64; 3]>,
}

pub fn run(arguments: &Arguments, terminal: &Terminal) -> Outcome {
    let (file, grid) = split_points(&arguments.points)?;
    if arguments.spec == "-" && file == "-" {
        return Err(Failure::Usage("the spec and the points cannot both come from standard input".to_owned()));
    }
    if let Some(epsilon) = arguments.morph {
        if grid.is_some() {
            return Err(Failure::Usage("a shape of a morph takes no collocation grid".to_owned()));
        }
        let derivatives =
            read_derivatives(&arguments.derivatives, arguments.solving.reading.limits()?.derivative_order)?;
        let (spec, output) = (&arguments.spec, arguments.output.as_deref());
        return crate::morph::evaluate(spec, &arguments.solving, epsilon, (file, &derivatives), output, terminal);
    }
    let spec = Spec::read(&arguments.spec, &arguments.solving.reading)?;
    let derivatives = read_derivatives(&arguments.derivatives, spec.limits.derivative_order)?;
    let parts = spec.parts(&arguments.solving, grid)?;
    let table = read_table(file, arguments.solving.time, &parts, spec.limits.samples)?;
    let values = evaluate(&spec, &parts, &table, &derivatives, terminal)?;
    print_table(&table, &derivatives, &values, arguments.output.as_deref())
}

/// Writes the table to `path`, or prints it.
pub fn print_table(
    table: &Table,
    derivatives: &[Derivative],
    values: &[Vec<[f64; 3]>],
    path: Option<&std::path::Path>,
) -> Outcome {
    let text = write_table(table, derivatives, values)?;
    let Some(path) = path else { return output::print(&text) };
    let mut files = output::Files::default();
    let file = files.create(path)?;
    std::io::Write::write_all(file, text.as_bytes())
        .map_err(|error| Failure::Machine(format!("cannot write `{}`: {error}", path.display())))?;
    files.keep()
}

/// The file of points and the collocation grid, told apart by their form.
fn split_points(values: &[String]) -> Result<(&str, Option<&str>), Failure> {
    let is_grid =
        |value: &&String| "0123456789".contains(value.chars().next().unwrap_or('/')) && Size::read(value).is_ok();
    let grids: Vec<&String> = values.iter().filter(is_grid).collect();
    let files: Vec<&String> = values.iter().filter(|value| !is_grid(value)).collect();
    match (files.as_slice(), grids.as_slice()) {
        ([file], []) => Ok((file, None)),
        ([file], [grid]) => Ok((file, Some(grid))),
        ([], _) => Err(Failure::Usage("name the file of points: --points FILE.csv, or --points -".to_owned())),
        _ => Err(Failure::Usage("--points takes one file and at most one collocation grid".to_owned())),
    }
}

/// The derivatives that are named, for example `uuv`.
pub fn read_derivatives(names: &[String], highest: usize) -> Result<Vec<Derivative>, Failure> {
    let read = |name: &String| match Derivative::parse(name.trim()) {
        Some(derivative) if derivative != Derivative::NONE && derivative.largest() <= highest => Ok(derivative),
        Some(derivative) if derivative.largest() > highest => {
            let message = format!(
                "a derivative of order {} is above the limit `derivative-order` of {highest}",
                derivative.largest()
            );
            Err(Failure::Found { source: None, findings: vec![Diagnostic::new(Code::LimitReached, message)] })
        }
        _ => Err(Failure::Usage(format!("`{name}` is not a derivative: write letters u, v and t, for example uuv"))),
    };
    let derivatives: Vec<Derivative> = names.iter().map(read).collect::<Result<_, Failure>>()?;
    for (index, derivative) in derivatives.iter().enumerate() {
        if derivatives.iter().take(index).any(|earlier| earlier == derivative) {
            return Err(Failure::Usage(format!("the derivative `{derivative}` is asked for twice")));
        }
    }
    Ok(derivatives)
}

/// Points of a CSV file, all inside the domains of their patches.
pub fn read_table<P: Located>(file: &str, time: Option<f64>, parts: &[P], allowed: usize) -> Result<Table, Failure> {
    let shown = if file == "-" { "standard input" } else { file };
    let unreadable = |error: &dyn std::fmt::Display| Failure::Usage(format!("cannot read `{shown}`: {error}"));
    let input: Box<dyn Read> = if file == "-" {
        Box::new(std::io::stdin().lock())
    } else {
        Box::new(files::open(Path::new(file)).map_err(|error| unreadable(&error))?)
    };
    let (separator, input) = with_separator(input).map_err(|error| unreadable(&error))?;
    let mut building = csv::ReaderBuilder::new();
    let mut reader = building.delimiter(separator).comment(Some(b'#')).trim(csv::Trim::All).from_reader(input);
    let bad = |message: String| Failure::Found {
        source: None,
        findings: vec![Diagnostic::new(Code::BadPoints, format!("{shown}: {message}"))],
    };
    let header = reader.headers().map_err(|error| bad(error.to_string()))?.clone();
    let column = |name: &str| -> Result<Option<usize>, Failure> {
        let mut found = header.iter().enumerate().filter(|(_, column)| *column == name).map(|(index, _)| index);
        match (found.next(), found.next()) {
            (first, None) => Ok(first),
            _ => Err(bad(format!("the column `{name}` occurs twice"))),
        }
    };
    if let Some(name) = header.iter().find(|name| COMPONENTS.contains(name)) {
        return Err(bad(format!("a column is called `{name}`, as one of the result's is: give it another name")));
    }
    let required = |name: &str| column(name)?.ok_or_else(|| bad(format!("the header names no column `{name}`")));
    let columns = [Some(required("u")?), Some(required("v")?), column("t")?];
    let names: Vec<&str> = parts.iter().map(Located::name).collect();
    let patch_column = column("patch")?;
    if names.len() != 1 && patch_column.is_none() {
        let message = format!("the spec has the patches {}", names.join(", "));
        return Err(Failure::Usage(format!("{message}: choose one with --patch, or give the points a column `patch`")));
    }
    let times = parts.iter().map(|part| part.instant(time)).collect::<Result<Vec<f64>, _>>()?;
    let (mut rows, mut patches, mut points) = (Vec::new(), Vec::new(), Vec::new());
    for record in reader.records() {
        let record = record.map_err(|error| bad(error.to_string()))?;
        let line = record.position().map_or(0, csv::Position::line);
        if rows.len() >= allowed {
            let message = format!("more points than the limit `samples` of {allowed}");
            return Err(Failure::Found { source: None, findings: vec![Diagnostic::new(Code::LimitReached, message)] });
        }
        let name = patch_column.and_then(|column| record.get(column));
        let index = match name {
            None => 0,
            Some(name) => names.iter().position(|known| *known == name).ok_or_else(|| {
                bad(format!(
                    "line {line}: there is no patch `{name}` among those that are evaluated: {}",
                    names.join(", ")
                ))
            })?,
        };
        let Some((part, time)) = parts.get(index).zip(times.get(index)) else { continue };
        let ranges = [part.domain().u, part.domain().v, part.domain().t];
        let mut point = [0.0, 0.0, *time];
        for (((coordinate, column), name), [low, high]) in
            point.iter_mut().zip(columns).zip(["u", "v", "t"]).zip(ranges)
        {
            let Some(column) = column else { continue };
            let text = record.get(column).unwrap_or("");
            *coordinate =
                text.parse().map_err(|_| bad(format!("line {line}: `{text}` in column `{name}` is not a number")))?;
            *coordinate = onto_end(*coordinate, [low, high]);
            if !(low..=high).contains(coordinate) {
                let (low, high) = (Shortest(low), Shortest(high));
                let message = format!("{shown}: line {line}: {name} = {text} lies outside the domain [{low}, {high}]");
                return Err(Failure::Found {
                    source: None,
                    findings: vec![Diagnostic::new(Code::PointOutsideDomain, message)],
                });
            }
        }
        rows.push(record);
        patches.push(index);
        points.push(point);
    }
    Ok(Table { separator, header, rows, patches, points })
}

/// Bytes of a first line that are read to see what separates its cells.
const LONGEST_HEADER: u64 = 1 << 16;

/// What separates the cells: commas, or else semicolons, or else tabs, as the first line shows that is neither empty nor
/// a comment; and the input from its beginning.
fn with_separator(input: impl Read + 'static) -> std::io::Result<(u8, Box<dyn Read>)> {
    let mut input = BufReader::new(input);
    let mut begun = Vec::new();
    loop {
        let start = begun.len();
        let read = (&mut input).take(LONGEST_HEADER).read_until(b'\n', &mut begun)?;
        let line = begun.get(start..).unwrap_or_default().trim_ascii();
        if read > 0 && (line.is_empty() || line.starts_with(b"#")) {
            continue;
        }
        let separator = [b',', b';', b'\t'].into_iter().find(|separator| line.contains(separator));
        return Ok((separator.unwrap_or(b','), Box::new(Cursor::new(begun).chain(input))));
    }
}

/// A coordinate that a rounding error puts outside its range, at the range's end: `2π` is written in many ways.
fn onto_end(coordinate: f64, [low, high]: [f64; 2]) -> f64 {
    let reach = 4.0 * f64::EPSILON * low.abs().max(high.abs());
    let nearest = coordinate.clamp(low, high);
    if (coordinate - nearest).abs() <= reach { nearest } else { coordinate }
}

/// Positions, then each derivative, at every point; each patch is solved once for each distinct instant.
fn evaluate(
    spec: &Spec,
    parts: &[Part],
    table: &Table,
    derivatives: &[Derivative],
    terminal: &Terminal,
) -> Result<Vec<Vec<[f64; 3]>>, Failure> {
    let wanted: Vec<Derivative> = std::iter::once(Derivative::NONE).chain(derivatives.iter().copied()).collect();
    let points = &table.points;
    let mut results = vec![vec![[0.0; 3]; points.len()]; wanted.len()];
    // Keyed by bits: equal instants are one.
    let mut instants: BTreeMap<(usize, u64), Vec<usize>> = BTreeMap::new();
    for (index, (patch, [_, _, t])) in table.patches.iter().zip(points).enumerate() {
        instants.entry((*patch, (t + 0.0).to_bits())).or_default().push(index);
    }
    let mut said = vec![Said::default(); parts.len()];
    for ((patch, bits), indices) in &instants {
        let Some((part, said)) = parts.get(*patch).zip(said.get_mut(*patch)) else { continue };
        let shape = spec.shape(part, f64::from_bits(*bits))?;
        print_warnings(&said.news(shape.warnings), &spec.source, terminal);
        let here: Vec<[f64; 3]> =
            indices.iter().filter_map(|&index| points.get(index)).map(|[u, v, t]| [*u, *v, t + 0.0]).collect();
        let mut values = vec![[0.0; 3]; here.len()];
        for (derivative, result) in wanted.iter().zip(&mut results) {
            shape.surface.evaluate(*derivative, &here, &mut values).map_err(|finding| spec.fault(finding))?;
            for (&index, value) in indices.iter().zip(&values) {
                if let Some(slot) = result.get_mut(index) {
                    *slot = *value;
                }
            }
        }
    }
    Ok(results)
}

fn write_table(table: &Table, derivatives: &[Derivative], values: &[Vec<[f64; 3]>]) -> Result<String, Failure> {
    let failed = |error: &dyn std::fmt::Display| Failure::Machine(format!("cannot write the table: {error}"));
    let mut writer = csv::WriterBuilder::new().delimiter(table.separator).from_writer(Vec::new());
    let suffixes = std::iter::once(String::new()).chain(derivatives.iter().map(|derivative| format!("_{derivative}")));
    let names = suffixes.flat_map(|suffix| COMPONENTS.map(|component| format!("{component}{suffix}")));
    let header: Vec<String> = table.header.iter().map(str::to_owned).chain(names).collect();
    writer.write_record(&header).map_err(|error| failed(&error))?;
    for (index, row) in table.rows.iter().enumerate() {
        // The shortest digits, at most 17, that read back to the same double.
        let results = values.iter().filter_map(|column| column.get(index)).flatten().map(|value| format!("{value:?}"));
        let cells: Vec<String> = row.iter().map(str::to_owned).chain(results).collect();
        writer.write_record(&cells).map_err(|error| failed(&error))?;
    }
    let bytes = writer.into_inner().map_err(|error| failed(&error))?;
    String::from_utf8(bytes).map_err(|error| failed(&error))
}
