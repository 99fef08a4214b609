/** The viewer's own style sheet: tokens come in as custom properties from the page. */

const TEXT = `
:host { display: block; position: relative; min-height: 200px; container-type: size; color: var(--ink);
  font-family: var(--font-sans); font-size: 15px; line-height: 1.4; -webkit-user-select: none; user-select: none; }
:host([hidden]) { display: none; }
.stage, .canvas { position: absolute; inset: 0; }
.stage { touch-action: pan-y; cursor: grab; border-radius: var(--radius-control); outline: none; }
.stage:active { cursor: grabbing; }
:host([static]) .stage { touch-action: auto; cursor: default; }
.canvas canvas { position: absolute; inset: 0; width: 100%; height: 100%; }
:focus-visible { outline: 3px solid var(--accent); outline-offset: 2px; }
.stage:focus-visible { outline-offset: -3px; }
.hidden { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
[hidden] { display: none !important; }

.legend { position: absolute; top: 16px; left: 0; right: 0; height: 24px; margin: 0; padding: 0; list-style: none; pointer-events: none; }
.legend.row { display: flex; justify-content: center; gap: 32px; }
:host([controls="views"]) .legend.row { top: auto; bottom: 16px; left: 20px; justify-content: start; gap: 20px; }
:host([controls="views"]) .legend.above { top: auto; bottom: 16px; }
.legend li { display: flex; align-items: center; gap: 8px; font-weight: 600; white-space: nowrap; }
.legend.above li { position: absolute; transform: translateX(-50%); }
.legend li::before { content: ""; box-sizing: border-box; width: 11px; height: 11px; border-radius: 50%; background: currentColor; border: 2px solid currentColor; }
.legend li.ghost::before { background: none; }
.legend .clay { color: var(--ink-2); } .legend .original { color: var(--ink-3); }
.legend .judged { color: var(--judged-text); } .legend .reference { color: var(--reference-text); }
.legend .creation { color: var(--creation-text); }

.controls { position: absolute; left: 0; right: 0; bottom: 0; padding: 0 24px 20px; display: flex; align-items: center; gap: 8px; box-sizing: border-box; pointer-events: none; }
.controls > * { pointer-events: auto; }
button, select { font: inherit; color: inherit; background: none; border: 0; border-radius: var(--radius-control); min-width: 44px; min-height: 44px; padding: 0 12px; cursor: pointer;
  display: inline-flex; align-items: center; justify-content: center; gap: 8px; white-space: nowrap; transition: background-color var(--time-press) var(--ease); }
button:hover, select:hover { background: var(--sunken); }
button[aria-pressed="true"] { background: var(--accent-soft); color: var(--accent-ink); }
svg { width: 20px; height: 20px; fill: none; stroke: currentColor; stroke-width: 1.6; stroke-linecap: round; stroke-linejoin: round; flex: none; }
.hint { display: inline-flex; align-items: center; justify-content: flex-end; gap: 8px; color: var(--ink-2); white-space: nowrap; }
.look { flex: none; display: grid; justify-items: end; align-items: center; min-height: 44px; }
.look > * { grid-area: 1 / 1; }
.look > .away { visibility: hidden; }
.time { font-variant-numeric: tabular-nums; color: var(--ink-2); white-space: nowrap; padding: 0 8px; }
.time b { color: var(--ink); font-weight: 600; }
select { appearance: none; font-variant-numeric: tabular-nums; }

input[type="range"] { --filled: 0%; appearance: none; flex: 1 1 120px; min-width: 60px; height: 44px; margin: 0 12px; background: none; cursor: pointer; border-radius: var(--radius-control); }
input[type="range"]::-webkit-slider-runnable-track { height: 4px; border-radius: 2px;
  background: linear-gradient(var(--ink) 0 0) 0 / var(--filled) 4px no-repeat, linear-gradient(var(--line-strong) 0 0) 50% / 100% 2px no-repeat; }
input[type="range"]::-moz-range-track { height: 2px; border-radius: 2px; background: var(--line-strong); }
input[type="range"]::-moz-range-progress { height: 4px; border-radius: 2px; background: var(--ink); }
input[type="range"]::-webkit-slider-thumb { appearance: none; width: 16px; height: 16px; margin-top: -6px; border-radius: 50%; background: var(--ink); border: 0; }
input[type="range"]::-moz-range-thumb { width: 16px; height: 16px; border-radius: 50%; background: var(--ink); border: 0; }

.views { position: absolute; top: 16px; left: 20px; display: inline-flex; border: 1px solid var(--line-strong); border-radius: var(--radius-control); overflow: clip; background: var(--surface); }
.views button { border-radius: 0; font-weight: 600; padding: 0 14px; min-height: 44px; font-size: 14px; }
.views button + button { border-left: 1px solid var(--line); }
.views button[aria-pressed="true"] { background: var(--ink); color: var(--paper); }
.views button:focus-visible { outline-offset: -4px; }
.views button[aria-pressed="true"]:focus-visible { outline-color: var(--paper); }

.message { position: absolute; left: 0; right: 0; bottom: 0; padding: 0 24px 32px; display: grid; gap: 12px; justify-items: start; }
.message p { margin: 0; max-width: 34em; }
.message .head { font-family: var(--font-serif); font-size: 20px; }
.message button { border: 1px solid var(--line-strong); font-weight: 600; padding: 0 16px; }
.bar { width: 100%; height: 4px; border-radius: 2px; background: var(--line); overflow: hidden; }
.bar div { height: 100%; width: 0; border-radius: 2px; background: var(--accent); }
.unsupported { position: absolute; inset: 0; display: grid; align-content: center; padding: 24px; }

@container (max-width: 560px) {
  .controls { padding: 0 12px 3px; gap: 0; }
  .hint span { display: none; }
}
@container (max-width: 760px) {
  .controls.full { flex-wrap: wrap; }
  .controls.full input[type="range"] { order: -1; flex-basis: 100%; height: 32px; }
  .controls.full .hint, .controls.full .away { display: none; }
  .views { top: 8px; left: 12px; }
  .time .frame { display: none; }
}
@container (max-width: 480px) {
  .legend.above li:first-child:nth-last-child(2) { left: 16px !important; transform: none; }
  .legend.above li:last-child:nth-child(2) { left: auto !important; right: 16px; transform: none; }
  .look button span { display: none; }
  .views button { padding: 0 10px; }
}
@media (prefers-reduced-motion: reduce) { * { transition: none !important; } }
`;

let sheet: CSSStyleSheet | undefined;

/** Constructed in script, so that it needs no exception from the page's content policy. */
export function viewerStyles(): CSSStyleSheet {
  if (!sheet) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync(TEXT);
  }
  return sheet;
}
