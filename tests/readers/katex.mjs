// Renders every LaTeX block that trimline prints for the given specs; fails on what KaTeX does not read.
// Usage: node katex.mjs TRIMLINE SPEC…
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import katex from "katex";

const [trimline, ...all] = process.argv.slice(2);
// B-spline nets have no basis, and of an imported cubic not all derivatives of it exist.
const specs = all.filter((spec) => !/bspline[ (]/.test(readFileSync(spec, "utf8")));
let blocks = 0;
for (const spec of specs) {
  const run = (...options) => execFileSync(trimline, [...options, "--quiet", spec], { encoding: "utf8", maxBuffer: 1 << 26 });
  const report = JSON.parse(run("check", "--explain", "--format", "json"));
  const texts = [run("basis", "--format", "latex"), ...report.patches.flatMap((patch) => Object.values(patch.explanation.latex))];
  for (const text of texts.filter((text) => text !== "")) {
    // Long sums are many commands; the default bound on expansions is one against macros that call themselves.
    katex.renderToString(text, { displayMode: true, strict: "error", throwOnError: true, maxExpand: text.length });
    blocks += 1;
  }
}
if (blocks < 2 * specs.length) throw new Error(`only ${blocks} blocks were rendered`);
console.log(`${blocks} blocks of ${specs.length} specs rendered`);
