//! Meshes as plain data.

/// The field of a surface that has a sign by the side of its normal.
pub const MEAN_CURVATURE: &str = "mean_curvature";

/// Quads over shared vertices; everything but `fields`, `quads` and `outlines` has one entry per vertex.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// What the document calls the patch.
    pub name: String,
    /// What it shows.
    pub role: Role,
    /// Vertices, u-major: entry `i * columns + j` lies at the i-th u and j-th v.
    pub positions: Vec<[f64; 3]>,
    /// Unit normals, along `S_u x S_v`.
    pub normals: Vec<[f64; 3]>,
    /// S_u.
    pub tangents_u: Vec<[f64; 3]>,
    /// S_v.
    pub tangents_v: Vec<[f64; 3]>,
    /// The patch's own parameters at each vertex. A welded seam has the parameter of its first side, so a
    /// texture mapped by `uv` runs backwards through the last strip of quads.
    pub uv: Vec<[f64; 2]>,
    /// Numbers at the vertices, such as curvature; all meshes of a scene have the same ones in the same order.
    pub fields: Vec<Field>,
    /// Vertices along v.
    pub columns: usize,
    /// Vertex indices of each quad, counter-clockwise seen from where the normals point.
    pub quads: Vec<[u32; 4]>,
    /// Whether the quads run around in v, the last column being joined to the first.
    pub is_closed_in_v: bool,
    /// The borders of what was added to parts of the surface, as closed lines of points, to be drawn.
    pub outlines: Vec<Vec<[f64; 3]>>,
}

/// What a mesh shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Role {
    /// A patch: what was computed.
    #[default]
    Blend,
    /// A surface that patches join: what was given.
    Primary,
}

/// A number at every vertex of a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// A word of letters and underscores, for example `mean_curvature`.
    pub name: &'static str,
    /// One value per vertex; NaN where there is none, such as the curvature at a pole.
    pub values: Vec<f64>,
}

/// What is to be seen at one instant.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scene {
    /// One mesh per patch, in document order.
    pub meshes: Vec<Mesh>,
    /// The instant, in the document's unit of `t`.
    pub time: f64,
}

impl Mesh {
    /// The mesh seen from its other side: normals turned round, quads run through backwards, and with them the sign of
    /// the mean curvature. A mirror image needs it to face as its original does.
    #[must_use]
    pub fn turned(mut self) -> Mesh {
        for normal in &mut self.normals {
            *normal = normal.map(|x| -x);
        }
        for [_, second, _, fourth] in &mut self.quads {
            std::mem::swap(second, fourth);
        }
        for field in self.fields.iter_mut().filter(|field| field.name == MEAN_CURVATURE) {
            for value in &mut field.values {
                *value = -*value;
            }
        }
        self
    }

    /// The values of u at the rows of vertices and of v at their columns.
    #[must_use]
    pub fn axes(&self) -> (Vec<f64>, Vec<f64>) {
        let rows = self.uv.chunks(self.columns.max(1));
        let u = rows.clone().filter_map(|row| row.first()).map(|[u, _]| *u).collect();
        let v = rows.take(1).flatten().map(|[_, v]| *v).collect();
        (u, v)
    }
}
