// A patch S(u, v, t) = Σ_j F_j(v, t) G_j(u), as tables that the shader adds up.
//
// The F_j with their derivatives in v are worked out for every column of the grid, the G_j with theirs in u for every
// row, both in double precision. What is left for each vertex is a sum over j, which the graphics processor takes once
// for every new table.

import * as THREE from "three";
import { Patch } from "./patch.js";
import { run } from "./program.js";
import { between, derivative, values } from "./series.js";
import { summing } from "./shading.js";

export class Separable extends Patch {
  constructor(uniforms) {
    super(uniforms);
    this.sum = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), summing());
    this.sum.frustumCulled = false;
    this.eye = new THREE.Camera();
  }

  // New numbers from the server; `motion` interpolates over time where the solution holds at one instant.
  set(data, cells, time) {
    super.set(data, cells);
    this.motion = null;
    const { range, coefficients } = data.form.amplitudes;
    this.series = { range, rows: coefficients };
    this.seriesTime = data.time;
    this.fillAmplitudes();
    this.setTime(this.knows(time) ? time : data.time);
  }

  // Whether the surface at t can be drawn without the server.
  knows(t) {
    return this.knowsAllTimes || t === this.seriesTime;
  }

  get knowsAllTimes() {
    return !this.data.form.is_instant || this.motion !== null;
  }

  setTime(t) {
    if (this.data.form.is_instant && t !== this.seriesTime && this.motion) {
      this.series = between(this.series.range, this.motion, t);
      this.seriesTime = t;
      this.fillAmplitudes();
    }
    this.time = t;
    this.fillBasis();
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
    const orders = [this.series, derivative(this.series)];
    orders.push(derivative(orders[1]));
    const width = this.u.length, count = this.data.form.count;
    const table = new Float32Array(4 * width * 3 * count);
    orders.forEach((series, order) => this.u.forEach((u, i) => {
      const g = values(series, u);
      for (let j = 0; j < count; j++) {
        const at = 4 * ((order * count + j) * width + i);
        for (let k = 0; k < 3; k++) table[at + k] = g[3 * j + k];
      }
    }));
    this.texture("amplitudes", table, width, 3 * count);
    this.sum.material.uniforms.count.value = count;
  }

  fillBasis() {
    const { symbols, form: { basis, count } } = this.data;
    const rows = run(basis, symbols, this.v, this.time);
    const width = this.v.length;
    const table = new Float32Array(4 * width * count);
    rows.forEach((row, output) => {
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

  // Positions on all u and v at the patch's time, in double precision: rows of [x, y, z].
  points(us, vs) {
    const basis = run(this.data.form.basis, this.data.symbols, Float64Array.from(vs), this.time);
    return Array.from(us, (u) => {
      const g = values(this.series, u);
      return Array.from(vs, (_, column) => [0, 1, 2].map((k) => {
        let sum = 0;
        for (let j = 0; j < this.data.form.count; j++) sum += g[3 * j + k] * basis[j][column];
        return sum;
      }));
    });
  }

  // The position of a vertex as it is drawn.
  vertex(renderer, i, j) {
    this.prepare(renderer);
    const values = new Float32Array(4);
    renderer.readRenderTargetPixels(this.target, j, i, 1, 1, values);
    return Array.from(values.subarray(0, 3));
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
