// One drag of the pointer over an element, told as shares of its width.

export interface Drag {
  move(share: number): void;
  /** `moved`: farther than a trembling finger does. */
  end(moved: boolean): void;
}

const TREMBLE = 4;

export function follow(down: PointerEvent, element: HTMLElement, drag: Drag): void {
  const over = new AbortController();
  const { signal } = over;
  let moved = false;
  const tell = (event: PointerEvent) => {
    const { left, width } = element.getBoundingClientRect();
    moved ||= Math.abs(event.clientX - down.clientX) > TREMBLE;
    drag.move(width > 0 ? Math.min(Math.max((event.clientX - left) / width, 0), 1) : 0);
  };
  const own = (act: (event: PointerEvent) => void) => (event: PointerEvent) => {
    if (event.pointerId === down.pointerId) act(event);
  };
  const end = own(() => {
    over.abort();
    drag.end(moved);
  });
  element.setPointerCapture(down.pointerId);
  element.addEventListener("pointermove", own(tell), { signal });
  element.addEventListener("pointerup", end, { signal });
  element.addEventListener("pointercancel", end, { signal });
  tell(down);
}
