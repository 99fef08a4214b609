// What Khronos' validator says of GLB files. Usage: node gltf_check.mjs file…; prints JSON.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const require = createRequire(new URL("../../static/package.json", import.meta.url));
const validator = require("gltf-validator");

const reports = [];
for (const file of process.argv.slice(2)) {
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(file)));
  const messages = issues.messages.filter(({ severity }) => severity < 2);
  reports.push({ errors: issues.numErrors, warnings: issues.numWarnings, messages });
}
console.log(JSON.stringify(reports));
