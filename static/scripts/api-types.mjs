// Writes src/api-types.ts from the server's own OpenAPI document; with --check only compares.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { delimiter } from "node:path";
import { fileURLToPath } from "node:url";
import openapiTS, { astToString } from "openapi-typescript";

const place = new URL("../src/api-types.ts", import.meta.url);
const commands = fileURLToPath(new URL("../../.venv/bin", import.meta.url));
const PATH = [commands, process.env.PATH].join(delimiter);

const document = JSON.parse(execFileSync("manner", ["openapi"], { env: { ...process.env, PATH } }));
const head = "// Generated from the OpenAPI document by `npm run api-types`: change the server's schemas instead.\n";
const types = head + astToString(await openapiTS(document));

if (!process.argv.includes("--check")) {
  writeFileSync(place, types);
} else if (readFileSync(place, "utf8") !== types) {
  console.error("static/src/api-types.ts differs from the server's API. Run `npm run api-types` in static/.");
  process.exit(1);
}
