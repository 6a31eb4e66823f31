// The picture: camera, patches, trimlines, edges and tangent arrows. Drawn when something changed, not all the time.

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { Net } from "./net.js";
import { Primary } from "./primary.js";
import { evenly } from "./program.js";
import { Sampled } from "./sampled.js";
import { Separable } from "./separable.js";
import { SHADES, sharedUniforms } from "./shading.js";

const ARROWS = 24;
const CLASSES = { separable: Separable, net: Net, sampled: Sampled };
// Colours on light paper and on dark.
const COLORS = { trimlines: [0xc8102e, 0xff5a6e], edges: [0x30343c, 0xaab2c0], arrows: [0x1f8a4c, 0x4cc98a] };
const PAPER = [0xffffff, 0x15171b];
// In pixels.
const WIDTHS = { trimlines: 2.5, edges: 1.5, arrows: 1.5 };
// Of the size of the patches, with the arrows that stick out.
const ROOM = 1.2;

export class Stage {
  constructor(canvas, onCamera) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(35, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => { this.invalidate(); onCamera(); });
    this.shared = sharedUniforms();
    // Light from beside the viewer, for the primary surfaces; patches are lit by their own shader.
    const lamp = new THREE.DirectionalLight(0xffffff, 1.6);
    lamp.position.set(0.3, 0.5, 0.9);
    this.camera.add(lamp);
    this.scene.add(this.camera, new THREE.HemisphereLight(0xffffff, 0xb0b0b0, 1.4));
    this.patches = [];
    this.primaries = [];
    this.curves = new THREE.Group();
    this.scene.add(this.curves);
    this.pens = Object.fromEntries(Object.entries(WIDTHS).map(([name, linewidth]) => [name, new LineMaterial({ linewidth })]));
    this.layers = { surfaces: true, trimlines: true, edges: true, arrows: true };
    this.isPlaced = false;
    this.frames = 0;
    this.afterFrame = [];
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.paper());
    this.paper();
    this.resize();
  }

  paper() {
    const shade = Number(matchMedia("(prefers-color-scheme: dark)").matches);
    this.scene.background = new THREE.Color(PAPER[shade]);
    for (const [name, pen] of Object.entries(this.pens)) pen.color.set(COLORS[name][shade]);
    this.invalidate();
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / Math.max(clientHeight, 1);
    this.camera.updateProjectionMatrix();
    this.invalidate();
  }

  invalidate() {
    if (this.pending) return;
    this.pending = requestAnimationFrame(() => { this.pending = 0; this.render(); });
  }

  render() {
    for (const patch of this.patches) patch.prepare(this.renderer);
    this.renderer.render(this.scene, this.camera);
    this.frames += 1;
    this.afterFrame.splice(0).forEach((report) => report());
  }

  // As many drawn things as there are data, each of the class that its data want.
  match(drawn, data, classOf) {
    const drop = (gone) => { this.scene.remove(gone.mesh); gone.dispose(); };
    drawn.splice(data.length).forEach(drop);
    data.forEach((it, index) => {
      const wanted = classOf(it);
      if (drawn[index] instanceof wanted) return;
      if (drawn[index]) drop(drawn[index]);
      drawn[index] = new wanted(this.shared);
      this.scene.add(drawn[index].mesh);
    });
  }

  // New numbers for all patches and primary surfaces; `samples` has the vertices of each patch that needs them.
  show(data, surfaces, cells, time, samples) {
    this.match(this.patches, data, ({ form }) => CLASSES[form.kind]);
    this.match(this.primaries, surfaces, () => Primary);
    data.forEach((patch, index) => this.patches[index].set(patch, cells, time, samples.get(index)));
    this.surfaces = surfaces;
    this.time = time;
    if (!this.isPlaced) this.placeCamera();
    this.redrawGiven();
  }

  setTime(time, samples = new Map()) {
    this.patches.forEach((patch, index) => patch.setTime(time, samples.get(index)));
    this.time = time;
    this.redrawGiven();
  }

  // A sphere around a few points of every patch: what the picture has to hold.
  bounds() {
    const points = this.patches.flatMap((patch) => {
      const [u, v] = patch.data.domain;
      return patch.points(evenly(u, 8), evenly(v, 16)).flat().map((point) => new THREE.Vector3(...point));
    });
    return new THREE.Sphere().setFromPoints(points);
  }

  placeCamera() {
    const { center, radius } = this.bounds();
    this.radius = radius || 1;
    this.shared.size.value = this.radius;
    this.camera.near = this.radius / 100;
    this.camera.far = this.radius * 100;
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(center);
    const upright = THREE.MathUtils.degToRad(this.camera.fov / 2);
    const narrower = Math.min(upright, Math.atan(Math.tan(upright) * this.camera.aspect));
    this.camera.position.set(0.9, -1.6, 0.9).normalize().multiplyScalar((ROOM * this.radius) / Math.sin(narrower)).add(center);
    this.controls.update();
    this.isPlaced = this.patches.length > 0;
  }

  // Position and target, for the address.
  get view() {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()].map((x) => Number(x.toPrecision(5)));
  }

  set view(numbers) {
    this.camera.position.fromArray(numbers, 0);
    this.controls.target.fromArray(numbers, 3);
    this.controls.update();
  }

  // What the spec states, beside what was solved for.
  redrawGiven() {
    this.primaries.forEach((primary, index) => {
      if (this.layers.surfaces) primary.set(this.surfaces[index], this.time);
      primary.mesh.visible = this.layers.surfaces && primary.isFinite;
    });
    this.redrawCurves();
  }

  redrawCurves() {
    for (const old of this.curves.children) old.geometry.dispose();
    this.curves.clear();
    for (const patch of this.patches) {
      const lines = patch.prescribed(0);
      if (this.layers.trimlines) lines.forEach(({ values }) => this.line(values, this.pens.trimlines));
      // Sides without constraints: those of constant v, and of a net all four.
      if (this.layers.edges && lines.every(({ across }) => across === "u")) {
        const edges = patch.points(patch.u, patch.data.domain[1]);
        [0, 1].forEach((end) => this.line(edges.map((row) => row[end]), this.pens.edges));
        if (lines.length === 0) patch.points(patch.data.domain[0], patch.v).forEach((row) => this.line(row, this.pens.edges));
      }
      if (this.layers.edges) patch.data.regions.forEach((region) => this.line(patch.border(region), this.pens.edges));
      if (this.layers.arrows) this.arrows(patch);
    }
    this.invalidate();
  }

  line(points, pen) {
    this.curves.add(new Line2(new LineGeometry().setPositions(points.flat()), pen));
  }

  // Prescribed tangents, the longest a fifth of the surface.
  arrows(patch) {
    const [u, v] = patch.data.domain.map((range) => evenly(range, ARROWS));
    const tangents = patch.prescribed(1, { u, v });
    const longest = Math.max(...tangents.flatMap(({ values }) => values.map((vector) => Math.hypot(...vector))), 0);
    if (longest === 0) return;
    const points = [];
    for (const tangent of tangents) {
      const feet = patch.line(tangent);
      tangent.values.forEach((vector, i) => {
        const foot = new THREE.Vector3(...feet[i]);
        const tip = new THREE.Vector3(...vector).multiplyScalar((0.2 * this.radius) / longest).add(foot);
        const along = new THREE.Vector3().subVectors(tip, foot);
        // Barbs lie flat, or for an upright arrow in a plane of their own.
        const isUpright = Math.hypot(along.x, along.y) < 1e-3 * Math.abs(along.z);
        const side = along.cross(isUpright ? new THREE.Vector3(1, 0, 0) : this.camera.up).normalize();
        const barb = (sign) => tip.clone().lerp(foot, 0.25).addScaledVector(side, sign * 0.15 * tip.distanceTo(foot));
        points.push(...[foot, tip, tip, barb(1), tip, barb(-1)].flatMap((point) => point.toArray()));
      });
    }
    this.curves.add(new LineSegments2(new LineSegmentsGeometry().setPositions(points), this.pens.arrows));
  }

  set shade(name) {
    this.shared.mode.value = Math.max(SHADES.indexOf(name), 0);
    this.invalidate();
  }

  set lines(on) {
    this.shared.lines.value = on;
    this.invalidate();
  }

  // The position of a vertex as it is drawn.
  vertex(i, j, index) {
    return this.patches[index].vertex(this.renderer, i, j);
  }

  // How many pixels differ from the background, and a number that differs between pictures.
  pixels() {
    this.render();
    const gl = this.renderer.getContext();
    const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
    const bytes = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    let drawn = 0, hash = 0;
    for (let at = 0; at < bytes.length; at += 4) {
      const pixel = (bytes[at] << 16) | (bytes[at + 1] << 8) | bytes[at + 2];
      const corner = (bytes[0] << 16) | (bytes[1] << 8) | bytes[2];
      if (pixel !== corner) drawn += 1;
      hash = (Math.imul(hash, 31) + pixel) | 0;
    }
    return { drawn, hash, width, height };
  }

  screenshot() {
    this.render();
    return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
  }
}
