// The right side while clips are made, and afterwards.

import { html, nothing, type TemplateResult } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { icon } from "../icons";
import type { JobWatch } from "./job_watch";
import { endWords, isOpen, progressWords, settled, timeLeft, type Clip, type Job, type JobItem } from "./model";
import "../viewer/thumbnails";

const FAILURES = 50; // lines

export interface JobPanel {
  watch: JobWatch;
  /** The library by id, once it is known. */
  made: ReadonlyMap<string, Clip>;
  stop(): void;
  again(): void;
}

export function jobPanel(job: Job, given: JobPanel): TemplateResult {
  return html`<section class="set-job" aria-labelledby="job-title">
    ${isOpen(job) ? running(job, given) : ended(job, given)}
    ${failures(job)}
  </section>`;
}

function running(job: Job, { watch, stop }: JobPanel): TemplateResult {
  const left = timeLeft(watch.marks, job.total);
  return html`<header class="page-header"><h2 class="figure-title" id="job-title" tabindex="-1">
      ${job.state === "waiting" ? "Waiting for its turn" : "Making the clips"}</h2>
    <div class="buttons"><button class="button" type="button" @click=${stop}>${icon("stop")}Stop</button></div></header>
    <progress max=${job.total} .value=${settled(job)} aria-label="Clips made"></progress>
    <p class="set-progress"><span>${progressWords(job)}</span><span class="quiet">${left}</span></p>
    <p class="hint">You can leave this page; the server goes on. What is made stays, also if you stop.</p>
    ${watch.problem ? html`<p class="note" role="status">${icon("cloud")}<span><b>${watch.problem.message}</b> The server may well be going on; this page asks again by itself.</span></p>` : nothing}`;
}

function ended(job: Job, { made, again }: JobPanel): TemplateResult {
  const clips = [...new Set(job.items.flatMap(({ clip }) => clip ?? []))].flatMap((id) => made.get(id) ?? []);
  const set = clips[0]?.tags.set;
  return html`<header class="page-header"><h2 class="figure-title" id="job-title" tabindex="-1">${endWords(job)}</h2>
    <div class="buttons"><button class="button" type="button" @click=${again}>${icon("back")}Another set</button></div></header>
    ${set ? html`<p class="quiet">In the <a href="/library">library</a> under <b>${set}</b>.</p>` : nothing}
    <ul class="clip-grid">${repeat(clips, ({ id }) => id, card)}</ul>`;
}

const card = (clip: Clip): TemplateResult => html`<li><a class="clip-card" href=${clip.page_url}>
  <span class="clip-stage"><motion-thumbnail src=${clip.glb_url} figure=${clip.figure_url ?? nothing} poster-time=${clip.poster_time}></motion-thumbnail></span>
  <span class="clip-name" title=${clip.name}>${clip.name}</span>
  <span class="tiny">${clip.tags.emotion ?? ""}</span></a></li>`;

function failures(job: Job): TemplateResult | typeof nothing {
  const failed = job.items.filter(({ error }) => error);
  if (!failed.length) return nothing;
  const line = ({ name, error }: JobItem) => html`<li><b>${name}</b><br><span class="small">${error}</span></li>`;
  return html`<div class="note note-bad">${icon("warning")}<div><p><b>Could not be made</b></p>
    <ul class="set-failures">${failed.slice(0, FAILURES).map(line)}</ul></div></div>`;
}
