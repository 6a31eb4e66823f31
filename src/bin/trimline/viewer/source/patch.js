// One patch: S(u, v, t) = Σ_j F_j(v, t) G_j(u), as tables that the shader adds up.
//
// The F_j with their derivatives in v are worked out for every column of the grid, the G_j with theirs in u for every
// row, both in double precision. What is left for each vertex is a sum over j, which the graphics processor takes once
// for every new table.

import * as THREE from "three";
import { evenly, run } from "./program.js";
import { between, derivative, values } from "./series.js";
import { drawing, summing } from "./shading.js";

export class Patch {
  constructor(uniforms) {
    this.material = drawing(uniforms);
    this.sum = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), summing());
    this.sum.frustumCulled = false;
    this.eye = new THREE.Camera();
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.cells = null;
  }

  // New numbers from the server; `motion` interpolates over time where the solution holds at one instant.
  set(data, cells, time) {
    this.data = data;
    this.motion = null;
    const { range, coefficients } = data.amplitudes;
    this.series = { range, rows: coefficients };
    this.seriesTime = data.time;
    if (String(cells) !== String(this.cells)) this.layGrid(cells);
    this.u = evenly(data.domain[0], cells[0]);
    this.v = evenly(data.domain[1], cells[1]);
    this.fillAmplitudes();
    this.setTime(this.knows(time) ? time : data.time);
  }

  // Whether the surface at t can be drawn without the server.
  knows(t) {
    return !this.data.is_instant || this.motion !== null || t === this.seriesTime;
  }

  setTime(t) {
    if (this.data.is_instant && t !== this.seriesTime && this.motion) {
      this.series = between(this.data.amplitudes.range, this.motion, t);
      this.seriesTime = t;
      this.fillAmplitudes();
    }
    this.time = t;
    this.fillBasis();
  }

  layGrid([nu, nv]) {
    this.cells = [nu, nv];
    const rows = nu + 1, columns = nv + 1;
    const nodes = new Float32Array(2 * rows * columns);
    for (let i = 0, k = 0; i < rows; i++) for (let j = 0; j < columns; j++) { nodes[k++] = i; nodes[k++] = j; }
    const quads = new Uint32Array(6 * nu * nv);
    for (let i = 0, k = 0; i < nu; i++) {
      for (let j = 0; j < nv; j++, k += 6) {
        const a = i * columns + j, b = a + columns;
        quads.set([a, b, b + 1, a, b + 1, a + 1], k);
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setIndex(new THREE.BufferAttribute(quads, 1));
    // The shader finds a vertex's place by its node; positions do not exist outside it.
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(rows * columns * 3), 3));
    geometry.setAttribute("node", new THREE.BufferAttribute(nodes, 2));
    geometry.setAttribute("scalar", new THREE.BufferAttribute(new Float32Array(rows * columns), 1));
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
    const { uniforms } = this.material;
    uniforms.cells.value.set(nu, nv);
    this.target?.dispose();
    this.target = new THREE.WebGLRenderTarget(columns, rows, {
      count: 2, type: THREE.FloatType, depthBuffer: false, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter,
    });
    [uniforms.points.value, uniforms.normals.value] = this.target.textures;
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
    const width = this.u.length, count = this.data.count;
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
    const { basis, symbols, count } = this.data;
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
    const basis = run(this.data.basis, this.data.symbols, Float64Array.from(vs), this.time);
    return Array.from(us, (u) => {
      const g = values(this.series, u);
      return Array.from(vs, (_, column) => [0, 1, 2].map((k) => {
        let sum = 0;
        for (let j = 0; j < this.data.count; j++) sum += g[3 * j + k] * basis[j][column];
        return sum;
      }));
    });
  }

  // What each boundary condition prescribes at all v: rows of [x, y, z] by condition.
  prescribed(vs) {
    const rows = run(this.data.boundary, this.data.symbols, Float64Array.from(vs), this.time);
    return this.data.conditions.map((condition, index) => ({
      ...condition,
      values: Array.from(vs, (_, i) => [0, 1, 2].map((k) => rows[3 * index + k][i])),
    }));
  }

  // How far the surface is from each prescribed position, by v, and from itself at the two ends of v, by u.
  gaps() {
    const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    const positions = this.prescribed(this.v).filter(({ order }) => order === 0);
    const boundary = positions.map(({ u, values: stated }) => {
      const [row] = this.points([u], this.v);
      return { u, values: row.map((point, i) => distance(point, stated[i])) };
    });
    const seam = this.points(this.u, this.data.domain[1]).map(([first, last]) => distance(first, last));
    return { boundary, seam };
  }

  // Scalars for colouring, by vertex: `of(i, j)`.
  setScalars(of) {
    const attribute = this.mesh.geometry.getAttribute("scalar");
    const columns = this.v.length;
    attribute.array.forEach((_, at) => { attribute.array[at] = of(Math.floor(at / columns), at % columns); });
    attribute.needsUpdate = true;
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.sum.geometry.dispose();
    this.sum.material.uniforms.amplitudes.value?.dispose();
    this.sum.material.uniforms.basis.value?.dispose();
    this.sum.material.dispose();
    this.target?.dispose();
    this.material.dispose();
  }
}
