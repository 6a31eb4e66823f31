//! Which frames a morph consists of (docs/morphing.md, M1 to M3).

use crate::diagnostic::{Code, Diagnostic};
use crate::limits::Limits;

use super::Kind;

/// A frame: between source and target, or one of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Weight of the target's boundary data, in [0, 1].
    pub epsilon: f64,
    /// The number of modes, without a remainder; between two whole numbers the next mode has the rest as its
    /// weight. `None` for what the specs ask for.
    pub modes: Option<f64>,
}

/// The frames between source and target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sequence {
    kind: Kind,
    steps: usize,
    /// N_s and N_t.
    modes: [usize; 2],
}

/// Frames of a morph of boundary data, unless told otherwise (González Castro et al., section 4.1).
const BOUNDARY_STEPS: usize = 9;

impl Sequence {
    /// A sequence of `steps` frames, or of as many as the paper has, between shapes of N_s and N_t modes.
    ///
    /// # Errors
    /// [`Code::SettingOutOfRange`] for no frames, or for a number other than N_s + N_t where modes alone change;
    /// [`Code::LimitReached`] for more than `limits.frames`, source and target included.
    pub fn new(kind: Kind, steps: Option<usize>, modes: [usize; 2], limits: &Limits) -> Result<Sequence, Diagnostic> {
        let all = modes.iter().fold(0_usize, |sum, modes| sum.saturating_add(*modes));
        let usual = match kind {
            Kind::Boundary => BOUNDARY_STEPS,
            Kind::Modes => all,
            Kind::Both => all.saturating_add(1),
        };
        let steps = steps.unwrap_or(usual);
        if kind == Kind::Modes && steps != all {
            let [source, target] = modes;
            let message = format!("a morph by modes has {source} + {target} frames in between, not {steps}");
            let finding = Diagnostic::new(Code::SettingOutOfRange, message);
            return Err(finding.hint("leave the number of frames out, or morph by both"));
        }
        if steps == 0 {
            let finding = Diagnostic::new(Code::SettingOutOfRange, "a morph of 0 frames has nothing in between");
            return Err(finding.hint("ask for at least 1 frame"));
        }
        if steps.saturating_add(2) > limits.frames {
            let message = format!("a morph of {steps} frames is over the limit frames = {}", limits.frames);
            let finding = Diagnostic::new(Code::LimitReached, message);
            return Err(finding.hint("ask for fewer frames, or raise the limit `frames`"));
        }
        Ok(Sequence { kind, steps, modes })
    }

    /// What changes from frame to frame.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// M.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Frame number `index`, from 1 to M.
    #[must_use]
    pub fn frame(&self, index: usize) -> Frame {
        let [source, target] = self.modes;
        match self.kind {
            Kind::Boundary => Frame { epsilon: index as f64 / (self.steps + 1) as f64, modes: None },
            Kind::Modes if index <= source => {
                Frame { epsilon: 0.0, modes: Some((source + 1).saturating_sub(index) as f64) }
            }
            Kind::Modes => Frame { epsilon: 1.0, modes: Some(index.saturating_sub(source).min(target) as f64) },
            Kind::Both if self.steps == 1 => self.combined(0.5),
            Kind::Both => self.combined(index.saturating_sub(1) as f64 / (self.steps - 1) as f64),
        }
    }

    /// The frame at any ε in [0, 1]; `None` where modes alone change.
    #[must_use]
    pub fn at(&self, epsilon: f64) -> Option<Frame> {
        match self.kind {
            Kind::Boundary => Some(Frame { epsilon, modes: None }),
            Kind::Modes => None,
            Kind::Both => Some(self.combined(epsilon)),
        }
    }

    /// N falls from N_s to 1, stays there for a step of the paper's sequence, and rises to N_t (M3).
    fn combined(&self, epsilon: f64) -> Frame {
        let [source, target] = self.modes.map(|modes| modes as f64);
        let place = epsilon * (source + target);
        // Fractions of small whole numbers: what is that close to one is one.
        let place = if (place - place.round()).abs() < 1e-9 { place.round() } else { place };
        let modes = if place <= source { source - place } else { place - source };
        Frame { epsilon, modes: Some(modes.max(1.0)) }
    }
}
