// A variant as text: the recipe alone, or a call that makes it with a key kept in the environment.
import type { Json, Steps } from "./recipe";

export interface Variant {
  source: string;
  operations: Steps;
  name: string;
}

const KEY = "MANNER_KEY";

export const asRecipe = ({ operations }: Variant): string => JSON.stringify(operations, null, 2);

export function asCurl(variant: Variant, server: string): string {
  return [
    `curl --fail-with-body -X POST ${shellQuoted(`${server}/api/v1/clips`)} \\`,
    `  -H "Authorization: Bearer $${KEY}" \\`,
    `  -H "Content-Type: application/json" \\`,
    `  -d ${shellQuoted(JSON.stringify(variant))}`,
  ].join("\n");
}

export function asPython(variant: Variant, server: string): string {
  return `import json
import os
import urllib.request

variant = ${pythonLiteral(variant as unknown as Json)}
request = urllib.request.Request(
    ${pythonLiteral(`${server}/api/v1/clips`)},
    data=json.dumps(variant).encode(),
    headers={
        "Authorization": "Bearer " + os.environ["${KEY}"],
        "Content-Type": "application/json",
    },
)
with urllib.request.urlopen(request) as response:
    clip = json.load(response)
print(clip["id"], clip["name"])
`;
}

/** Single quotes keep everything as it is; one among the text ends them, stands alone, and begins them again. */
const shellQuoted = (text: string): string => `'${text.replaceAll("'", `'\\''`)}'`;

function pythonLiteral(value: Json, indent = ""): string {
  const deeper = `${indent}    `;
  const lines = (open: string, items: string[], close: string) =>
    items.length ? `${open}\n${items.map((item) => `${deeper}${item},\n`).join("")}${indent}${close}` : open + close;
  if (value === null) return "None";
  if (value === true) return "True";
  if (value === false) return "False";
  if (Array.isArray(value)) return lines("[", value.map((item) => pythonLiteral(item, deeper)), "]");
  if (typeof value !== "object") return JSON.stringify(value);
  const members = Object.entries(value).map(([name, item]) => `${JSON.stringify(name)}: ${pythonLiteral(item, deeper)}`);
  return lines("{", members, "}");
}
