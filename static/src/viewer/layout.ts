/** How much of the stage is left to the figure. */
import type { Frame } from "./camera";
import { looks } from "./looks";

export interface Furniture {
  /** No controls at all: a picture, which needs only a little air. */
  bare: boolean;
  /** Heights in CSS pixels; 0 where there is none. */
  bar: number;
  words: number;
  head: number;
}

/** A stage lower than this is a phone's. */
const PHONE_STAGE = 400;
const PHONE_PAD = 50;
const BARE_PAD = 12;
const SIDE_PAD = 8;

/** What takes room on the stage: the controls if any, the legend, and words about the motion. */
export function furnish(
  controls: { bar: HTMLElement; views: HTMLElement | null } | null,
  legend: HTMLElement,
  overlay: HTMLElement,
): Furniture {
  return {
    bare: controls === null,
    bar: controls?.bar.hidden === false ? controls.bar.offsetHeight : 0,
    words: (overlay.firstElementChild as HTMLElement | null)?.offsetHeight ?? 0,
    head: Math.max(legend.hidden ? 0 : 24, controls?.views?.offsetHeight ?? 0),
  };
}

export function stageFrame(width: number, height: number, furniture: Furniture): Frame {
  const { padTop, padControls } = looks.camera.fit;
  const { bare, bar, words, head } = furniture;
  const usual = height < PHONE_STAGE ? PHONE_PAD : padControls;
  return {
    width,
    height,
    top: (bare ? BARE_PAD : padTop) + head,
    bottom: Math.max(bare ? BARE_PAD : usual, bar + 4, words),
    side: SIDE_PAD,
  };
}
