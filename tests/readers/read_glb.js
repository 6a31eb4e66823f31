// Reads a GLB file with two readers of others and prints what they found as JSON.
//
// gltf-validator judges the file; glTF Transform plays its animation: at each instant of the sampler the weights are
// applied to the morph targets of every mesh.

import { readFile } from "node:fs/promises";
import { argv } from "node:process";
import { NodeIO } from "@gltf-transform/core";
import validator from "gltf-validator";

const bytes = new Uint8Array(await readFile(argv[2]));
const report = await validator.validateBytes(bytes);
const document = await new NodeIO().readBinary(bytes);
const root = document.getRoot();
const [animation] = root.listAnimations();
const sampler = animation?.listSamplers()[0];
const times = sampler ? Array.from(sampler.getInput().getArray()) : [0];

const blended = (primitive, name, weights) => {
  const values = Float64Array.from(primitive.getAttribute(name).getArray());
  primitive.listTargets().forEach((target, index) => {
    if (weights[index] === 0) return;
    target.getAttribute(name).getArray().forEach((delta, at) => { values[at] += weights[index] * delta; });
  });
  return Array.from(values);
};

const meshes = root.listNodes().filter((node) => node.getMesh()).map((node) => {
  const [primitive] = node.getMesh().listPrimitives();
  const count = primitive.listTargets().length;
  const output = sampler?.getOutput().getArray() ?? [];
  const frames = times.map((_, frame) => Array.from(output.slice(frame * count, (frame + 1) * count)));
  return {
    name: node.getName(),
    matrix: node.getWorldMatrix(),
    triangles: primitive.getIndices().getCount() / 3,
    positions: frames.map((weights) => blended(primitive, "POSITION", weights)),
    normals: frames.map((weights) => blended(primitive, "NORMAL", weights)),
  };
});

console.log(JSON.stringify({
  issues: report.issues,
  info: report.info,
  channels: animation?.listChannels().map((channel) => channel.getTargetPath()) ?? [],
  interpolation: sampler?.getInterpolation() ?? null,
  extras: animation?.getExtras() ?? {},
  times,
  meshes,
}));
