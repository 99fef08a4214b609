// The map with the choice of what lies across and what upwards.
import { html, nothing, type TemplateResult } from "lit";
import { mixed, moved, slidersOf, switched, type Place } from "./model";
import type { Spot } from "./map_model";
import type { SpaceSession } from "./session";
import "./space_map";

export type Axes = readonly [across: string, up: string];

export interface MapActs {
  choose(axes: Axes): void;
  move(change: (place: Place) => Place): void;
  goTo(index: number): void;
}

/** The axes that are wanted, as far as their sliders are on show; the first ones otherwise. */
export function axesOf(shown: readonly string[], wanted: Axes | null): Axes | null {
  const kept = (wanted ?? []).filter((id) => shown.includes(id));
  const [across, up] = [...new Set([...kept, ...shown])];
  if (across === undefined || up === undefined) return null;
  return wanted && kept.length === 2 ? wanted : [across, up];
}

/** By bare weights it is the map of how the mix feels; moving its point is saying it by that again. */
export function mapPanel(session: SpaceSession, language: string, wanted: Axes | null, acts: MapActs): TemplateResult | typeof nothing {
  const { place, weights, space } = session;
  const kind = place.by === "weights" ? (space.definition.adjectives ? "adjectives" : "features") : place.by;
  const shown = Object.keys(place[kind]);
  const axes = axesOf(shown, wanted);
  if (!axes) return nothing;
  const known = new Map(slidersOf(space, kind, language).map((slider) => [slider.id, slider]));
  const valuesOf = (id: string) => known.get(id)?.values ?? [];
  const at = (id: string) => (place.by === kind ? place[kind][id]! : mixed(valuesOf(id), weights));
  const [across, up] = axes;
  const examples = space.definition.examples.map(({ name }, index) => (
    { name, weight: weights[index] ?? 0, x: valuesOf(across)[index] ?? 0, y: valuesOf(up)[index] ?? 0 }));
  const go = ({ x, y }: Spot) => acts.move((place) => moved(switched(place, kind, space, weights), { [across]: x, [up]: y }));
  const axis = (label: string, value: string, set: (id: string) => Axes) => html`<label><span>${label}</span>
    <select @change=${(event: Event) => acts.choose(set((event.target as HTMLSelectElement).value))}>${shown.map(
      (id) => html`<option value=${id} ?selected=${id === value}>${known.get(id)?.title ?? id}</option>`)}</select></label>`;
  // What one axis shows the other gives up, so that both never show the same.
  return html`<section class="map"><header><h2>Map</h2></header>
    <space-map .examples=${examples} .spot=${{ x: at(across), y: at(up) }} .axes=${[known.get(across)?.title ?? "", known.get(up)?.title ?? ""]}
      @place=${({ detail }: CustomEvent<Spot>) => go(detail)} @example=${({ detail }: CustomEvent<number>) => acts.goTo(detail)}></space-map>
    <div class="map-axes">${axis("Across", across, (id) => [id, id === up ? across : up])}${axis("Up", up, (id) => [id === across ? up : across, id])}</div></section>`;
}
