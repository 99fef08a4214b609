// Writes src/api-types.ts from the server's own OpenAPI document. Types alone: what is built and run needs none of it.
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { delimiter } from "node:path";
import { fileURLToPath } from "node:url";
import openapiTS, { astToString } from "openapi-typescript";

const place = new URL("../src/api-types.ts", import.meta.url);
const commands = fileURLToPath(new URL("../../.venv/bin", import.meta.url));
const PATH = [commands, process.env.PATH].join(delimiter);

const document = JSON.parse(execFileSync("manner", ["openapi"], { env: { ...process.env, PATH } }));
const head = "// Generated from the OpenAPI document by `npm run api-types`: change the server's schemas instead.\n";
writeFileSync(place, head + astToString(await openapiTS(document)));
