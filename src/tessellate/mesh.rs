//! Meshes as plain data.

/// Quads over shared vertices; `positions`, `normals` and `uv` have one entry per vertex.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// What the document calls the patch.
    pub name: String,
    /// Vertices, u-major: with `columns` vertices along v, entry `i * columns + j` lies at the i-th u and j-th v.
    pub positions: Vec<[f64; 3]>,
    /// Unit normals, along `S_u x S_v`.
    pub normals: Vec<[f64; 3]>,
    /// The patch's own parameters at each vertex. A welded seam has the parameter of its first side, so a
    /// texture mapped by `uv` runs backwards through the last strip of quads.
    pub uv: Vec<[f64; 2]>,
    /// Vertex indices of each quad, counter-clockwise seen from where the normals point.
    pub quads: Vec<[u32; 4]>,
    /// Whether the quads run around in v, the last column being joined to the first.
    pub is_closed_in_v: bool,
}

/// What is to be seen at one instant.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scene {
    /// One mesh per patch, in document order.
    pub meshes: Vec<Mesh>,
    /// The instant, in the document's unit of `t`.
    pub time: f64,
}
