// One primary surface of the spec, drawn so that the patches can be seen through it.

import * as THREE from "three";
import { evenly, run } from "./program.js";

const CELLS = [48, 96];
const COLOR = 0x9a86c9;

export class Primary {
  constructor() {
    const [nu, nv] = CELLS;
    const columns = nv + 1;
    const quads = [];
    for (let i = 0; i < nu; i++) {
      for (let j = 0; j < nv; j++) {
        const a = i * columns + j, b = a + columns;
        quads.push(a, b, b + 1, a, b + 1, a + 1);
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setIndex(quads);
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * (nu + 1) * columns), 3));
    const material = new THREE.MeshLambertMaterial({ color: COLOR, side: THREE.DoubleSide, transparent: true, opacity: 0.5, depthWrite: false });
    this.mesh = new THREE.Mesh(geometry, material);
    this.mesh.frustumCulled = false;
  }

  // Draws it at t; where it is not finite it is not drawn at all.
  set({ ranges, position, symbols }, t) {
    const [us, vs] = ranges.map((range, axis) => evenly(range, CELLS[axis]));
    const u = Float64Array.from({ length: us.length * vs.length }, (_, k) => us[Math.floor(k / vs.length)]);
    const v = Float64Array.from(u, (_, k) => vs[k % vs.length]);
    const rows = run(position, symbols, v, t, u);
    const attribute = this.mesh.geometry.getAttribute("position");
    rows.forEach((row, component) => row.forEach((x, k) => { attribute.array[3 * k + component] = x; }));
    attribute.needsUpdate = true;
    this.isFinite = attribute.array.every(Number.isFinite);
    if (this.isFinite) this.mesh.geometry.computeVertexNormals();
  }

  // The vertex of row i and column j, as it is drawn.
  vertex(i, j) {
    const at = 3 * (i * (CELLS[1] + 1) + j);
    return Array.from(this.mesh.geometry.getAttribute("position").array.subarray(at, at + 3));
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
