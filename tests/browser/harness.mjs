// What the browser tests share: the command, the browser, and a list of tests that runs one after the other.

import { spawn, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

const { TRIMLINE, EXAMPLES, CHROMIUM } = process.env;
export const examples = readdirSync(EXAMPLES).filter((name) => name.endsWith(".trim")).map((name) => join(EXAMPLES, name));
export const example = (name) => join(EXAMPLES, `${name}.trim`);

// Runs the command and gives its standard output.
export function trimline(args, input = "") {
  const { status, stdout, stderr } = spawnSync(TRIMLINE, args, { input: Buffer.from(input), maxBuffer: 1 << 28 });
  if (status !== 0) throw new Error(`trimline ${args.join(" ")}: ${stderr}`);
  return stdout;
}

// The options with which a shading language takes a part: those that are no sums of products, or too steep for series, have
// to be told how far a B-spline may be off, and of some only one that is farther off has few enough control points.
export function emitOptions(spec, part) {
  const taken = [[], ["--within", "1e-4"], ["--within", "2e-3"]].find((within) => {
    const { status, stderr } = spawnSync(TRIMLINE, ["emit", spec, "--lang", "wgsl", "--patch", part, ...within]);
    if (status !== 0 && !/--within/.test(stderr)) throw new Error(`${spec}, ${part}: ${stderr}`);
    return status === 0;
  });
  return taken ?? [];
}

// S, and the derivatives asked for, at points [u, v, t]: nine numbers and so on each.
export function evaluate(spec, points, options = []) {
  const table = trimline(["eval", spec, "--points", "-", "--quiet", ...options], `u,v,t\n${points.map((p) => p.join(",")).join("\n")}\n`);
  return String(table).trim().split("\n").slice(1).map((line) => line.split(",").slice(3).map(Number));
}

// What `check` reports of a spec.
export function report(spec) {
  return JSON.parse(trimline(["check", spec, "--format", "json", "--quiet", "--time", "0.125"]));
}

// The names of all patches, nets and copies, in the order of the page; of copies only so many.
export function partsOf(spec, most = Infinity) {
  const { patches, nets, copies } = report(spec);
  return [...patches, ...nets, ...copies.slice(0, most)].map(({ name }) => name);
}

// Starts the view of a spec on a free port; ends with `stop`.
export async function serve(spec, options = []) {
  const server = spawn(TRIMLINE, ["view", spec, "--port", "0", "--quiet", ...options]);
  const address = await new Promise((resolve, reject) => {
    let said = "";
    server.stdout.on("data", (data) => { said += data; if (said.includes("\n")) resolve(said.trim()); });
    server.on("exit", (status) => reject(new Error(`the view ended with status ${status}`)));
  });
  return { address, stop: () => server.kill() };
}

export const launch = (...more) => chromium.launch({
  executablePath: CHROMIUM,
  args: ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", ...more],
});

const tests = [];
export const test = (name, body) => tests.push([name, body]);

export function check(is, what) {
  if (!is) throw new Error(what);
}

// Largest difference, over the largest number expected, or over 1 where all are smaller: the examples are of that size.
export function deviation(found, expected) {
  const size = Math.max(...expected.map(Math.abs), 1);
  return Math.max(...found.map((x, i) => Math.abs(x - expected[i]))) / size;
}

// Runs every test, or those whose name contains the first argument.
export async function runAll() {
  const chosen = tests.filter(([name]) => name.includes(process.argv[2] ?? ""));
  const folder = mkdtempSync(join(tmpdir(), "trimline-browser-"));
  let failed = 0;
  for (const [name, body] of chosen) {
    try {
      await body(folder);
      console.log(`ok      ${name}`);
    } catch (error) {
      failed += 1;
      console.log(`FAILED  ${name}\n        ${error.stack ?? error}`);
    }
  }
  rmSync(folder, { recursive: true });
  console.log(`${chosen.length - failed} passed, ${failed} failed`);
  process.exitCode = failed ? 1 : 0;
}
