// The left panel: by what one says how it feels, the sliders for it, and the map of the space.
import { html, nothing, type TemplateResult } from "lit";
import { icon } from "../icons";
import { interfacesOf, measured, slidersOf, type Interface, type Kind, type Slider } from "./model";
import type { SpaceSession } from "./session";
import { wordSliders, type WordSlider } from "./sliders";
import { LANGUAGES } from "./words";

const TITLES: Record<Interface, string> = { adjectives: "Adjectives", features: "Features", weights: "Weights" };

export interface FeelActs {
  by(by: Interface): void;
  speak(language: string): void;
  set(id: string, value: number): void;
  add(): void;
  swap(id: string): void;
  remove(id: string): void;
  middle(): void;
  weights(): void;
}

export interface FeelState {
  language: string;
  languages: readonly string[];
  map: TemplateResult | typeof nothing;
}

export function feelPanel(session: SpaceSession, { language, languages, map }: FeelState, acts: FeelActs): TemplateResult {
  const { by } = session.place;
  return html`<section><header><h2>How it feels</h2>${languages.length > 1 ? speech(language, languages, acts) : nothing}</header>
      <div class="segments interfaces" role="group" aria-label="Say it by">${interfacesOf(session.space).map((one) => html`
        <button type="button" aria-pressed=${one === by} @click=${() => acts.by(one)}>${TITLES[one]}</button>`)}</div>
      ${by === "weights" ? byWeights(acts) : sliders(session, by, language, acts)}
    </section>${map}`;
}

const speech = (language: string, languages: readonly string[], { speak }: FeelActs) => html`<label class="speech"><span class="visually-hidden">Language of the words</span>
  <select @change=${(event: Event) => speak((event.target as HTMLSelectElement).value)}>${languages.map(
    (one) => html`<option value=${one} ?selected=${one === language}>${LANGUAGES[one]}</option>`)}</select></label>`;

const byWeights = ({ weights, middle }: FeelActs) => html`<p class="by-weights">Move the weight of any example in the list of the mix.
    The others keep their proportions, so that all together stay 100 %.</p>
  <div class="slider-acts"><button class="link-button to-weights" type="button" @click=${weights}>Show the weights</button>
    <button class="link-button" type="button" @click=${middle}>${icon("replay")}All alike</button></div>`;

function sliders(session: SpaceSession, by: Kind, language: string, acts: FeelActs): TemplateResult {
  const all = new Map(slidersOf(session.space, by, language).map((slider) => [slider.id, slider]));
  const shown = Object.entries(session.place[by]).flatMap(([id, value]) => {
    const slider = all.get(id);
    return slider ? [{ ...wordsOf(slider, value), lang: language }] : [];
  });
  // Something has to span the space.
  const loose = (id: string) => !all.get(id)?.primary && shown.length > 1;
  return html`${wordSliders(shown, acts, loose)}
    <div class="slider-acts"><button class="link-button" type="button" @click=${acts.add}>${icon("plus")}${by === "adjectives" ? "Add a pair" : "Add a feature"}</button>
      <button class="link-button" type="button" @click=${acts.middle}>${icon("replay")}To the middle</button></div>`;
}

/** A feature's ends say what was measured. */
function wordsOf({ id, primary, title, about, left, right, reach }: Slider, value: number): WordSlider {
  if (!reach) return { id, value, left, right, title: primary ? title : undefined };
  return {
    id, value, title, hint: about, left: measured(0, reach), right: measured(1, reach), words: measured(value, reach),
  };
}
