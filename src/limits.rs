//! Every bound the library respects, in one struct with finite defaults.
//!
//! Limits can be changed, not removed. Reaching one is a [`Diagnostic`](crate::diagnostic::Diagnostic) of
//! class [`Limit`](crate::diagnostic::Class::Limit) that names the field, its value and what was asked for.
//! They exist so that any text, however built, costs a bounded amount of memory and stack.

/// Upper bounds on what one document may ask for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of source text.
    pub source_bytes: usize,
    /// Bytes of one data file.
    pub file_bytes: usize,
    /// Points of one measured curve.
    pub curve_points: usize,
    /// Bracket and call nesting in the source text. Guards the parser's stack.
    pub nesting: usize,
    /// Names declared in one document.
    pub names: usize,
    /// Patches of one document.
    pub patches: usize,
    /// Deformations of one patch.
    pub deformations: usize,
    /// Distinct nodes of one expression graph and their operands.
    pub graph_nodes: usize,
    /// Bytes of one expression written as text.
    pub text_bytes: usize,
    /// Monomials one boundary expression may expand to.
    pub monomials: usize,
    /// Basis functions of one patch.
    pub basis_functions: usize,
    /// Functions of the closure of one patch's basis.
    pub closure: usize,
    /// Wave numbers of one Fourier series.
    pub modes: usize,
    /// Order of differentiation in each of u, v and t.
    pub derivative_order: usize,
    /// Unknowns of one linear system.
    pub unknowns: usize,
    /// Rows times columns of one linear system.
    pub system_entries: usize,
    /// Multiplications of the factorisations of one solution: rows times squared columns.
    pub operations: usize,
    /// Vertices of one mesh, or points of one evaluation.
    pub samples: usize,
    /// Instants of one sequence.
    pub frames: usize,
    /// Vertices of all frames of one animated file.
    pub animated_vertices: usize,
    /// Pixels of all pictures of one file.
    pub pixels: usize,
    /// Control points of one B-spline surface, or of one file of them.
    pub control_points: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            source_bytes: 1 << 20,
            file_bytes: 16 << 20,
            curve_points: 20_000,
            nesting: 128,
            names: 4096,
            patches: 256,
            deformations: 64,
            graph_nodes: 200_000,
            text_bytes: 1 << 20,
            monomials: 4096,
            basis_functions: 256,
            closure: 512,
            modes: 256,
            derivative_order: 8,
            unknowns: 20_000,
            system_entries: 200_000_000,
            operations: 4_000_000_000,
            samples: 4_000_000,
            frames: 10_000,
            animated_vertices: 16_000_000,
            pixels: 64_000_000,
            control_points: 1_000_000,
        }
    }
}

impl Limits {
    /// Every limit with the name it has on the command line (`--limits nesting=64`).
    pub fn named(&mut self) -> Vec<(&'static str, &mut usize)> {
        vec![
            ("source-bytes", &mut self.source_bytes),
            ("file-bytes", &mut self.file_bytes),
            ("curve-points", &mut self.curve_points),
            ("nesting", &mut self.nesting),
            ("names", &mut self.names),
            ("patches", &mut self.patches),
            ("deformations", &mut self.deformations),
            ("graph-nodes", &mut self.graph_nodes),
            ("text-bytes", &mut self.text_bytes),
            ("monomials", &mut self.monomials),
            ("basis-functions", &mut self.basis_functions),
            ("closure", &mut self.closure),
            ("modes", &mut self.modes),
            ("derivative-order", &mut self.derivative_order),
            ("unknowns", &mut self.unknowns),
            ("system-entries", &mut self.system_entries),
            ("operations", &mut self.operations),
            ("samples", &mut self.samples),
            ("frames", &mut self.frames),
            ("animated-vertices", &mut self.animated_vertices),
            ("pixels", &mut self.pixels),
            ("control-points", &mut self.control_points),
        ]
    }
}
