import { expect, test } from "vitest";
import { ApiError } from "../api";
import { History } from "./history";
import { Staging } from "./staging";

const refused = new ApiError("refused", "No.", null, null, 400);

class Words extends Staging<string> {
  readonly history = new History("one");
  private answer: { resolve(): void; reject(error: ApiError): void } | null = null;

  constructor() {
    super(() => {});
  }

  protected override get wish(): string {
    return this.history.present;
  }

  protected override put(): Promise<void> {
    return new Promise((resolve, reject) => (this.answer = { resolve, reject }));
  }

  protected override check = (): Promise<void> => Promise.resolve();

  override refresh(): void {
    this.shows.ask(this.wish);
  }

  async answered(error?: ApiError): Promise<void> {
    if (error) this.answer!.reject(error);
    else this.answer!.resolve();
    await new Promise((done) => setTimeout(done));
  }
}

test("the stage is busy whenever what is wished is asked for, again after a refusal too", async () => {
  const words = new Words();
  words.refresh();
  expect(words.isBusy).toBe(true);
  await words.answered(refused);
  expect([words.isBusy, words.isShown, words.problem]).toEqual([false, false, refused]);
  words.retry();
  expect([words.isBusy, words.problem]).toEqual([true, refused]);
  await words.answered();
  expect([words.isBusy, words.isShown, words.problem]).toEqual([false, true, null]);
});

test("of what is wished while a motion is on its way, only the newest is asked for", async () => {
  const words = new Words();
  words.refresh();
  for (const word of ["two", "three"]) {
    words.history.set(word, word);
    words.refresh();
  }
  await words.answered();
  expect([words.isBusy, words.isShown]).toEqual([true, false]);
  await words.answered();
  expect([words.isBusy, words.isShown]).toEqual([false, true]);
});
