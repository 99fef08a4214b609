// Which studies take clips, in words, and what came of giving them some. No DOM in here.
import type { components } from "../api-types";
import { counted } from "../library/model";
import { inWords, LANGUAGES } from "./model";

type Schemas = components["schemas"];
export type Draft = Schemas["StudyDraft"];
export type Added = Schemas["ClipsAdded"];

/** A place for clips: a study's part, or a study that has none yet. */
export interface Place {
  slug: string;
  part: string | null;
  title: string;
  about: string;
}

/** What was done, and the way to see it. */
export interface Outcome {
  title: string;
  about: string;
  address: string;
}

export function places(drafts: readonly Draft[]): Place[] {
  return drafts.flatMap((draft) => {
    const place = (part: string | null, about: (string | false)[]): Place => ({
      slug: draft.slug, part, title: draft.title,
      about: [...about, languagesOf(draft), standing(draft)].filter(Boolean).join(" · "),
    });
    if (!draft.parts.length) return [place(null, ["no question yet"])];
    const several = draft.parts.length > 1;
    return draft.parts.map(({ id, task, clips }) => place(id, [several && inWords(id), counted(clips, task === "match" ? "target" : "clip")]));
  });
}

/** The clips of a part in the builder. */
export const address = (slug: string, part: string): string => `/research/studies/${slug}/edit#${part}/stimuli`;

export function outcome(place: Place, { title, part, added, already }: Added, draft: Draft | undefined): Outcome {
  const there = already.length ? ` ${already.length === 1 ? "One was" : `${already.length} were`} there already.` : "";
  const later = draft?.version ? " Participants see them once the next version is published." : "";
  return { title: `Added to ${title}`, about: `${counted(added.length, "new clip")}.${there}${later}`, address: address(place.slug, part) };
}

const languagesOf = ({ languages }: Draft): string =>
  LANGUAGES.filter(([id]) => languages.includes(id)).map(([, name]) => name).join(", ");

const standing = ({ state, version }: Draft): string => (version ? `${state}, for version ${version + 1}` : "not published");
