/** Reads from the page's markup who is to be shown, and fetches them. */
import { loadBody, loadClip, type Progress } from "./assets";
import { isRole, type FigureRole, type GhostKind } from "./looks";
import type { Performer } from "./stage";

export interface Wanted {
  src: string;
  figure: string;
  role: FigureRole;
  ghost: GhostKind | null;
  label: string;
}

/** The viewer's own clip, or one for each `<motion-figure>` inside it. */
export function wantedFigures(viewer: HTMLElement): Wanted[] {
  const children = [...viewer.querySelectorAll("motion-figure")];
  const holders = children.length > 0 ? children : [viewer];
  return holders
    .map((holder) => readWanted(holder, viewer.getAttribute("figure") ?? ""))
    .filter((wanted) => wanted.src !== "");
}

function readWanted(holder: Element, figure: string): Wanted {
  const src = holder.getAttribute("src") ?? "";
  const named = holder.getAttribute("as") ?? holder.getAttribute("role");
  const role = isRole(named) ? named : "clay";
  const kind = role === "original" ? "original" : "target";
  return {
    src,
    // A downloaded clip carries its own body.
    figure: holder.getAttribute("figure") ?? (figure || src),
    role,
    ghost: holder.hasAttribute("ghost") ? kind : null,
    label: holder.getAttribute("label") ?? "",
  };
}

export async function fetchPerformers(wanted: Wanted[], progress: Progress): Promise<Performer[]> {
  const shares = wanted.map(() => ({ loaded: 0, total: 0 }));
  return Promise.all(
    wanted.map(async ({ src, figure, role, ghost }, index) => {
      const note: Progress = (loaded, total) => {
        shares[index] = { loaded, total };
        const sum = (key: "loaded" | "total") => shares.reduce((all, one) => all + one[key], 0);
        progress(sum("loaded"), sum("total"));
      };
      const [clip, body] = await Promise.all([loadClip(src, note), loadBody(figure)]);
      return { clip, body, role, ghost };
    }),
  );
}
