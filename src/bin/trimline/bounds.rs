//! What a check may not exceed, and what did.

use clap::Args;
use serde::Serialize;

use trimline::diagnostic::Shortest;

use crate::failure::Failure;
use crate::output::rounded;

/// Bounds on what `check` measures.
#[derive(Args)]
pub struct Bounds {
    /// Fail if the surface misses a prescribed position, a joined surface or a seam by more than this.
    #[arg(long, value_name = "LENGTH")]
    max_gap: Option<f64>,

    /// Fail if the surface meets a joined surface, or another patch at a seam, at a larger angle than this.
    #[arg(long, value_name = "DEGREES")]
    max_angle: Option<f64>,

    /// Fail if the residual of the equation is a larger share of its largest term than this.
    #[arg(long, value_name = "SHARE")]
    max_residual: Option<f64>,

    /// Fail at any warning; notes are none.
    #[arg(long)]
    deny_warnings: bool,
}

/// What a bound is on.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// A distance.
    Gap,
    /// An angle in degrees.
    Angle,
    /// A residual over the largest term.
    Residual,
}

/// Something that was measured: what it is, where, and the number, if it has one.
pub struct Measured {
    pub quantity: Quantity,
    pub place: String,
    pub value: Option<f64>,
}

/// What exceeds a bound.
#[derive(Serialize)]
pub struct Exceeded {
    option: &'static str,
    /// The bound; null for `--deny-warnings`.
    bound: Option<f64>,
    /// The line of the report, or the warning.
    place: String,
    /// What was measured; null of what has no number, as an angle without normals.
    value: Option<f64>,
}

impl Bounds {
    fn all(&self) -> [(&'static str, Quantity, Option<f64>); 3] {
        [
            ("--max-gap", Quantity::Gap, self.max_gap),
            ("--max-angle", Quantity::Angle, self.max_angle),
            ("--max-residual", Quantity::Residual, self.max_residual),
        ]
    }

    /// Refuses bounds that nothing can keep.
    pub fn check(&self) -> Result<(), Failure> {
        match self.all().into_iter().find(|(_, _, most)| most.is_some_and(|most| most.is_nan() || most < 0.0)) {
            Some((option, ..)) => Err(Failure::Usage(format!("{option} takes a number, 0 or more"))),
            None => Ok(()),
        }
    }

    /// Which of `measured` and `warnings` are beyond the bounds; what has no number is not shown to be small.
    pub fn exceeded(&self, measured: &[Measured], warnings: impl Iterator<Item = String>) -> Vec<Exceeded> {
        let mut exceeded = Vec::new();
        for (option, quantity, bound) in self.all() {
            let Some(most) = bound else { continue };
            let is_within = |one: &&Measured| one.value.is_some_and(|value| value <= most);
            let beyond = measured.iter().filter(|one| one.quantity == quantity && !is_within(one));
            exceeded.extend(beyond.map(|one| Exceeded { option, bound, place: one.place.clone(), value: one.value }));
        }
        if self.deny_warnings {
            let denied = |place| Exceeded { option: "--deny-warnings", bound: None, place, value: None };
            exceeded.extend(warnings.map(denied));
        }
        exceeded
    }
}

impl Exceeded {
    /// `S at u = 0 of cap: 0.15 exceeds --max-gap 0.1`
    pub fn describe(&self) -> String {
        let Exceeded { option, place, .. } = self;
        match (self.bound, self.value) {
            (None, _) => format!("{place}: {option}"),
            (Some(bound), None) => format!("{place}: nothing to be measured for {option} {}", stated(bound)),
            (Some(bound), Some(value)) => {
                // As many digits as show that it does.
                let shown = Some(rounded(value)).filter(|shown| shown.parse().is_ok_and(|shown: f64| shown > bound));
                let shown = shown.unwrap_or_else(|| Shortest(value).to_string());
                format!("{place}: {shown} exceeds {option} {}", stated(bound))
            }
        }
    }
}

/// A bound as people write it.
fn stated(bound: f64) -> String {
    if (1e-2..1e4).contains(&bound) || bound == 0.0 { Shortest(bound).to_string() } else { format!("{bound:e}") }
}
