// Writes src/styles/tokens.css from src/tokens.json, the one place where colour, type and space are set.
import { readFileSync, writeFileSync } from "node:fs";

const folder = new URL("../src/", import.meta.url);
const tokens = JSON.parse(readFileSync(new URL("tokens.json", folder), "utf8"));
const kebab = (name) =>
  name.replace(/([a-z])([A-Z])/g, "$1-$2").replace(/([a-z])(\d)/g, "$1-$2").toLowerCase();
const declare = (entries) => entries.map(([name, value]) => `  --${name}: ${value};`).join("\n");

function modeTokens(mode) {
  const numbered = (name, values) => values.map((value, index) => [`${name}-${index + 1}`, value]);
  return [
    ...Object.entries(tokens.colour[mode]).map(([name, value]) => [kebab(name), value]),
    ...numbered("bipolar", tokens.data.bipolar[mode]),
    ...numbered("bipolar-text", tokens.data.bipolar[`${mode}Text`]),
    ...numbered("amount", tokens.data.amount[mode]),
    ...numbered("group", tokens.data.group[mode]),
    ["shadow-float", tokens.shadow[mode].float],
  ];
}

function sharedTokens() {
  const { type } = tokens;
  const fonts = {
    sans: '"Source Sans 3 Variable", "Noto Sans JP", system-ui, sans-serif',
    serif: '"Source Serif 4 Variable", "Noto Serif JP", Georgia, serif',
    mono: type.families.mono,
  };
  return [
    ...Object.entries(fonts).map(([name, value]) => [`font-${name}`, value]),
    ...Object.entries(type.scale).flatMap(([name, style]) => [
      [`size-${kebab(name)}`, `${style.size / 16}rem`],
      [`line-${kebab(name)}`, style.line],
      ...(style.tools ? [[`size-${kebab(name)}-tools`, `${style.tools / 16}rem`]] : []),
    ]),
    ...Object.entries(type.phone).map(([name, size]) => [`size-${name}-phone`, `${size / 16}rem`]),
    ...tokens.space.map((value, index) => [`space-${index + 1}`, `${value}px`]),
    ...Object.entries(tokens.radius).map(([name, value]) => [`radius-${name}`, `${value}px`]),
    ...["press", "state", "panel"].map((name) => [`time-${name}`, `${tokens.motion[name]}ms`]),
    ["ease", tokens.motion.ease],
    ["target", `${tokens.target.touch}px`],
  ];
}

const block = (selector, entries, scheme) =>
  `${selector} {\n${scheme ? `  color-scheme: ${scheme};\n` : ""}${declare(entries)}\n}\n`;
const dark = modeTokens("dark");
writeFileSync(
  new URL("styles/tokens.css", folder),
  "/* Generated from tokens.json by scripts/tokens.mjs: change it there. */\n" +
    block(":root", [...sharedTokens(), ...modeTokens("light")], "light") +
    `@media (prefers-color-scheme: dark) {\n${block(":root:not([data-theme=light])", dark, "dark")}}\n` +
    block(":root[data-theme=dark]", dark, "dark"),
);
