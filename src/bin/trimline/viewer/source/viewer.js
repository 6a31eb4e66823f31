// The view of one spec: asks the server for the surface, draws it, and follows the spec as it is edited.

import * as address from "./address.js";
import { ask, askVertices, keep, newestOnly, requests, save } from "./server.js";
import { buttons, byId, choices, showFindings, showLegend, showMathematics, showReport, showValues, toggles } from "./panel.js";
import { SHADES } from "./shading.js";
import { Stage } from "./stage.js";

const GRIDS = ["32x64", "64x128", "128x256", "256x512", "512x512"];
const LAYERS = ["surfaces", "trimlines", "edges", "arrows", "wireframe"];
// A turn of the clock takes as long, whatever the time domain.
const SECONDS = 5;

const start = address.read();
const state = {
  time: start.time,
  values: start.values,
  shade: SHADES.includes(start.shade) ? start.shade : SHADES[0],
  grid: GRIDS.includes(start.grid) ? start.grid : "128x256",
  off: start.off,
  lines: start.lines,
  camera: start.camera,
};
// What the page knows, for tests: they wait on these instead of on the clock.
const facts = { revision: 0, answers: 0, motions: 0, moves: 0, gaps: 0, drawnAt: 0, serverMilliseconds: 0, readingMilliseconds: 0, tableMilliseconds: 0, findings: [], errors: [] };

let scene = null;
let isPlaying = false;
const stage = new Stage(byId("canvas"), () => {
  if (!stage?.isPlaced) return;
  state.camera = stage.view;
  remember();
});
const remember = () => address.write(state);
const cells = () => state.grid.split("x").map(Number);
const question = () => ({ time: state.time, values: state.values });

const refresh = newestOnly(async () => {
  let answer;
  try {
    answer = await ask("/scene", question());
  } catch {
    byId("status").textContent = "the server has gone";
    return;
  }
  // A value for a name that the edited spec no longer has is given up.
  const lost = answer.findings.map(({ source }) => /^--set (.*)$/.exec(source)?.[1]).filter((name) => name in state.values);
  if (!answer.solved && lost.length && answer.revision !== facts.revision) {
    lost.forEach((name) => delete state.values[name]);
    facts.revision = answer.revision;
    refresh();
    return;
  }
  if (answer.solved) {
    const { solved } = answer;
    solved.sampled = solved.patches.flatMap(({ form }, index) => (form.kind === "sampled" ? [index] : []));
    const [from, to] = solved.times;
    if (state.time === null || !(state.time >= from && state.time <= to)) state.time = solved.time;
    const vertices = await verticesOf(solved, answer.revision, solved.time);
    // Of a text that was edited meanwhile: its own answer is on its way.
    if (!vertices) return;
    if (vertices.ok) solved.samples = vertices.samples;
    else Object.assign(answer, { solved: null, findings: vertices.findings });
  }
  take(answer);
});

const verticesOf = ({ sampled }, revision, time) =>
  askVertices({ time, values: state.values }, { patches: sampled, grid: state.grid, revision }).catch(() => null);

function take(answer) {
  const isNew = answer.revision !== facts.revision;
  facts.findings = answer.findings;
  facts.serverMilliseconds = answer.milliseconds;
  facts.readingMilliseconds = answer.reading_milliseconds;
  showFindings(answer.findings);
  byId("name").textContent = answer.name.split(/[\\/]/).at(-1);
  byId("name").title = answer.name;
  byId("status").textContent = answer.is_current && answer.solved ? "" : answer.solved || scene
    ? "the picture is that of the last text without errors" : "there is no surface yet";
  if (answer.solved) {
    const mathematics = JSON.stringify(answer.solved.patches.map(({ mathematics, functions }) => [mathematics, functions]));
    const isOther = scene?.mathematics !== mathematics;
    scene = { ...answer.solved, mathematics, revision: answer.revision };
    draw();
    showValues(scene.parameters, setValue);
    showReport(scene);
    if (isOther) showMathematics(scene.patches);
    if (isNew) buttons(byId("keep"), [...answer.formats.map((format) => [format, () => download(format)]), ["screenshot", screenshot]]);
    learnMotion();
  }
  stage.afterFrame.push(() => {
    facts.revision = answer.revision;
    facts.answers += 1;
    facts.drawnAt = performance.timeOrigin + performance.now();
  });
  stage.invalidate();
}

// The tables of all patches for the newest numbers.
function draw() {
  const [from, to] = scene.times;
  const began = performance.now();
  // Vertices hold at the instant they were asked for, and what is drawn is all of one instant.
  const time = scene.sampled.length ? scene.time : state.time;
  stage.show(scene.patches, scene.surfaces, cells(), time, scene.samples);
  facts.tableMilliseconds = performance.now() - began;
  if (start.camera) { stage.view = start.camera; start.camera = null; }
  Object.assign(byId("time"), { min: from, max: to });
  showTime();
  colour();
}

function showTime() {
  byId("time").value = state.time;
  byId("time-value").textContent = Number(state.time.toPrecision(4));
}

function setTime(time) {
  state.time = time;
  showTime();
  remember();
  if (!scene) return;
  // A solution of another instant, or only its vertices, or nothing has to be asked for.
  if (!scene.patches.every(({ form }, index) => form.kind === "sampled" || stage.patches[index].knows(time))) refresh();
  else if (scene.sampled.length) moveSampled();
  else move(time);
}

function move(time, samples) {
  const began = performance.now();
  stage.setTime(time, samples);
  facts.tableMilliseconds = performance.now() - began;
  facts.moves += 1;
  colour();
}

const moveSampled = newestOnly(async () => {
  const [asked, { time }] = [scene, state];
  const vertices = await verticesOf(asked, asked.revision, time);
  if (scene !== asked || !vertices) return;
  if (vertices.ok) {
    Object.assign(scene, { samples: vertices.samples, time });
    move(time, vertices.samples);
  } else showFindings(vertices.findings);
});

function setValue(name, value) {
  if (!String(value).trim()) delete state.values[name];
  else state.values[name] = String(value).trim();
  remember();
  refresh();
}

// Solutions of one instant: once the values rest, learn how they move, so that time needs no questions.
let rest = 0;
function learnMotion() {
  clearTimeout(rest);
  if (!scene.patches.some(({ form }) => form.is_instant)) { facts.motions += 1; return; }
  const asked = scene;
  rest = setTimeout(async () => {
    const answer = await ask("/motion", question()).catch(() => null);
    if (scene !== asked || !answer?.ok) return;
    answer.patches.forEach((motion, index) => { if (motion) stage.patches[index].motion = motion; });
    facts.motions += 1;
  }, 200);
}

function play(on) {
  isPlaying = on;
  byId("play").textContent = on ? "❚❚" : "▶";
  let before = performance.now();
  const step = (now) => {
    if (!isPlaying) return;
    const [from, to] = scene?.times ?? [0, 1];
    const next = state.time + ((to - from) * (now - before)) / (1000 * SECONDS);
    before = now;
    setTime(next > to ? from : next);
    requestAnimationFrame(step);
  };
  if (on) requestAnimationFrame(step);
}

// Why there is no colouring, where the surface itself can be drawn.
function refuse(answer) {
  stage.patches.forEach((patch) => patch.setScalars(() => -1));
  showLegend({ low: "", high: "", isRising: true, text: answer?.findings?.[0]?.message ?? "the server has gone" });
  stage.invalidate();
}

const fillResidual = newestOnly(async () => {
  const answer = await ask("/residual", question()).catch(() => null);
  if (state.shade !== "residual") return;
  if (!answer?.ok) { refuse(answer); return; }
  answer.patches.forEach((field, index) => {
    const patch = stage.patches[index];
    if (!patch) return;
    // A net has no residual.
    if (!field) { patch.setScalars(() => -1); return; }
    const { rows, columns, values } = field;
    const [nu, nv] = patch.cells;
    patch.setScalars((i, j) => {
      const [x, y] = [(i / nu) * (rows - 1), (j / nv) * (columns - 1)];
      const [a, b] = [Math.min(Math.floor(x), rows - 2), Math.min(Math.floor(y), columns - 2)];
      const at = (row, column) => values[row * columns + column];
      const along = (row) => at(row, b) * (1 - (y - b)) + at(row, b + 1) * (y - b);
      return along(a) * (1 - (x - a)) + along(a + 1) * (x - a);
    });
  });
  const fields = answer.patches.filter((field) => field);
  const largest = Math.max(...fields.flatMap(({ values }) => values));
  const text = fields.length ? `residual over the largest term, at most ${largest.toExponential(1)}` : "a B-spline net has no residual";
  showLegend({ low: "1e-16", high: "1", isRising: true, text });
  stage.invalidate();
});

// How wide the edges are coloured, of the patch.
const BAND = 0.06;

// Colours bands along the edges by what the server measured there.
const fillGaps = newestOnly(async () => {
  const answer = await ask("/gaps", question()).catch(() => null);
  const isSeam = state.shade === "seam gap";
  if (!isSeam && state.shade !== "gap") return;
  if (!answer?.ok) { refuse(answer); return; }
  let worst = 0, count = 0;
  answer.patches.forEach(({ boundary, seams }, index) => {
    const patch = stage.patches[index];
    if (!patch) return;
    const lines = (isSeam ? seams : boundary).map(({ across, at, values }) => {
      const [[low, high], nodes] = across === "u" ? [patch.data.domain[0], patch.u] : [patch.data.domain[1], patch.v];
      worst = Math.max(worst, ...values);
      count += 1;
      return { across, values, isNear: Array.from(nodes, (x) => Math.abs(x - at) <= BAND * (high - low)) };
    });
    const [nu, nv] = patch.cells;
    const along = (values, share) => {
      const at = share * (values.length - 1), from = Math.min(Math.floor(at), values.length - 2);
      return values[from] * (1 - (at - from)) + values[from + 1] * (at - from);
    };
    patch.setScalars((i, j) => Math.max(-1, ...lines.map(({ across, values, isNear }) => {
      if (!isNear[across === "u" ? i : j]) return -1;
      return across === "u" ? along(values, j / nv) : along(values, i / nu);
    })));
  });
  const largest = worst.toExponential(1);
  const text = isSeam ? (count ? `gap between neighbours at most ${largest}` : "no edge of a patch meets another")
    : count ? `gap to the prescribed positions at most ${largest}` : "a B-spline net has no prescribed positions but its control points";
  showLegend({ low: "1e-16", high: "1", isRising: true, text });
  facts.gap = worst;
  facts.gaps += 1;
  stage.invalidate();
});

function colour() {
  stage.shade = state.shade;
  stage.lines = state.lines;
  const scale = 1 / (stage.radius || 1);
  switch (state.shade) {
    case "residual": fillResidual(); break;
    case "gap": case "seam gap": fillGaps(); break;
    case "Gaussian curvature":
      showLegend({ low: "saddle", high: "dome", isRising: false, text: `half colour at ±${(scale * scale).toPrecision(2)}` });
      break;
    case "mean curvature":
      showLegend({ low: "−", high: "+", isRising: false, text: `half colour at ±${scale.toPrecision(2)}` });
      break;
    default: showLegend(null);
  }
  stage.invalidate();
}

async function download(format) {
  const findings = await keep({ ...question(), format, grid: state.grid });
  if (findings.length) showFindings(findings);
}

async function screenshot() {
  save(await stage.screenshot(), "trimline.png");
}

function setLayer(name, on) {
  if (name === "wireframe") state.lines = on;
  else state.off = on ? state.off.filter((other) => other !== name) : [...state.off, name];
  if (name in stage.layers) stage.layers[name] = on;
  stage.redrawGiven();
  stage.lines = state.lines;
  remember();
}

for (const name of state.off) if (name in stage.layers) stage.layers[name] = false;
choices(byId("shade"), SHADES, state.shade, (name) => { state.shade = name; remember(); colour(); });
choices(byId("grid"), GRIDS, state.grid, (name) => { state.grid = name; remember(); if (scene?.sampled.length) refresh(); else if (scene) draw(); });
toggles(byId("layers"), LAYERS, (name) => (name === "wireframe" ? state.lines : !state.off.includes(name)), setLayer);
byId("time").addEventListener("input", (event) => { play(false); setTime(Number(event.target.value)); });
byId("play").addEventListener("click", () => play(!isPlaying));
byId("reset").addEventListener("click", () => { state.values = {}; remember(); refresh(); });
window.addEventListener("error", (event) => facts.errors.push(String(event.message)));

const events = new EventSource("/events");
events.addEventListener("message", ({ data }) => { if (Number(data) !== facts.revision) refresh(); });
events.addEventListener("error", () => { byId("status").textContent = "the server has gone"; });

window.__trimline = {
  facts, state, requests,
  get frames() { return stage.frames; },
  get knowsAllTimes() { return stage.patches.every((patch) => patch.knowsAllTimes); },
  // What the graphics card made of a vertex: its position in single precision.
  vertex: (i, j, patch = 0) => stage.vertex(i, j, patch),
  // The number that a vertex is coloured by.
  scalar: (i, j, patch = 0) => { const { mesh, v } = stage.patches[patch]; return mesh.geometry.getAttribute("scalar").array[i * v.length + j]; },
  // The instant that is drawn, which may lie behind the slider's while the server is asked.
  get drawnTime() { return stage.time; },
  primary: (i, j, index = 0) => stage.primaries[index].vertex(i, j),
  patches: () => stage.patches.map(({ data: { name, domain, form: { kind } } }) => ({ name, domain, kind })),
  pixels: () => stage.pixels(),
  point: (u, v, patch = 0) => stage.patches[patch].points([u], [v])[0][0],
};
