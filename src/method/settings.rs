//! Settings of methods: from a `solve` statement, an option, or Rust.

use crate::diagnostic::{Code, Diagnostic, Span};
use crate::numeric::NodeKind;
use crate::problem::RequestedSetting;

/// Settings a user may give; methods have defaults for what is not given.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Settings {
    /// The number of trial functions, or the highest powers.
    pub terms: Option<(Terms, Option<Span>)>,
    /// The collocation grid.
    pub points: Option<(Size, Option<Span>)>,
    /// Whether coefficients of all basis functions are fitted together.
    pub fit: Option<(Fit, Option<Span>)>,
    /// The number of wave numbers of a Fourier series.
    pub modes: Option<(usize, Option<Span>)>,
    /// Whether the part that a truncated series leaves out is carried across the blend.
    pub remainder: Option<(bool, Option<Span>)>,
    /// The tolerance of adaptive methods.
    pub tolerance: Option<(f64, Option<Span>)>,
}

/// `K`, or `M x N` for methods with two.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Terms {
    /// K, or M.
    pub first: usize,
    /// N, if it is given.
    pub second: Option<usize>,
}

/// What is fitted together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fit {
    /// The coefficients of all basis functions.
    Joint,
    /// Those of each basis function alone.
    PerBasis,
}

/// A collocation grid: counts in u and v, and where the nodes lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size {
    /// Nodes in u.
    pub u: usize,
    /// Nodes in v.
    pub v: usize,
    /// Where they lie.
    pub kind: NodeKind,
}

impl Size {
    /// Reads `11x11` or `11x11:ends`.
    ///
    /// # Errors
    /// [`Code::UnknownSetting`] for text of another form.
    pub fn read(text: &str) -> Result<Size, Diagnostic> {
        let wrong = || {
            Diagnostic::new(Code::UnknownSetting, format!("`{text}` is not a grid"))
                .hint("write `11 x 11`, or `11 x 11 : ends`; the kinds are midpoints, ends, gauss and chebyshev")
        };
        let (counts, kind) = match text.split_once(':') {
            Some((counts, kind)) => {
                let known = NodeKind::NAMED.iter().find(|(name, _)| *name == kind);
                (counts, known.map(|(_, kind)| *kind).ok_or_else(wrong)?)
            }
            None => (text, NodeKind::default()),
        };
        let (u, v) = counts.split_once('x').ok_or_else(wrong)?;
        let count = |text: &str| text.trim().parse::<usize>().map_err(|_| wrong());
        Ok(Size { u: count(u)?, v: count(v)?, kind })
    }
}

impl Settings {
    /// These settings, and those of `other` where there are none. A number of modes stands for a tolerance, and a tolerance
    /// for a number of modes.
    #[must_use]
    pub fn over(self, other: Settings) -> Settings {
        let has_length = self.modes.is_some() || self.tolerance.is_some();
        let other = Settings {
            modes: other.modes.filter(|_| !has_length),
            tolerance: other.tolerance.filter(|_| !has_length),
            ..other
        };
        Settings {
            terms: self.terms.or(other.terms),
            points: self.points.or(other.points),
            fit: self.fit.or(other.fit),
            modes: self.modes.or(other.modes),
            remainder: self.remainder.or(other.remainder),
            tolerance: self.tolerance.or(other.tolerance),
        }
    }

    /// Reads the settings of a `solve` statement; later ones with the same key are an error.
    ///
    /// # Errors
    /// [`Code::UnknownSetting`] for an unknown key or a value of the wrong form, [`Code::DuplicateStatement`] for
    /// a key given twice.
    pub fn read(requested: &[RequestedSetting]) -> Result<Settings, Diagnostic> {
        let mut settings = Settings::default();
        for (index, setting) in requested.iter().enumerate() {
            if requested.iter().take(index).any(|earlier| earlier.key == setting.key) {
                let message = format!("the setting `{}` is given twice", setting.key);
                return Err(Diagnostic::new(Code::DuplicateStatement, message).at(setting.origin));
            }
            settings.set(&setting.key, &setting.value, setting.origin)?;
        }
        Ok(settings)
    }

    /// The settings that are given, by name.
    #[must_use]
    pub fn given(&self) -> Vec<(&'static str, Option<Span>)> {
        let all = [
            ("terms", self.terms.map(|(_, origin)| origin)),
            ("points", self.points.map(|(_, origin)| origin)),
            ("fit", self.fit.map(|(_, origin)| origin)),
            ("modes", self.modes.map(|(_, origin)| origin)),
            ("remainder", self.remainder.map(|(_, origin)| origin)),
            ("tolerance", self.tolerance.map(|(_, origin)| origin)),
        ];
        all.into_iter().filter_map(|(name, origin)| origin.map(|origin| (name, origin))).collect()
    }

    /// These settings without those that are not in `names`.
    #[must_use]
    pub fn only(self, names: &[&str]) -> Settings {
        let has = |name: &str| names.contains(&name);
        Settings {
            terms: self.terms.filter(|_| has("terms")),
            points: self.points.filter(|_| has("points")),
            fit: self.fit.filter(|_| has("fit")),
            modes: self.modes.filter(|_| has("modes")),
            remainder: self.remainder.filter(|_| has("remainder")),
            tolerance: self.tolerance.filter(|_| has("tolerance")),
        }
    }

    /// Sets one setting from text, for example `points` from `11x11:ends`.
    ///
    /// # Errors
    /// [`Code::UnknownSetting`].
    pub fn set(&mut self, key: &str, value: &str, origin: Option<Span>) -> Result<(), Diagnostic> {
        match key {
            "terms" => self.terms = Some((Terms::read(value).map_err(|finding| finding.at(origin))?, origin)),
            "fit" => {
                let fit = match value {
                    "joint" => Fit::Joint,
                    "per-basis" => Fit::PerBasis,
                    _ => {
                        let message = format!("`{value}` is not a way to fit");
                        return Err(Diagnostic::new(Code::UnknownSetting, message)
                            .at(origin)
                            .hint("write joint or per-basis"));
                    }
                };
                self.fit = Some((fit, origin));
            }
            "points" => self.points = Some((Size::read(value).map_err(|finding| finding.at(origin))?, origin)),
            "modes" => {
                let wrong =
                    || Diagnostic::new(Code::UnknownSetting, format!("`{value}` is not a number of modes")).at(origin);
                self.modes = Some((value.parse().map_err(|_| wrong().hint("write a whole number"))?, origin));
            }
            "remainder" => {
                let is_on = match value {
                    "on" => true,
                    "off" => false,
                    _ => {
                        let message = format!("`{value}` does not say what to do with the remainder");
                        return Err(Diagnostic::new(Code::UnknownSetting, message).at(origin).hint("write on or off"));
                    }
                };
                self.remainder = Some((is_on, origin));
            }
            "tolerance" => {
                let wrong =
                    || Diagnostic::new(Code::UnknownSetting, format!("`{value}` is not a tolerance")).at(origin);
                self.tolerance =
                    Some((value.parse().map_err(|_| wrong().hint("write a number such as 1e-10"))?, origin));
            }
            _ => {
                let finding = Diagnostic::new(Code::UnknownSetting, format!("there is no setting `{key}`"));
                return Err(finding
                    .at(origin)
                    .hint("settings: terms = K, points = L x M [: midpoints | ends | gauss | chebyshev], fit = joint | per-basis, modes = N, remainder = on | off, tolerance = X"));
            }
        }
        Ok(())
    }
}

impl Terms {
    /// Reads `5` or `3x3`.
    ///
    /// # Errors
    /// [`Code::UnknownSetting`] for text of another form.
    pub fn read(text: &str) -> Result<Terms, Diagnostic> {
        let count = |part: &str| {
            part.trim().parse::<usize>().map_err(|_| {
                let message = format!("`{text}` is not a number of terms");
                Diagnostic::new(Code::UnknownSetting, message)
                    .hint("write a whole number, or `M x N` for methods with two")
            })
        };
        match text.split_once('x') {
            Some((first, second)) => Ok(Terms { first: count(first)?, second: Some(count(second)?) }),
            None => Ok(Terms { first: count(text)?, second: None }),
        }
    }
}
