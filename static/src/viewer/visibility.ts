/** Whether a person can see an element: on screen, in a tab that is shown. */

export class Visibility {
  private onScreen = true;
  private readonly observer: IntersectionObserver;
  private readonly changed = () => this.notify();

  constructor(
    private readonly element: Element,
    private readonly notify: () => void,
  ) {
    this.observer = new IntersectionObserver((entries) => {
      this.onScreen = entries.at(-1)!.isIntersecting;
      this.notify();
    });
  }

  get visible(): boolean {
    return this.onScreen && document.visibilityState === "visible";
  }

  start(): void {
    this.observer.observe(this.element);
    document.addEventListener("visibilitychange", this.changed);
  }

  stop(): void {
    this.observer.disconnect();
    document.removeEventListener("visibilitychange", this.changed);
  }
}
