// Emitted GLSL and WGSL, compiled and run by a browser: they give the surface that `eval` gives, in single precision.

import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { check, deviation, evaluate, example, emitOptions, examples, launch, partsOf, runAll, serve, test, trimline } from "./harness.mjs";

const browser = await launch("--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", "--enable-features=Vulkan");
// WebGPU exists on pages from loopback only.
const server = await serve(example("eq13"));
const page = await browser.newPage();
await page.goto(server.address);

// Runs `surface(at.x, at.y, at.z)` at points; nine numbers each.
const runGlsl = ({ text, call, points }) => page.evaluate(({ text, call, points }) => {
  const gl = document.createElement("canvas").getContext("webgl2");
  const shader = (kind, source) => {
    const made = gl.createShader(kind);
    gl.shaderSource(made, source);
    gl.compileShader(made);
    if (!gl.getShaderParameter(made, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(made));
    return made;
  };
  const program = gl.createProgram();
  gl.attachShader(program, shader(gl.VERTEX_SHADER, `#version 300 es\nprecision highp float;\n${text}
    in vec3 at; out vec3 s, s_u, s_v;
    void main() { ${call}; gl_Position = vec4(0.0); gl_PointSize = 1.0; }`));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER, "#version 300 es\nprecision highp float; out vec4 c; void main() { c = vec4(1.0); }"));
  gl.transformFeedbackVaryings(program, ["s", "s_u", "s_v"], gl.INTERLEAVED_ATTRIBS);
  gl.bindAttribLocation(program, 0, "at");
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  gl.useProgram(program);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(points.flat()), gl.STATIC_DRAW);
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
  const result = gl.createBuffer();
  gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, result);
  gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, 36 * points.length, gl.STATIC_READ);
  gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, result);
  gl.enable(gl.RASTERIZER_DISCARD);
  gl.beginTransformFeedback(gl.POINTS);
  gl.drawArrays(gl.POINTS, 0, points.length);
  gl.endTransformFeedback();
  const values = new Float32Array(9 * points.length);
  gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, values);
  return Array.from(values);
}, { text, call, points });

const runWgsl = ({ text, call, points }) => page.evaluate(async ({ text, call, points }) => {
  const adapter = await navigator.gpu?.requestAdapter();
  if (!adapter) throw new Error("this browser has no WebGPU");
  const device = await adapter.requestDevice();
  const module = device.createShaderModule({ code: `${text}
    @group(0) @binding(0) var<storage, read> points: array<f32>;
    @group(0) @binding(1) var<storage, read_write> values: array<f32>;
    @compute @workgroup_size(1) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
      let k = id.x;
      let at = vec3<f32>(points[3u * k], points[3u * k + 1u], points[3u * k + 2u]);
      let p = ${call};
      for (var i = 0u; i < 3u; i++) {
        values[9u * k + i] = p.s[i];
        values[9u * k + 3u + i] = p.s_u[i];
        values[9u * k + 6u + i] = p.s_v[i];
      }
    }` });
  const faults = (await module.getCompilationInfo()).messages.filter(({ type }) => type !== "info");
  if (faults.length) throw new Error(faults.map(({ message, lineNum }) => `line ${lineNum}: ${message}`).join("; "));
  const pipeline = await device.createComputePipelineAsync({ layout: "auto", compute: { module, entryPoint: "main" } });
  const size = 36 * points.length;
  const input = device.createBuffer({ size: 12 * points.length, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST });
  device.queue.writeBuffer(input, 0, new Float32Array(points.flat()));
  const output = device.createBuffer({ size, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC });
  const read = device.createBuffer({ size, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST });
  const entries = [input, output].map((buffer, binding) => ({ binding, resource: { buffer } }));
  const commands = device.createCommandEncoder();
  const pass = commands.beginComputePass();
  pass.setPipeline(pipeline);
  pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
  pass.dispatchWorkgroups(points.length);
  pass.end();
  commands.copyBufferToBuffer(output, 0, read, 0, size);
  device.queue.submit([commands.finish()]);
  await read.mapAsync(GPUMapMode.READ);
  return Array.from(new Float32Array(read.getMappedRange()));
}, { text, call, points });

// A surface without basis functions.
const folder = mkdtempSync(join(tmpdir(), "trimline-shaders-"));
const zero = join(folder, "zero.trim");
writeFileSync(zero, "at u = 0: S = [0, 0, 0], dS/du = [0, 0, 0]\nat u = 1: S = [0, 0, 0], dS/du = [0, 0, 0]\n");

for (const [spec, name] of [zero, ...examples].flatMap((spec) => partsOf(spec, 2).map((name) => [spec, name]))) {
  for (const method of name === "eq27" || name === "eq19" ? [[], ["--method", "exact"]] : [[]]) {
    const options = [...method, "--patch", name];
    const within = emitOptions(spec, name);
    // In the time domain of every example.
    const time = 0.125;
    // Series that are longer than the tables of shaders are refused, and of the examples one has such.
    if (basename(spec) === "import_json.trim") {
      test(`shaders_of_${name}_are_refused`, () => {
        for (const language of ["glsl", "wgsl"]) {
          const { status, stderr } = spawnSync(process.env.TRIMLINE, ["emit", spec, "--lang", language, ...options]);
          check(status === 1 && /error\[E0904\]: a table of/.test(stderr), `${status}: ${stderr}`);
        }
      });
      continue;
    }
    const emitted = (language) => {
      const text = String(trimline(["emit", spec, "--lang", language, "--time", String(time), "--quiet", ...options, ...within]));
      const [, surface, parameters] = /(\w+_surface)\(([^)]*)\)/.exec(text);
      return { text, surface, at: /\bt\b/.test(parameters.replace(/\bout\b.*/, "")) ? "at.x, at.y, at.z" : "at.x, at.y" };
    };
    // Numbers that single precision holds, so that both sides are asked the same.
    const pointsOf = (text) => {
      const [, low, high, first, last] = /for u in \[([^,]+), ([^\]]+)\], v in \[([^,]+), ([^\]]+)\]/.exec(text).map(Number);
      const v = (k) => Math.fround(first + ((k + 0.5) / 16) * Math.min(1, last - first));
      return Array.from({ length: 16 }, (_, k) => [low + ((high - low) * (k % 5)) / 4, v(k), time]);
    };
    const compare = (found, points, text) => {
      // Rounding of 6e-8 in sums of some ten terms of some forty, which cancel in part; and where sines are taken, WGSL
      // allows them an error of 2^-11 each (GLSL names no bound), of which two or three may add up.
      // A B-spline in place of a surface has slopes that are some powers of its mesh size less exact.
      const tolerance = /\b(sin|cos)\(/.test(text) || within.length ? 2 ** -10 : 2e-5;
      const expected = evaluate(spec, points, ["--time", String(time), "--derivatives", "u,v", ...options]).flat();
      for (const [order, what] of ["S", "S_u", "S_v"].entries()) {
        const of = (values) => values.filter((_, i) => Math.floor(i / 3) % 3 === order);
        check(deviation(of(found), of(expected)) < tolerance, `${what} differs by ${deviation(of(found), of(expected))}`);
      }
    };
    test(`glsl_of_${name}_${method.at(-1) ?? "as_stated"}_gives_the_surface_of_eval`, async () => {
      const { text, surface, at } = emitted("glsl");
      const points = pointsOf(text);
      compare(await runGlsl({ text, call: `${surface}(${at}, s, s_u, s_v)`, points }), points, text);
    });
    test(`wgsl_of_${name}_${method.at(-1) ?? "as_stated"}_gives_the_surface_of_eval`, async () => {
      const { text, surface, at } = emitted("wgsl");
      const points = pointsOf(text);
      compare(await runWgsl({ text, call: `${surface}(${at})`, points }), points, text);
    });
  }
}

await runAll();
await browser.close();
server.stop();
rmSync(folder, { recursive: true });
