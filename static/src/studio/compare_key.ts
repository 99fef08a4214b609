// The key that compares: held it shows the original until it is let go, tapped it stays.

const TAP = 300;

export class CompareKey {
  private downAt: number | null = null;

  constructor(
    private readonly isOriginal: () => boolean,
    private readonly show: (original: boolean) => void,
  ) {}

  down(event: KeyboardEvent): void {
    if (event.repeat) return;
    this.downAt = event.timeStamp;
    this.show(!this.isOriginal());
  }

  up(event: KeyboardEvent): void {
    if (this.downAt !== null && event.timeStamp - this.downAt > TAP) this.show(!this.isOriginal());
    this.downAt = null;
  }
}
