// A patch S(u, v) = Σ_j F_j(v) G_j(u) at any instant, as tables that the shader adds up.
//
// The F_j with their derivatives in v are worked out for every column of the grid, the G_j with theirs in u for every
// row, both in double precision. What is left for each vertex is a sum over j, which the graphics processor takes once
// for every new table.
//
// A kind of sum says how many functions there are, `count`, and what they are: `amplitudes(u)` gives the x, y and z of every
// G_j, then their first derivatives and their second; `basis(v)` rows of values at all v, of every F_j, then of derivatives.

import * as THREE from "three";
import { Patch } from "./patch.js";
import { summing } from "./shading.js";

export class Tables extends Patch {
  constructor(uniforms) {
    super(uniforms);
    this.sum = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), summing());
    this.sum.frustumCulled = false;
    this.eye = new THREE.Camera();
  }

  layGrid(cells) {
    super.layGrid(cells);
    const [rows, columns] = cells.map((count) => count + 1);
    this.target?.dispose();
    this.target = new THREE.WebGLRenderTarget(columns, rows, {
      count: 2, type: THREE.FloatType, depthBuffer: false, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter,
    });
    const { points, normals } = this.material.uniforms;
    [points.value, normals.value] = this.target.textures;
  }

  // Adds up what is new, before the picture is drawn.
  prepare(renderer) {
    if (!this.isNew) return;
    this.isNew = false;
    renderer.setRenderTarget(this.target);
    renderer.render(this.sum, this.eye);
    renderer.setRenderTarget(null);
  }

  fillAmplitudes() {
    const { count } = this;
    const width = this.u.length;
    const table = new Float32Array(4 * width * 3 * count);
    this.u.forEach((u, i) => this.amplitudes(u).forEach((g, order) => {
      for (let j = 0; j < count; j++) {
        const at = 4 * ((order * count + j) * width + i);
        for (let k = 0; k < 3; k++) table[at + k] = g[3 * j + k];
      }
    }));
    this.texture("amplitudes", table, width, 3 * count);
    this.sum.material.uniforms.count.value = count;
  }

  fillBasis() {
    const { count } = this;
    const width = this.v.length;
    const table = new Float32Array(4 * width * count);
    this.basis(this.v).forEach((row, output) => {
      const j = output % count, order = Math.floor(output / count);
      for (let i = 0; i < width; i++) table[4 * (j * width + i) + order] = row[i];
    });
    this.texture("basis", table, width, count);
  }

  texture(name, table, width, height) {
    this.isNew = true;
    const uniform = this.sum.material.uniforms[name];
    const old = uniform.value;
    if (old && old.image.width === width && old.image.height === height) {
      old.image.data = table;
      old.needsUpdate = true;
      return;
    }
    old?.dispose();
    uniform.value = new THREE.DataTexture(table, width, height, THREE.RGBAFormat, THREE.FloatType);
    uniform.value.needsUpdate = true;
  }

  // Positions on all u and v in double precision, before the patch is placed: rows of [x, y, z].
  pointsBeforePlacing(us, vs) {
    const basis = this.basis(Float64Array.from(vs));
    return Array.from(us, (u) => {
      const [g] = this.amplitudes(u);
      return Array.from(vs, (_, column) => [0, 1, 2].map((k) => {
        let sum = 0;
        for (let j = 0; j < this.count; j++) sum += g[3 * j + k] * basis[j][column];
        return sum;
      }));
    });
  }

  // The position of a vertex as it is drawn.
  vertex(renderer, i, j) {
    this.prepare(renderer);
    const values = new Float32Array(4);
    renderer.readRenderTargetPixels(this.target, j, i, 1, 1, values);
    return this.place(Array.from(values.subarray(0, 3)));
  }

  dispose() {
    super.dispose();
    this.sum.geometry.dispose();
    this.sum.material.uniforms.amplitudes.value?.dispose();
    this.sum.material.uniforms.basis.value?.dispose();
    this.sum.material.dispose();
    this.target?.dispose();
  }
}
