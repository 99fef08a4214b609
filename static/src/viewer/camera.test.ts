import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { fit, OrbitCamera, subjectPoints, type Frame, type Subject } from "./camera";
import { looks } from "./looks";

const one: Subject = { places: [0], discRadius: 0.6, low: -0.12, high: 1.7, reach: 0.45 };
const pair: Subject = { ...one, places: [-0.55, 0.55], discRadius: 0.46 };
const desktop: Frame = { width: 690, height: 636, top: 24, bottom: 84, side: 8 };
const phone: Frame = { width: 390, height: 292, top: 24, bottom: 50, side: 8 };
const tall: Frame = { width: 390, height: 844, top: 24, bottom: 84, side: 8 };

/** Where three's own camera draws each point, in pixels from the upper left. */
function drawn(camera: PerspectiveCamera, subject: Subject, frame: Frame): [number, number][] {
  const points = subjectPoints(subject);
  camera.updateMatrixWorld();
  return Array.from({ length: points.length / 3 }, (_, k) => {
    const point = new Vector3().fromArray(points as unknown as number[], 3 * k).project(camera);
    return [((point.x + 1) / 2) * frame.width, ((1 - point.y) / 2) * frame.height];
  });
}

function looking(subject: Subject, frame: Frame, azimuth: number, elevation: number) {
  const orbit = new OrbitCamera();
  orbit.setSubject(subject, looks.camera.azimuth);
  orbit.setFrame(frame);
  orbit.jump(azimuth);
  orbit.orbit(0, elevation - orbit.elevation);
  return orbit;
}

describe("the camera", () => {
  for (const [name, subject] of Object.entries({ one, pair })) {
    for (const [size, frame] of Object.entries({ desktop, phone, tall })) {
      it(`shows all of ${name} on a ${size} stage from every side, clear of the controls`, () => {
        for (let azimuth = -180; azimuth < 180; azimuth += 45) {
          for (const elevation of [0, 7, 60]) {
            const { camera } = looking(subject, frame, azimuth, elevation);
            for (const [x, y] of drawn(camera, subject, frame)) {
              expect(x).toBeGreaterThan(frame.side - 0.5);
              expect(x).toBeLessThan(frame.width - frame.side + 0.5);
              expect(y).toBeGreaterThan(frame.top - 0.5);
              expect(y).toBeLessThan(frame.height - frame.bottom + 0.5);
            }
          }
        }
      });
    }
  }

  it("comes as near as the frame allows: the height or the width is used up", () => {
    for (const frame of [desktop, phone, tall]) {
      const { camera } = looking(one, frame, 32, 7);
      const spots = drawn(camera, one, frame);
      const span = (axis: 0 | 1) =>
        Math.max(...spots.map((s) => s[axis])) - Math.min(...spots.map((s) => s[axis]));
      const use = Math.max(
        span(0) / (frame.width - 2 * frame.side),
        span(1) / (frame.height - frame.top - frame.bottom),
      );
      expect(use).toBeCloseTo(1, 3);
    }
  });

  it("keeps a lone figure's size while it is turned around", () => {
    const points = subjectPoints(one);
    const distances = [0, 45, 90, 133].map(
      (azimuth) => fit(points, 0.85, azimuth, 7, 21, desktop).distance,
    );
    distances.forEach((distance) => expect(distance).toBeCloseTo(distances[0]!, 1));
  });

  it("flies to a view in the time of a preset and by the shorter way", () => {
    const orbit = looking(one, desktop, 170, 7);
    orbit.flyTo(-170, false);
    orbit.advance(looks.camera.azimuth);
    expect(Math.abs(orbit.azimuth)).toBeGreaterThan(169);
    orbit.advance(420);
    expect([orbit.azimuth, orbit.flying]).toEqual([-170, false]);
  });

  it("is there at once for people who want stillness", () => {
    const orbit = looking(one, desktop, 90, 30);
    orbit.reset(true);
    expect([orbit.azimuth, orbit.elevation, orbit.moved]).toEqual([32, 7, false]);
  });

  it("never goes below the floor or over the top", () => {
    const orbit = looking(one, desktop, 0, 7);
    orbit.orbit(0, -500);
    expect(orbit.elevation).toBe(0);
    orbit.orbit(0, 500);
    expect(orbit.elevation).toBe(75);
  });
});

describe("room for a motion that reaches farther", () => {
  const farther = { ...one, high: 2.1, reach: 0.9 };

  it("is made in the time of a preset, beginning where the camera stood", () => {
    const orbit = looking(one, desktop, 32, 7);
    const before = orbit.camera.position.length();
    orbit.makeRoom(farther, false);
    expect(orbit.camera.position.length()).toBe(before);
    orbit.advance(20);
    const between = orbit.camera.position.length();
    orbit.advance(420);
    expect(orbit.flying).toBe(false);
    const after = looking(farther, desktop, 32, 7).camera.position.length();
    expect(orbit.camera.position.length()).toBeCloseTo(after, 6);
    expect(between).toBeGreaterThan(before);
    expect(between).toBeLessThan(after);
  });

  it("is kept when the next motion needs less, so that nothing pumps", () => {
    const orbit = looking(farther, desktop, 32, 7);
    orbit.makeRoom(one, false);
    expect(orbit.flying).toBe(false);
  });

  it("does not end a flight to another view", () => {
    const orbit = looking(one, desktop, 32, 7);
    orbit.flyTo(90, false);
    orbit.makeRoom(farther, false);
    orbit.advance(420);
    expect([orbit.azimuth, orbit.flying]).toEqual([90, false]);
  });
});
