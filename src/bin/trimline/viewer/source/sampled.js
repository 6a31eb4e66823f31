// A patch whose vertices come from the server, for one instant.

import * as THREE from "three";
import { Patch } from "./patch.js";

export class Sampled extends Patch {
  // `samples`: (position, Gaussian curvature) of every vertex, then (normal, mean curvature).
  set(data, cells, time, samples) {
    super.set(data, cells);
    this.setTime(time, samples);
  }

  knows(t) {
    return t === this.time;
  }

  get knowsAllTimes() {
    return false;
  }

  setTime(t, samples) {
    super.setTime(t);
    if (!samples) return;
    this.samples = samples;
    const { points, normals } = this.material.uniforms;
    const half = samples.length / 2;
    [points, normals].forEach((uniform, index) => {
      uniform.value?.dispose();
      const table = samples.subarray(index * half, (index + 1) * half);
      uniform.value = new THREE.DataTexture(table, this.v.length, this.u.length, THREE.RGBAFormat, THREE.FloatType);
      uniform.value.needsUpdate = true;
    });
  }

  prepare() {}

  // Between the vertices along straight lines.
  pointsBeforePlacing(us, vs) {
    const place = (nodes, x) => {
      const last = nodes.length - 1;
      const at = Math.min(Math.max(((x - nodes[0]) / (nodes[last] - nodes[0])) * last, 0), last);
      const from = Math.min(Math.floor(at), last - 1);
      return [from, at - from];
    };
    const vertex = (i, j, k) => this.samples[4 * (i * this.v.length + j) + k];
    return Array.from(us, (u) => {
      const [i, a] = place(this.u, u);
      return Array.from(vs, (v) => {
        const [j, b] = place(this.v, v);
        return [0, 1, 2].map((k) => (1 - a) * ((1 - b) * vertex(i, j, k) + b * vertex(i, j + 1, k))
          + a * ((1 - b) * vertex(i + 1, j, k) + b * vertex(i + 1, j + 1, k)));
      });
    });
  }

  // The position of a vertex as it is drawn.
  vertex(_, i, j) {
    const at = 4 * (i * this.v.length + j);
    return this.place(Array.from(this.samples.subarray(at, at + 3)));
  }

  dispose() {
    super.dispose();
    this.material.uniforms.points.value?.dispose();
    this.material.uniforms.normals.value?.dispose();
  }
}
