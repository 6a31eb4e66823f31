//! Solved surfaces as stand-alone source code in other languages.
//!
//! Input: a [`Formula`], which is a solution over a basis or a B-spline with everything numeric worked out, and for a
//! copy where it is; output: source text with no dependency but the language's own mathematics. A language is one file
//! with a `ROW` and one line in [`Language`]; what they share is the [`Formula`] and the lowering of programs in `statements`.
//!
//! Invariant: every emitted function computes S, S_u and S_v, of a sum of products as
//! `S(u, v, t) = Σ_j F_j(v, t) G_j(u)`, the F_j by the same operations in the same order as
//! [`eval`](crate::eval), the G_j by Clenshaw's recurrence on the same tables; of a B-spline by de Boor's recurrence.
//!
//! Absent on purpose: solving. The coefficients belong to one set of parameter values and, for fitted methods of
//! moving problems, to one instant, which is then part of the function.

mod amplitudes;
mod c;
mod formula;
mod glsl;
mod numpy;
mod rust;
mod statements;
mod table;
mod wgsl;

pub use amplitudes::amplitude_series;
pub use formula::{Form, Formula, Placement, Sum};

use crate::diagnostic::{Code, Diagnostic};
use crate::numeric::ChebyshevSeries;

/// A language that surfaces can be emitted in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Language {
    /// OpenGL ES shading language 3.00, also for desktop GLSL 3.30 and up.
    Glsl,
    /// The WebGPU shading language.
    Wgsl,
    /// C99.
    C,
    /// Rust.
    Rust,
    /// Python with NumPy.
    Numpy,
}

/// What one language file declares about itself.
struct Row {
    name: &'static str,
    description: &'static str,
    is_single_precision: bool,
    write: fn(&Formula) -> String,
}

impl Language {
    /// Every language, in the order help texts list them.
    pub const ALL: &[Language] = &[Language::Glsl, Language::Wgsl, Language::C, Language::Rust, Language::Numpy];

    fn row(self) -> &'static Row {
        match self {
            Language::Glsl => &glsl::ROW,
            Language::Wgsl => &wgsl::ROW,
            Language::C => &c::ROW,
            Language::Rust => &rust::ROW,
            Language::Numpy => &numpy::ROW,
        }
    }

    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// What it is, in one line.
    #[must_use]
    pub fn description(self) -> &'static str {
        self.row().description
    }

    /// Whether the emitted function computes with 24 bits instead of 53.
    #[must_use]
    pub fn is_single_precision(self) -> bool {
        self.row().is_single_precision
    }
}

/// WGSL bounds a table by 64 KiB, of which a vector takes 16 bytes; what GLSL takes depends on the browser, and is little more.
const LONGEST_TABLE_OF_SHADERS: usize = 4096;

/// The source text of `formula` in `language`.
///
/// # Errors
/// [`Code::FormatCannotHold`] when a number does not fit the language's precision, or a table is longer than those of shaders.
pub fn emit(formula: &Formula, language: Language) -> Result<String, Diagnostic> {
    if language.is_single_precision()
        && let Some(number) = formula.numbers().into_iter().find(|number| !(*number as f32).is_finite())
    {
        let message = format!("the number {number:?} of this surface is too large for {}", language.description());
        return Err(Diagnostic::new(Code::FormatCannotHold, message)
            .hint("scale the problem, or emit a language of double precision: c, rust or numpy"));
    }
    let longest = longest_table(formula);
    if language.is_single_precision() && longest > LONGEST_TABLE_OF_SHADERS {
        let message = format!(
            "a table of {} holds {LONGEST_TABLE_OF_SHADERS} vectors, and this surface has one of {longest}",
            language.description()
        );
        return Err(Diagnostic::new(Code::FormatCannotHold, message).hint(
            "a B-spline that may be farther off, `--within LENGTH`, fewer `--modes`, or a language with longer tables: c, rust or numpy",
        ));
    }
    Ok((language.row().write)(formula))
}

/// The number of vectors in the longest table that the text has.
fn longest_table(formula: &Formula) -> usize {
    match &formula.form {
        Form::Net(surface, _) => surface.net().len(),
        Form::Sum(sum) => {
            let vectors = |series: &ChebyshevSeries| series.coefficients.iter().map(Vec::len).sum::<usize>() / 3;
            sum.amplitudes.iter().map(vectors).max().unwrap_or(0)
        }
    }
}
