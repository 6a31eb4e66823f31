//! The table of diagnostic codes: one row decides a code's text, severity and class.

use std::fmt;

/// Whether work can go on after a finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Good to know.
    Note,
    /// The result stands but deserves a look.
    Warning,
    /// There is no result.
    Error,
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        })
    }
}

/// Who can mend a finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// The document or an option: write it differently.
    Source,
    /// The chosen method cannot treat this problem: choose another.
    Unsupported,
    /// The problem as stated has no reliable numerical answer.
    Numerical,
    /// A bound of [`Limits`](crate::limits::Limits) was reached.
    Limit,
    /// The machine lacks something; the work goes on another way.
    Host,
    /// Writing the result failed.
    Output,
}

macro_rules! codes {
    ($($name:ident = $text:literal, $severity:ident, $class:ident, $doc:literal;)*) => {
        /// A stable code. Users search for it, tests assert it; it never changes its meaning.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum Code { $(#[doc = $doc] $name,)* }

        impl Code {
            /// Every code, in order.
            pub const ALL: &[Code] = &[$(Code::$name,)*];

            /// The code as written, for example `E0201`.
            #[must_use]
            pub fn as_str(self) -> &'static str {
                match self { $(Code::$name => $text,)* }
            }

            /// Whether work can go on.
            #[must_use]
            pub fn severity(self) -> Severity {
                match self { $(Code::$name => Severity::$severity,)* }
            }

            /// Who can mend it.
            #[must_use]
            pub fn class(self) -> Class {
                match self { $(Code::$name => Class::$class,)* }
            }

            /// What it means, in one line.
            #[must_use]
            pub fn summary(self) -> &'static str {
                match self { $(Code::$name => $doc,)* }
            }
        }
    };
}

codes! {
    NotUtf8 = "E0101", Error, Source, "The text is not UTF-8.";
    UnexpectedText = "E0102", Error, Source, "The text does not continue as the grammar allows.";
    UnbalancedBracket = "E0103", Error, Source, "A bracket is not closed, or closed by another kind.";
    AmbiguousExpression = "E0104", Error, Source, "An expression has two plausible readings.";
    EmptyDocument = "E0105", Error, Source, "The document states nothing.";
    NumberOutOfRange = "E0106", Error, Source, "A number is too large to be represented.";
    DeceptiveCharacter = "E0107", Error, Source, "A character cannot be seen, or looks like another one.";
    UnsupportedLatex = "E0108", Error, Source, "A piece of LaTeX is not read.";
    NotFormatted = "E0109", Error, Unsupported, "The text cannot be laid out without changing its meaning.";
    UnknownName = "E0201", Error, Source, "A name is not declared.";
    DuplicateName = "E0202", Error, Source, "A name is declared twice, or reserved.";
    NotBoundaryData = "E0203", Error, Source, "Boundary data depend on u, or on S.";
    DuplicateConstraint = "E0204", Error, Source, "A constraint is stated twice.";
    MissingConstraint = "E0205", Error, Source, "A constraint is missing for one component.";
    WrongConstraintCount = "E0206", Error, Source, "The number of constraints does not fit the order of the equation in u.";
    NotLinear = "E0207", Error, Source, "The equation is not linear in S.";
    WrongArity = "E0208", Error, Source, "A function has the wrong number of arguments.";
    NotScalar = "E0209", Error, Source, "A vector stands where a number is expected, or the other way round.";
    DuplicateStatement = "E0210", Error, Source, "A statement that may occur once occurs twice.";
    NotConstant = "E0211", Error, Source, "A value that must be constant depends on u, v, t or S.";
    UnknownSetting = "E0212", Error, Source, "A setting does not exist or has a value of the wrong form.";
    EmptyDomain = "E0213", Error, Source, "A domain has no extent, or too little of it.";
    ParameterNotFinite = "E0214", Error, Source, "A parameter or constant evaluates to infinity or NaN.";
    ParameterOutOfRange = "E0215", Error, Source, "A parameter lies outside its own range.";
    DependentConstraints = "E0216", Error, Source, "The constraints do not determine a surface.";
    MissingEquationTerm = "E0217", Error, Source, "The equation has no derivative in u.";
    UnusedDeclaration = "W0218", Warning, Source, "A declaration is not used.";
    DegenerateBoundary = "W0219", Warning, Source, "A trimline is a point, or a tangent has no length.";
    PeriodMissed = "W0221", Warning, Source, "A domain almost ends where its boundary data repeat.";
    ShapesDiffer = "E0220", Error, Source, "Two shapes do not correspond, so that there is none between them.";
    DataFileMissing = "E0221", Error, Source, "A data file cannot be read.";
    BadDataFile = "E0222", Error, Source, "A data file does not hold what it should.";
    NotDifferentiable = "E0301", Error, Source, "A derivative is needed of a function that has none.";
    DataNotFinite = "E0302", Error, Source, "A function of the problem is not finite inside the domain.";
    PointOutsideDomain = "E0303", Error, Source, "A point or an instant lies outside the domain.";
    BadPoints = "E0304", Error, Source, "A table of points cannot be read.";
    SettingOutOfRange = "E0401", Error, Source, "A setting has a value outside its range.";
    UnsupportedByMethod = "E0402", Error, Unsupported, "The chosen method cannot treat this problem.";
    VanishesOnGrid = "E0403", Error, Numerical, "A basis function is zero on every collocation point.";
    SolutionNotFinite = "E0404", Error, Numerical, "The solution is not finite.";
    RankDeficient = "W0405", Warning, Numerical, "Collocation left some coefficients undetermined.";
    Amplified = "N0406", Note, Numerical, "The equation amplifies its data.";
    NearlyResonant = "W0407", Warning, Numerical, "The equation is close to resonance.";
    Resonant = "E0408", Error, Numerical, "The equation is resonant.";
    OrderDrops = "E0409", Error, Numerical, "The highest derivative in u drops out of the equation.";
    MethodPassedOver = "N0410", Note, Unsupported, "A better method cannot treat this problem.";
    SeamOpens = "W0411", Warning, Numerical, "The boundary closes in v, and the surface between does not.";
    SolutionNotUnique = "W0412", Warning, Numerical, "The equation has other solutions with the same boundary.";
    PromiseBroken = "E0413", Error, Numerical, "A solution is not what its method promises.";
    SeriesTruncated = "W0414", Warning, Numerical, "A Fourier series leaves out part of the boundary data or of the force.";
    PositionsAmplify = "W0415", Warning, Numerical, "Positions inside the blend amplify high wave numbers.";
    LargeResidual = "W0417", Warning, Numerical, "The surface that `auto` found does not solve its equation.";
    LayersTooThin = "E0418", Error, Numerical, "The solution has layers too thin to be resolved.";
    EndsDominate = "W0419", Warning, Numerical, "What does not close in v makes the surface far larger than its data.";
    SeamApart = "E0416", Error, Source, "Patches do not meet where a seam is stated.";
    KnotsNotAscending = "E0601", Error, Source, "A knot vector is not one.";
    KnotRepeated = "E0602", Error, Source, "A knot inside a net is repeated.";
    NetSize = "E0603", Error, Source, "A net has the wrong number of points.";
    PointNotFinite = "E0604", Error, Source, "A control point is not finite.";
    CurvesDoNotMeet = "E0605", Error, Source, "Boundary curves of a net do not fit together.";
    NetAmplifies = "W0606", Warning, Numerical, "A net magnifies what its boundary layers hold.";
    SeamCreased = "W0607", Warning, Numerical, "Patches meet in a crease.";
    ToleranceNotReached = "E0608", Error, Numerical, "A B-spline does not come as close to a surface as asked.";
    BadSplineFile = "E0609", Error, Source, "A file of B-splines cannot be read.";
    LayersDisagree = "E0610", Error, Source, "Boundary layers of a net give one control point two places.";
    NoArea = "E0611", Error, Source, "A surface has no area.";
    EdgesNearlyMeet = "N0612", Note, Source, "An imported surface closes but for a small gap.";
    SidesDisagree = "E0701", Error, Source, "The sides of a patch do not fit together in a corner.";
    TwistsDisagree = "N0702", Note, Source, "The sides of a patch have different twists in a corner.";
    NotElliptic = "W0703", Warning, Numerical, "The equation is not elliptic, and data stand on all four sides.";
    TermsTooFew = "W0704", Warning, Numerical, "A series has not settled.";
    RegionDoesNotFit = "E0705", Error, Source, "A deformation does not fit its patch.";
    EdgeCount = "E0706", Error, Source, "A loop has too few or too many edges.";
    LoopOpen = "E0707", Error, Source, "A loop of edges does not close.";
    ApexNotSmooth = "W0708", Warning, Source, "A patch is not smooth at its apex.";
    NotSeparable = "E0709", Error, Unsupported, "A surface is not a sum of products.";
    EdgeSidesDiffer = "E0711", Error, Source, "The two sides of a shared edge differ.";
    CopyOntoItself = "E0712", Error, Source, "A copy of a patch lies where the patch does.";
    ShapeLost = "E0713", Error, Source, "Rounding leaves too little of a shape.";
    LoopFolded = "E0714", Error, Source, "A loop of edges folds back on itself.";
    SeamWithoutEdge = "E0715", Error, Source, "A seam does not join two edges.";
    PatchFolded = "W0716", Warning, Source, "A patch folds back over itself.";
    LimitReached = "E0901", Error, Limit, "A limit was reached.";
    HostUnsupported = "N0902", Note, Host, "The machine lacks something; the work goes on another way.";
    OutputFailed = "E0903", Error, Output, "Writing a result failed.";
    FormatCannotHold = "E0904", Error, Unsupported, "A format cannot hold the result.";
    DegenerateNormals = "W0501", Warning, Numerical, "Some vertices have no normal.";
    PrecisionLost = "W0502", Warning, Output, "A format cannot hold the result to full precision.";
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}
