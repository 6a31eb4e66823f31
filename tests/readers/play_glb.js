// Plays a GLB file with three.js: its loader reads the file, its mixer moves the clock, its meshes are morphed.
//
// usage: node play_glb.js FILE SECONDS...    prints the vertices of every mesh at each of these times as JSON.

import { readFile } from "node:fs/promises";
import { argv } from "node:process";
import { AnimationMixer, LoopOnce, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

const [path, ...times] = argv.slice(2);
const bytes = await readFile(path);
const { scene, animations } = await new GLTFLoader().parseAsync(new Uint8Array(bytes).buffer, "");
const mixer = new AnimationMixer(scene);
const actions = animations.map((clip) => {
  // At the end of the clip its last frame is wanted, not the first one again.
  const action = mixer.clipAction(clip).setLoop(LoopOnce, 1);
  action.clampWhenFinished = true;
  return action.play();
});
const meshes = [];
scene.traverse((node) => { if (node.isMesh) meshes.push(node); });

const at = (seconds) => {
  actions.forEach((action) => action.reset());
  mixer.setTime(Number(seconds));
  scene.updateMatrixWorld(true);
  return meshes.map((mesh) => {
    const count = mesh.geometry.getAttribute("position").count;
    return Array.from({ length: count }, (_, i) => mesh.localToWorld(mesh.getVertexPosition(i, new Vector3())).toArray());
  });
};

console.log(JSON.stringify({
  names: meshes.map(({ name }) => name),
  clips: animations.length,
  duration: animations[0]?.duration ?? 0,
  frames: times.map(at),
}));
