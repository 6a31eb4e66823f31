// The view of one spec: asks the server for the surface, draws it, and follows the spec as it is edited.

import * as address from "./address.js";
import { ask, keep, newestOnly, requests, save } from "./server.js";
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
const facts = { revision: 0, answers: 0, motions: 0, drawnAt: 0, serverMilliseconds: 0, tableMilliseconds: 0, findings: [], errors: [] };

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
  take(answer);
});

function take(answer) {
  const isNew = answer.revision !== facts.revision;
  facts.findings = answer.findings;
  facts.serverMilliseconds = answer.milliseconds;
  showFindings(answer.findings);
  byId("name").textContent = answer.name;
  byId("status").textContent = answer.is_current && answer.solved ? "" : answer.solved || scene
    ? "the picture is that of the last text without errors" : "there is no surface yet";
  if (answer.solved) {
    const mathematics = JSON.stringify(answer.solved.patches.map(({ equation, conditions, functions }) => [equation, conditions, functions]));
    const isOther = scene?.mathematics !== mathematics;
    scene = { ...answer.solved, mathematics };
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
  if (state.time === null || !(state.time >= from && state.time <= to)) state.time = scene.time;
  const began = performance.now();
  stage.show(scene.patches, scene.surfaces, cells(), state.time);
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
  if (!stage.knows(time)) { refresh(); return; }
  const began = performance.now();
  stage.setTime(time);
  facts.tableMilliseconds = performance.now() - began;
  colour();
}

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
  if (!scene.patches.some(({ is_instant }) => is_instant)) { facts.motions += 1; return; }
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

const fillResidual = newestOnly(async () => {
  const answer = await ask("/residual", question()).catch(() => null);
  if (!answer?.ok || state.shade !== "residual") return;
  answer.patches.forEach(({ rows, columns, values }, index) => {
    const patch = stage.patches[index];
    if (!patch) return;
    const [nu, nv] = patch.cells;
    patch.setScalars((i, j) => {
      const [x, y] = [(i / nu) * (rows - 1), (j / nv) * (columns - 1)];
      const [a, b] = [Math.min(Math.floor(x), rows - 2), Math.min(Math.floor(y), columns - 2)];
      const at = (row, column) => values[row * columns + column];
      const along = (row) => at(row, b) * (1 - (y - b)) + at(row, b + 1) * (y - b);
      return along(a) * (1 - (x - a)) + along(a + 1) * (x - a);
    });
  });
  const largest = Math.max(...answer.patches.flatMap(({ values }) => values));
  showLegend({ low: "1e-16", high: "1", isRising: true, text: `residual over the largest term, at most ${largest.toExponential(1)}` });
  stage.invalidate();
});

function fillGaps() {
  let worst = 0, open = 0;
  for (const patch of stage.patches) {
    const { boundary, seam } = patch.gaps();
    worst = Math.max(worst, ...boundary.flatMap(({ values }) => Array.from(values)));
    open = Math.max(open, ...seam);
    // Between two trimlines the colour goes over from one's gap to the other's.
    patch.setScalars((i, j) => {
      const u = patch.u[i];
      const below = boundary.filter((it) => it.u <= u).at(-1) ?? boundary[0], above = boundary.find((it) => it.u >= u) ?? below;
      if (!below) return 0;
      const share = above.u > below.u ? (u - below.u) / (above.u - below.u) : 0;
      return below.values[j] * (1 - share) + above.values[j] * share;
    });
  }
  const text = `gap at the trimlines at most ${worst.toExponential(1)}; the ends of v are up to ${open.toExponential(1)} apart`;
  showLegend({ low: "1e-16", high: "1", isRising: true, text });
  facts.gap = worst;
}

function colour() {
  stage.shade = state.shade;
  stage.lines = state.lines;
  const scale = 1 / (stage.radius || 1);
  switch (state.shade) {
    case "residual": fillResidual(); break;
    case "gap": fillGaps(); break;
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
choices(byId("grid"), GRIDS, state.grid, (name) => { state.grid = name; remember(); if (scene) draw(); });
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
  get knowsAllTimes() { return stage.patches.every((patch) => !patch.data.is_instant || patch.motion !== null); },
  // What the graphics card made of a vertex: its position in single precision.
  vertex: (i, j, patch = 0) => stage.vertex(i, j, patch),
  primary: (i, j, index = 0) => stage.primaries[index].vertex(i, j),
  patches: () => stage.patches.map(({ data: { name, domain } }) => ({ name, domain })),
  pixels: () => stage.pixels(),
  point: (u, v, patch = 0) => stage.patches[patch].points([u], [v])[0][0],
};
