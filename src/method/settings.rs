//! Settings of methods: from a `solve` statement, an option, or Rust.

use crate::diagnostic::{Code, Diagnostic, Span};
use crate::numeric::NodeKind;
use crate::problem::RequestedSetting;

/// Settings a user may give; methods have defaults for what is not given.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Settings {
    /// The number of trial functions.
    pub terms: Option<(usize, Option<Span>)>,
    /// The collocation grid.
    pub points: Option<(Size, Option<Span>)>,
    /// The tolerance of adaptive methods.
    pub tolerance: Option<(f64, Option<Span>)>,
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
                .hint("write `11 x 11`, or `11 x 11 : ends`; the kinds are midpoints, ends and gauss")
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
    /// These settings, and those of `other` where there are none.
    #[must_use]
    pub fn over(self, other: Settings) -> Settings {
        Settings {
            terms: self.terms.or(other.terms),
            points: self.points.or(other.points),
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

    /// Sets one setting from text, for example `points` from `11x11:ends`.
    ///
    /// # Errors
    /// [`Code::UnknownSetting`].
    pub fn set(&mut self, key: &str, value: &str, origin: Option<Span>) -> Result<(), Diagnostic> {
        match key {
            "terms" => self.terms = Some((read_count(value).map_err(|finding| finding.at(origin))?, origin)),
            "points" => self.points = Some((Size::read(value).map_err(|finding| finding.at(origin))?, origin)),
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
                    .hint("settings: terms = K, points = L x M [: midpoints | ends | gauss], tolerance = X"));
            }
        }
        Ok(())
    }
}

fn read_count(text: &str) -> Result<usize, Diagnostic> {
    text.parse().map_err(|_| {
        Diagnostic::new(Code::UnknownSetting, format!("`{text}` is not a number of terms")).hint("write a whole number")
    })
}
