//! Turns surfaces into meshes: a regular grid over (u, v) becomes vertices with normals, and quads.
//!
//! Input: any [`Surface`](crate::surface::Surface), its parameter ranges, an instant and a [`Grid`];
//! output: a [`Mesh`], and a [`Scene`] is the meshes of one instant. [`curvatures`] adds fields to a mesh.
//!
//! Invariants of every mesh made here: all numbers are finite, all indices are in range, every normal has unit
//! length, each quad runs counter-clockwise seen from the side that `S_u x S_v` points to, and where the surface
//! closes in v both sides of the seam are the same vertices.
//!
//! Absent on purpose: adaptive refinement (equal documents must give equal topology at every instant, so that
//! frames can be blended), merging of seams between different patches, and triangles (a format that needs them
//! splits the quads itself).

mod curvature;
mod grid;
mod instants;
mod mesh;
mod normals;
mod patch;
mod samples;

pub use curvature::curvatures;
pub use grid::Grid;
pub use instants::instants;
pub use mesh::{Field, Mesh, Role, Scene};
pub use patch::tessellate;
