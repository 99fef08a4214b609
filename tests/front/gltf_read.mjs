// How three.js understands a GLB file. Usage: node gltf_read.mjs file [seconds…]; prints JSON:
// "joints": for each time, the world position of every named joint, in the order of the extras;
// "skin": the skinned vertices of the first time, or of the resting pose without times.
import { readFileSync } from "node:fs";

const three = new URL("../../static/node_modules/three/", import.meta.url);
const { AnimationMixer, LoopOnce, PropertyBinding, Vector3 } = await import(
  new URL("build/three.module.js", three)
);
const { GLTFLoader } = await import(new URL("examples/jsm/loaders/GLTFLoader.js", three));

const [file, ...times] = process.argv.slice(2);
const bytes = readFileSync(file);
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
const gltf = await new GLTFLoader().parseAsync(buffer, "");
const extras = gltf.asset.extras.manner;

const nodes = (extras.names ?? []).map((name) =>
  gltf.scene.getObjectByName(PropertyBinding.sanitizeNodeName(name)),
);
const joints = [];
let skin = null;
if (times.length === 0) skin = skinned();
else {
  const mixer = new AnimationMixer(gltf.scene);
  const action = mixer.clipAction(gltf.animations.find(({ name }) => name === "motion"));
  action.setLoop(LoopOnce);
  action.clampWhenFinished = true;
  action.play();
  for (const time of times.map(Number)) {
    action.reset();
    mixer.setTime(time);
    gltf.scene.updateMatrixWorld(true);
    joints.push(nodes.map((node) => node.getWorldPosition(new Vector3()).toArray()));
    skin ??= skinned();
  }
}
console.log(JSON.stringify({ joints, skin, extras }));

function skinned() {
  const mesh = gltf.scene.getObjectByProperty("isSkinnedMesh", true);
  if (!mesh) return null;
  gltf.scene.updateMatrixWorld(true);
  mesh.skeleton.update();
  const place = new Vector3();
  return Array.from({ length: mesh.geometry.attributes.position.count }, (_, index) =>
    mesh.getVertexPosition(index, place).applyMatrix4(mesh.matrixWorld).toArray(),
  );
}
