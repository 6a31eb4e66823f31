// What all patches share: the grid that is drawn, what the spec prescribes, and numbers for colouring.
//
// A kind of patch adds where vertices come from: `prepare` before a picture, `pointsBeforePlacing` for curves, `setTime`.
// All of a copy is that of its original, which the mesh's own matrix turns and moves, mirror images included.

import * as THREE from "three";
import { evenly, run } from "./program.js";
import { drawing } from "./shading.js";

// Of each side of a border.
const PIECES = 32;

export class Patch {
  constructor(uniforms) {
    this.material = drawing(uniforms);
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
    this.cells = null;
  }

  set(data, cells) {
    this.data = data;
    if (String(cells) !== String(this.cells)) this.layGrid(cells);
    this.u = evenly(data.domain[0], cells[0]);
    this.v = evenly(data.domain[1], cells[1]);
  }

  // The instant that is drawn, and where a copy is then.
  setTime(t) {
    this.time = t;
    const { placement, symbols } = this.data;
    const zero = Float64Array.of(0);
    const [a, b, c, d, e, f, g, h, i, x, y, z] = placement ? run(placement, symbols, zero, t).map(([entry]) => entry) : [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];
    this.mesh.matrix.set(a, b, c, x, d, e, f, y, g, h, i, z, 0, 0, 0, 1);
    this.mesh.matrixWorldNeedsUpdate = true;
  }

  place(point) {
    return this.data.placement ? new THREE.Vector3(...point).applyMatrix4(this.mesh.matrix).toArray() : point;
  }

  turn(vector) {
    return this.data.placement ? new THREE.Vector3(...vector).applyMatrix3(new THREE.Matrix3().setFromMatrix4(this.mesh.matrix)).toArray() : vector;
  }

  // Positions on all u and v: rows of [x, y, z].
  points(us, vs) {
    return this.pointsBeforePlacing(us, vs).map((row) => row.map((point) => this.place(point)));
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
  }

  // What the constraints of one order prescribe along the grid, or at these u and v: lines of [x, y, z].
  prescribed(order, { u = this.u, v = this.v } = {}) {
    return this.data.boundary.flatMap(({ across, conditions, program }) => {
      const isWanted = conditions.some((condition) => condition.order === order);
      if (!isWanted) return [];
      const along = across === "u" ? v : u;
      const rows = run(program, this.data.symbols, along, this.time, along);
      return conditions.map(({ at, order: found }, index) => ({
        across, at, along, order: found,
        values: Array.from(along, (_, i) => {
          const vector = [0, 1, 2].map((k) => rows[3 * index + k][i]);
          return found === 0 ? this.place(vector) : this.turn(vector);
        }),
      })).filter((line) => line.order === order);
    });
  }

  // Positions along the line of a constraint.
  line({ across, at, along }) {
    return across === "u" ? this.points([at], along)[0] : this.points(along, [at]).map(([point]) => point);
  }

  // Positions around a part of the domain, given by its ranges of u and v.
  border(region) {
    const rows = this.points(...region.map((range) => evenly(range, PIECES)));
    const [first, last] = [0, PIECES].map((end) => rows.map((row) => row[end]));
    return [...first, ...rows[PIECES], ...last.reverse(), ...rows[0].slice().reverse()];
  }

  // Numbers for colouring, by vertex: `of(i, j)`; below zero where there is none.
  setScalars(of) {
    const attribute = this.mesh.geometry.getAttribute("scalar");
    const columns = this.v.length;
    attribute.array.forEach((_, at) => { attribute.array[at] = of(Math.floor(at / columns), at % columns); });
    attribute.needsUpdate = true;
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.material.dispose();
  }
}
