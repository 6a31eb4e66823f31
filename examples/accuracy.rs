//! Writes docs/accuracy.md: the problems of three papers, solved by every method that applies, and measured.
//!
//! `cargo run --release --no-default-features --example accuracy > docs/accuracy.md`

use trimline::blend::Blend;
use trimline::diagnostic::{Code, Diagnostics, Source};
use trimline::expr::Derivative;
use trimline::method::{Options, Settings, Solution};
use trimline::verify::Verification;

fn main() -> Result<(), Diagnostics> {
    print!("{}", document()?);
    Ok(())
}

const INTRODUCTION: &str = "\
# Accuracy

What the methods achieve on the problems of the papers they come from. [methods.md](methods.md) explains them, names the papers
(YUZ, YZ03, YZ04) and lists the corrections to their formulas, which are in force here. A program writes this page, and a test
repeats it.

- *Error* is the largest error of a coordinate of S on 101 x 101 points, edges included, against the method `exact`.
- *Independent* is the same number computed apart from this program, from the corrected formulas, where there is one.
- *Boundary* is the largest deviation from a boundary condition, *residual* the largest residual of the equation over its largest
  single term, both on the verifier's 23 x 37 points, which no method fits.
- *Unknowns* are those of the linear systems, which the components share where their equations are the same. In brackets their
  rank, where it is lower.

What is below 5e-15 is rounding. That the solutions of `exact` are the right ones rests on their boundary and residual columns, and
on the columns *independent*, which were measured against solutions in 50 digits or more. The papers print pictures and no errors.
";

const AFTERWORD: &str = "
## Writing this page again

```sh
cargo run --release --no-default-features --example accuracy > docs/accuracy.md
```

`cargo test --test suite accuracy` measures everything again and compares, numbers within 10 %.
";

/// A problem, solved by `exact` and by fitted methods.
struct Section {
    title: &'static str,
    /// What is measured, and what the paper has.
    about: &'static str,
    text: &'static str,
    /// Coefficients that differ from those of `text`.
    changes: &'static [(&'static str, &'static str)],
    t: f64,
    fits: &'static [Fitted],
}

/// A fitted method with its settings.
struct Fitted {
    method: &'static str,
    terms: &'static str,
    points: &'static str,
    /// Nothing, or what is fitted together.
    fit: &'static str,
    /// The error found apart from this program, in as many digits as are known, or a dash.
    independent: &'static str,
}

const NONE: &str = "–";

const fn sine(terms: &'static str, points: &'static str, independent: &'static str) -> Fitted {
    Fitted { method: "sine", terms, points, fit: "", independent }
}

const fn joint(terms: &'static str, points: &'static str, independent: &'static str) -> Fitted {
    Fitted { method: "polynomial", terms, points, fit: "joint", independent }
}

const fn per_basis(terms: &'static str, points: &'static str, independent: &'static str) -> Fitted {
    Fitted { method: "polynomial", terms, points, fit: "per-basis", independent }
}

/// The square systems of YZ04, for M = N = 4, 6 and 8.
const fn squares(independent: [&'static str; 3]) -> [Fitted; 3] {
    let [four, six, eight] = independent;
    [
        Fitted { method: "static_blend", terms: "4x4", points: "5x5:ends", fit: "", independent: four },
        Fitted { method: "static_blend", terms: "6x6", points: "7x7:ends", fit: "", independent: six },
        Fitted { method: "static_blend", terms: "8x8", points: "9x9:ends", fit: "", independent: eight },
    ]
}

const EQ19: &str = include_str!("eq19.trim");

const COMPARISON: Section = Section {
    title: "YUZ Eq. (19), Fig. 1",
    about: "\
Two elliptic cylinders, β = λ = ρ = η = 1 and γ = 12.1, at t = 0. YUZ compare pictures for K = 5 and 7 on 11 x 11 points with
the closed form, see no difference, and time K = 5 and 10. Their points are \"uniformly collocated\": midpoints, or a grid with ends.
On the latter sin 10πu is zero at every node, so that K = 10 is aliased. Without the corrections their formulas give 7.3e-2,
7.1e-2 and 1.4e-1 for K = 5, 7 and 10 with ends, and tangents at u = 0 that are off by 0.4 to 0.7; the cubic without any sine
misses by 1.2e-2 and meets them.",
    text: EQ19,
    changes: &[],
    t: 0.0,
    fits: &[
        sine("5", "11x11", "7.43e-4"),
        sine("7", "11x11", "3.95e-4"),
        sine("10", "11x11", "1.10e-4"),
        sine("5", "11x11:ends", "3.09e-3"),
        sine("7", "11x11:ends", "3.07e-3"),
        sine("10", "11x11:ends", "9.57e-2"),
        per_basis("7", "17x17:ends", "4.5e-5"),
        per_basis("9", "17x17:ends", "1.2e-7"),
        per_basis("11", "17x17:ends", "4.9e-10"),
    ],
};

const FIGURES_ABOUT: &str = "\
The same problem at t = 0 with the coefficients that YUZ vary to change the shape; they print pictures. For `exact`: the largest
coordinate of S, the amplification (methods.md, *Resonance*), boundary and residual. The sine series has K = 10 on 41 x 11 points
with ends. The data reach to 2, and so does the series, whatever the coefficients. The solutions go beyond in Figs. 4 (a), (b) and 6,
near a resonance: between 4 (b) and 4 (a), at η = -113.6148, the solution passes through infinity and changes its sign, which
no picture shows. In Fig. 5 (a), β = 0 leaves an equation of second order, which cannot meet four conditions: there is no
exact solution, and `exact` says so.";

/// One picture of YUZ Figs. 3-7: its coefficients, and independent values of the largest coordinate, the
/// amplification, and the error of the sine series.
struct Picture {
    name: &'static str,
    /// β, γ, λ, ρ and η.
    coefficients: [&'static str; 5],
    independent: [&'static str; 3],
}

const fn picture(name: &'static str, coefficients: [&'static str; 5], independent: [&'static str; 3]) -> Picture {
    Picture { name, coefficients, independent }
}

const PICTURES: [Picture; 15] = [
    picture("3 (a)", ["0.01", "10", "0.01", "200", "0.01"], ["2.00", "1", "0.58"]),
    picture("3 (b)", ["0.01", "10", "0.01", "100", "0.01"], ["2.00", "1", "0.56"]),
    picture("3 (c)", ["0.01", "10", "0.01", "10", "0.01"], ["2.00", "1", "0.16"]),
    picture("4 (a)", ["0.01", "10", "0.01", "0.01", "-120"], ["18.3", "36.6", "19"]),
    picture("4 (b)", ["0.01", "10", "0.01", "0.01", "-100"], ["8.48", "15.7", "7.6"]),
    picture("4 (c)", ["0.01", "10", "0.01", "0.01", "-50"], ["2.00", "2.57", "0.72"]),
    picture("5 (a)", ["0", "10", "0.01", "0.01", "-5"], [NONE, NONE, NONE]),
    picture("5 (b)", ["-0.15", "10", "0.01", "0.01", "-5"], ["2.00", "11", "0.14"]),
    picture("5 (c)", ["-0.18", "10", "0.01", "0.01", "-5"], ["2.00", "7", "0.094"]),
    picture("6 (a)", ["0.01", "12", "0.01", "0.01", "-120"], ["9.41", "17.5", "8.5"]),
    picture("6 (b)", ["0.01", "14", "0.01", "0.01", "-120"], ["4.48", "7.8", "3.5"]),
    picture("6 (c)", ["0.01", "16", "0.01", "0.01", "-120"], ["3.23", "5.3", "2.2"]),
    picture("7 (a)", ["0.01", "10", "60", "1", "0.01"], ["2.00", "1", "0.47"]),
    picture("7 (b)", ["0.01", "10", "80", "1", "0.01"], ["2.00", "1", "0.53"]),
    picture("7 (c)", ["0.01", "10", "100", "1", "0.01"], ["2.00", "1", "0.56"]),
];

/// What follows the pictures.
const SECTIONS: [Section; 12] = [
    Section {
        title: "YUZ Eqs. (29) and (30), Fig. 8",
        about: "\
At t = 0.5, with constants of our own, since YUZ print none: there is nothing to compare with. `joint` is the fit of
YZ03, whose systems are rank-deficient at a single instant.",
        text: include_str!("eq29_30.trim"),
        changes: &[],
        t: 0.5,
        fits: &[
            sine("10", "13x13", NONE),
            joint("7", "8x8", NONE),
            joint("10", "17x17", NONE),
            per_basis("7", "8x8", NONE),
            per_basis("10", "17x17", NONE),
        ],
    },
    Section {
        title: "YUZ Eqs. (29) and (30) with boundary layers",
        about: "\
The same with β = 0.01 and γ = 10. The solution has layers at both trimlines, and an amplification of 156 takes it to 9.0;
the fits stay below 2.6, as the data do.",
        text: include_str!("eq29_30.trim"),
        changes: &[("beta", "0.01"), ("gamma", "10")],
        t: 0.5,
        fits: &[sine("10", "13x13", NONE), per_basis("7", "8x8", NONE), per_basis("10", "17x17", NONE)],
    },
    Section {
        title: "YUZ Eqs. (31) and (32), Fig. 9",
        about: "\
At t = 0.5, with constants of our own and the tangents of S_y corrected. Polynomials with N = 7 are on 9 x 9 points:
on 8 x 8 midpoints sin 8v is zero, which is an error.",
        text: include_str!("eq31_32.trim"),
        changes: &[],
        t: 0.5,
        fits: &[
            sine("10", "13x13", NONE),
            joint("7", "9x9", NONE),
            joint("10", "17x17", NONE),
            per_basis("7", "9x9", NONE),
            per_basis("10", "17x17", NONE),
        ],
    },
    Section {
        title: "YZ03 Eq. (13), Fig. 1",
        about: "\
A static free-form surface, whose data v and e^(0.1v) no Fourier series fits. YZ03 compare pictures: they see no difference between
N = 7 on 36 points and the closed form, and reject a Fourier series with N = 20 and a pseudospectral method with N = 5 and 10. Computed
apart from this program these are off by 1.49, 0.58 and 0.89, the last two for ω = 3; YZ03 print no ω.",
        text: include_str!("eq13.trim"),
        changes: &[],
        t: 0.0,
        fits: &[
            joint("7", "6x6:ends", "1.14e-3"),
            joint("7", "6x6", "1.67e-4"),
            sine("7", "11x11:ends", "3.4e-2"),
            sine("7", "11x11", "5.3e-3"),
        ],
    },
    Section {
        title: "YZ03 Eq. (27), Fig. 3",
        about: "\
A vase whose rim moves, at t = 0.6. YZ03 fit N = 7 jointly at each instant, where t² cos v and t³ cos v are multiples of
cos v, and state that no closed form exists; `exact` finds it on the closure of their basis.",
        text: include_str!("eq27.trim"),
        changes: &[],
        t: 0.6,
        fits: &[
            joint("7", "6x6:ends", "1.7e-4"),
            joint("7", "6x6", NONE),
            per_basis("7", "6x6:ends", NONE),
            per_basis("7", "6x6", NONE),
            sine("7", "11x11", "7.9e-5"),
        ],
    },
    Section {
        title: "YZ04 Eq. (15), example 1",
        about: "\
A cylinder joined to a hyperboloid. YZ04 print neither M nor N nor the points, here and in the examples below. M = N = 4, 6 and 8
are taken, on equally spaced points with ends, as many as there are coefficients; v runs to 2π, in example 2 to 1.",
        text: include_str!("p1_ex1.trim"),
        changes: &[],
        t: 0.0,
        fits: &squares(["0.045", "0.0046", "4e-4"]),
    },
    Section {
        title: "YZ04 Eq. (18), example 2",
        about: "\
Two cylinders, data linear in v. The solution is a cubic in u for which every term of the equation is zero, so that terms
of a fit are all residual: their quotient is 1 however good the fit.",
        text: include_str!("p1_ex2.trim"),
        changes: &[],
        t: 0.0,
        fits: &squares(["0.0019", "5e-5", "3e-6"]),
    },
    Section {
        title: "YZ04 Eq. (21), example 3",
        about: "\
An irregular cone joined to a cylinder at an angle.",
        text: include_str!("p1_ex3.trim"),
        changes: &[],
        t: 0.0,
        fits: &squares(["0.031", "0.013", "0.0025"]),
    },
    Section {
        title: "YZ04 Eq. (22), example 4",
        about: "\
Two trimlines of one cylinder.",
        text: include_str!("p1_ex4.trim"),
        changes: &[],
        t: 0.0,
        fits: &squares(["0.036", "0.0037", "3e-4"]),
    },
    Section {
        title: "YZ04 Eq. (25), example 5",
        about: "\
An irregular cylinder joined to a plane, with an equation of its own for each component.",
        text: include_str!("p1_ex5.trim"),
        changes: &[],
        t: 0.0,
        fits: &squares(["0.37", "0.26", "0.11"]),
    },
    Section {
        title: "YZ04 Eq. (28), example 6",
        about: "\
An open surface joined to a plane at a curve with sin 6v, which varies faster than the solution with e^(3.61v) that
vanishes at the trimlines: powers of v come no closer, however many are taken.",
        text: include_str!("p1_ex6.trim"),
        changes: &[],
        t: 0.0,
        fits: &squares(["0.14", "0.074", "0.17"]),
    },
    Section {
        title: "YZ04 Eq. (28) by sines",
        about: "\
The same by the method of YUZ, whose basis contains sin 6v.",
        text: include_str!("p1_ex6.trim"),
        changes: &[],
        t: 0.0,
        fits: &[sine("5", "13x17", NONE), sine("10", "13x17", NONE)],
    },
];

/// The whole page.
///
/// # Errors
/// What the compiler or a method finds wrong; nothing, as long as the examples are solvable.
pub fn document() -> Result<String, Diagnostics> {
    let mut page = INTRODUCTION.to_owned();
    page += &section(&COMPARISON)?;
    page += &pictures()?;
    for problem in &SECTIONS {
        page += &section(problem)?;
    }
    page += AFTERWORD;
    Ok(page)
}

fn section(problem: &Section) -> Result<String, Diagnostics> {
    let mut lines = format!("\n## {}\n\n{}\n\n", problem.title, problem.about);
    lines +=
        "| method | error | independent | boundary | residual | unknowns |\n| --- | --- | --- | --- | --- | --- |\n";
    let exact = Measured::new("exact", &[], problem.text, problem.changes, problem.t)?;
    lines += &format!("| `exact` | {NONE} | {NONE} | {} |\n", exact.columns());
    for fitted in problem.fits {
        let settings = [("terms", fitted.terms), ("points", fitted.points), ("fit", fitted.fit)];
        let found = Measured::new(fitted.method, &settings, problem.text, problem.changes, problem.t)?;
        let error = digits(found.distance(&exact));
        lines += &format!("| {} | {error} | {} | {} |\n", fitted.label(), fitted.independent, found.columns());
    }
    Ok(lines)
}

/// The table of YUZ Figs. 3-7.
fn pictures() -> Result<String, Diagnostics> {
    let mut lines = format!("\n## YUZ Figs. 3-7\n\n{FIGURES_ABOUT}\n\n");
    lines += "| figure | β, γ, λ, ρ, η | largest | independent | amplification | independent | boundary | residual | error of `sine` | \
              independent | its residual |\n";
    lines += &format!("|{}\n", " --- |".repeat(11));
    for Picture { name, coefficients, independent: [size, amplification, error] } in &PICTURES {
        let names = ["beta", "gamma", "lambda", "rho", "eta"];
        let changes: Vec<(&str, &str)> = names.into_iter().zip(coefficients.iter().copied()).collect();
        let series = Measured::new("sine", &[("terms", "10"), ("points", "41x11:ends")], EQ19, &changes, 0.0)?;
        let residual = digits(series.verified.relative_residual());
        lines += &format!("| {name} | {} |", coefficients.join(", "));
        match Measured::new("exact", &[], EQ19, &changes, 0.0) {
            Ok(exact) => {
                let largest = exact.positions.iter().flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
                let amplified = exact.solution.report.amplification.map_or_else(|| NONE.to_owned(), plain);
                lines += &format!(" {} | {size} | {amplified} | {amplification} |", plain(largest));
                lines += &format!(" {} |", exact.verification_columns());
                lines += &format!(" {} | {error} | {residual} |\n", digits(series.distance(&exact)));
            }
            Err(found) if found.iter().any(|finding| finding.code == Code::OrderDrops) => {
                lines += &format!(" no solution |{} {residual} |\n", format!(" {NONE} |").repeat(7));
            }
            Err(found) => return Err(found),
        }
    }
    Ok(lines)
}

impl Fitted {
    /// The method and its settings, as a reader of the papers would name them.
    fn label(&self) -> String {
        let (letter, terms) = match self.method {
            "sine" => ("K", self.terms),
            "static_blend" => ("M = N", self.terms.split('x').next().unwrap_or_default()),
            _ => ("N", self.terms),
        };
        let (counts, kind) = self.points.split_once(':').unwrap_or((self.points, "midpoints"));
        let mut label = format!("`{}`, {letter} = {terms}, {} {kind}", self.method, counts.replace('x', " x "));
        if !self.fit.is_empty() {
            label += ", ";
            label += self.fit;
        }
        label
    }
}

/// A solution with what is measured on it.
struct Measured {
    solution: Solution,
    verified: Verification,
    /// On 101 x 101 points.
    positions: Vec<[f64; 3]>,
}

impl Measured {
    /// Solves `text` by a method; settings without a value are left out.
    ///
    /// # Errors
    /// What the compiler or the method finds wrong.
    fn new(
        method: &str,
        settings: &[(&str, &str)],
        text: &str,
        changes: &[(&str, &str)],
        t: f64,
    ) -> Result<Measured, Diagnostics> {
        let mut given = Settings::default();
        for (name, value) in settings.iter().filter(|(_, value)| !value.is_empty()) {
            given.set(name, value, None).map_err(|finding| vec![finding])?;
        }
        let options = Options { method: Some(method.to_owned()), settings: given, ..Options::default() };
        let mut blend = Blend::compile(&Source::new("accuracy", text), &options)?;
        for (name, value) in changes {
            blend.set(name, value)?;
        }
        let solution = blend.solve(0, t).map_err(|finding| vec![finding])?;
        let verified = blend.verify(0, &solution, t).map_err(|finding| vec![finding])?;
        let mut positions = vec![[0.0; 3]; 101 * 101];
        if let Some(patch) = blend.patches.first() {
            let [u, v] = [patch.domain.u, patch.domain.v].map(hundred_steps);
            let grid = (u.as_slice(), v.as_slice(), t);
            let evaluated = solution.surface.evaluate_grid(Derivative::NONE, grid, &mut positions);
            evaluated.map_err(|finding| vec![finding])?;
        }
        Ok(Measured { solution, verified, positions })
    }

    /// The largest difference in a coordinate.
    fn distance(&self, other: &Measured) -> f64 {
        let pairs = self.positions.iter().flatten().zip(other.positions.iter().flatten());
        pairs.fold(0.0, |most, (a, b)| most.max((a - b).abs()))
    }

    /// Boundary error and residual.
    fn verification_columns(&self) -> String {
        format!("{} | {}", digits(self.verified.boundary_error()), digits(self.verified.relative_residual()))
    }

    /// Boundary error, residual, unknowns and, where it is lower, rank.
    fn columns(&self) -> String {
        let report = &self.solution.report;
        let rank = if report.rank < report.unknowns { format!(" ({})", report.rank) } else { String::new() };
        format!("{} | {}{rank}", self.verification_columns(), report.unknowns)
    }
}

fn hundred_steps([low, high]: [f64; 2]) -> Vec<f64> {
    (0..=100).map(|step| low + (high - low) * f64::from(step) / 100.0).collect()
}

/// Two digits; rounding errors, which differ between machines, are not told apart.
fn digits(value: f64) -> String {
    if value < 5e-15 { "< 5e-15".to_owned() } else { format!("{value:.1e}") }
}

/// Two digits, for numbers near 1.
fn plain(value: f64) -> String {
    format!("{value:.1e}").parse::<f64>().unwrap_or(value).to_string()
}
