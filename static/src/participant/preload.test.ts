import { describe, expect, it } from "vitest";
import { Preloader } from "./preload";
import { seeded } from "./testing";

const plan = Array.from({ length: 8 }, (_, index) => [`clip-${index}`, `body-${index % 2}`]);
const keep = () => "kept";
const settled = () => new Promise((resolve) => setTimeout(resolve, 0));

function recorded(fail: (url: string, attempt: number) => boolean = () => false) {
  const asked: string[] = [];
  let open = 0;
  let most = 0;
  const fetch = async (url: string) => {
    asked.push(url);
    most = Math.max(most, ++open);
    await Promise.resolve();
    open -= 1;
    if (fail(url, asked.filter((other) => other === url).length)) throw new TypeError("no line");
    return new ArrayBuffer(1);
  };
  return { asked, fetch, most: () => most };
}

describe("the clips of the next trials", () => {
  it("come after the current one's, two trials ahead and no further", async () => {
    const { asked, fetch } = recorded();
    const preloader = new Preloader(plan, { fetch, keep });
    await preloader.want(0);
    await settled();
    expect(asked).toEqual(["clip-0", "body-0", "clip-1", "body-1", "clip-2"]);
  });

  it("are fetched one at a time and each only once over the whole study", async () => {
    const { asked, fetch, most } = recorded();
    const preloader = new Preloader(plan, { fetch, keep });
    for (const index of plan.keys()) await preloader.want(index);
    await settled();
    expect(most()).toBe(1);
    expect([...asked].sort()).toEqual([...new Set(plan.flat())].sort());
  });

  it("are there without asking when their trial begins", async () => {
    const { asked, fetch } = recorded();
    const preloader = new Preloader(plan, { fetch, keep });
    await preloader.want(0);
    await settled();
    expect([1, 2].map((index) => preloader.share(index))).toEqual([1, 1]);
    const before = asked.length;
    await preloader.want(1);
    await settled();
    expect(asked.slice(before)).toEqual(["clip-3"]);
  });
});

it("a file that fails is asked for again until it comes", async () => {
  for (let seed = 0; seed < 20; seed++) {
    const random = seeded(seed);
    const { asked, fetch } = recorded((_, attempt) => attempt < 5 && random() < 0.6);
    const preloader = new Preloader(plan, { fetch, keep, wait: () => Promise.resolve() });
    for (const index of plan.keys()) expect(await preloader.want(index)).toEqual(["kept", "kept"]);
    await settled();
    expect(new Set(asked)).toEqual(new Set(plan.flat()));
  }
});

it("a person who goes on before the clip is there gets the clip of the new place first", async () => {
  const asked: string[] = [];
  const release: (() => void)[] = [];
  const fetch = (url: string) => {
    asked.push(url);
    return new Promise<ArrayBuffer>((resolve) => release.push(() => resolve(new ArrayBuffer(1))));
  };
  const preloader = new Preloader(plan, { fetch, keep });
  void preloader.want(0);
  void preloader.want(4);
  release.shift()?.();
  await settled();
  expect(asked).toEqual(["clip-0", "clip-4"]);
});

it("tells how much of a trial is there", async () => {
  let tell = (_share: number) => {};
  const fetch = (_url: string, onShare: (share: number) => void) => {
    tell = onShare;
    return new Promise<ArrayBuffer>(() => {});
  };
  const preloader = new Preloader(plan, { fetch, keep });
  void preloader.want(0);
  expect(preloader.share(0)).toBe(0);
  tell(0.5);
  expect(preloader.share(0)).toBe(0.25);
});
