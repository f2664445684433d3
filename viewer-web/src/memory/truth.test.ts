import { expect, test } from "vitest";
import { memoryWith } from "./test_memory";
import { comparesDepths, labelOf, sensorNumbers, sensorOf, thingsIn, truthOf } from "./truth";
import { EnumValue, type Value } from "./value";

const fields = (entries: Record<string, Value>) => new Map(Object.entries(entries));
const kPinhole = { width: 640, height: 480, focal_x: 575, focal_y: 576, centre_x: 320, centre_y: 240 };
const kPlace = { rotation: [1, 0, 0, 0, 0, 1, 0, -1, 0], x: 0, y: -4, z: 2, depth_scale: 1.01, error_mean: 0.01 };

test("a thing has its velocity, covariance and track only if they are reported", () => {
  const whole = {
    x: 1,
    y: 2,
    velocity_x: 0.5,
    velocity_y: 0,
    covariance: fields({ xx: 1e-4, xy: 0, yy: 2e-4 }),
    track: 7,
  };
  const { robots, ball } = truthOf(fields({ robots: [fields(whole), fields({ x: 3, y: 4 }), fields({ x: 3 })] }));
  expect(ball).toBeUndefined();
  expect(robots).toHaveLength(2);
  expect(robots[0]).toMatchObject({ velocity: { x: 0.5, y: 0 }, covariance: { xx: 1e-4 }, track: 7, name: "" });
  expect(robots[1]).toMatchObject({ velocity: undefined, covariance: undefined, track: undefined, sensors: 0 });
});

test("a thing is labelled with its player's number, else with its track", () => {
  const label = (more: Record<string, Value>) =>
    labelOf(truthOf(fields({ ball: fields({ x: 0, y: 0, ...more }) })).ball!);
  expect(label({ team: 14, player: 2, track: 9 })).toBe("2");
  expect(label({ track: 9 })).toBe("#9");
  expect(label({})).toBe("");
});

test("the things of a truth are its robots, then the ball", () => {
  const [robot, ball] = [fields({ x: 1, y: 2 }), fields({ x: 3, y: 4 })];
  expect(thingsIn(truthOf(fields({ robots: [robot], ball }))).map(({ x }) => x)).toEqual([1, 3]);
  expect(thingsIn(truthOf(fields({ robots: [robot] }))).map(({ x }) => x)).toEqual([1]);
  expect(thingsIn(undefined)).toEqual([]);
});

test("sensors are found by their topics, sorted by number", () => {
  const topics = [
    "/truth/10/sensor",
    "/truth/2/sensor",
    "/truth/2/depth",
    "/truth/world",
    "/14/2/sensor",
    "/truth/x/sensor",
  ];
  const objects = topics.map((topic) => ({ channel: { topic } }));
  expect(sensorNumbers({ ...memoryWith({ get: () => undefined }), objects: () => objects } as never)).toEqual([2, 10]);
});

test("a sensor with a whole pinhole and place can be projected, and one without is not calibrated", () => {
  const report = { state: new EnumValue(2, "STATE_WATCHING"), pinhole: fields(kPinhole), place: fields(kPlace) };
  expect(sensorOf(fields(report))).toMatchObject({
    state: "watching",
    pinhole: { width: 640, focal: { x: 575, y: 576 } },
    place: { at: { x: 0, y: -4, z: 2 }, depthScale: 1.01 },
    errorMean: 0.01,
  });
  const none = sensorOf(fields({}));
  expect([none.state, none.pinhole, none.place, none.robots]).toEqual(["", undefined, undefined, []]);
  for (const wrong of [{ rotation: [1, 0] }, { x: NaN }])
    expect(sensorOf(fields({ place: fields({ ...kPlace, ...wrong }) })).place).toBeUndefined();
  for (const name of Object.keys(kPinhole))
    expect(sensorOf(fields({ pinhole: fields({ ...kPinhole, [name]: undefined }) })).pinhole).toBeUndefined();
});

test("refused tags are counted, and a depth camera has no counts", () => {
  expect(sensorOf(fields({})).refusedTags).toBeUndefined();
  expect(sensorOf(fields({ refused_tags: undefined })).refusedTags).toBeUndefined();
  const refused_tags = fields({ unknown: 3n, implausible: 1n });
  expect(sensorOf(fields({ refused_tags })).refusedTags).toEqual({
    unknown: 3,
    repeated: 0,
    implausible: 1,
    contradictory: 0,
  });
});

test("images of the empty field are counted, and a calibrated depth camera compares its depths with them", () => {
  expect(sensorOf(fields({})).background).toEqual({ images: 0, awaited: 0 });
  const learning = sensorOf(fields({ background_images: 7, background_awaited: 8, place: fields(kPlace) }));
  expect(learning.background).toEqual({ images: 7, awaited: 8 });
  expect(comparesDepths(learning)).toBe(true);
  expect(comparesDepths(sensorOf(fields({})))).toBe(false);
  expect(comparesDepths(sensorOf(fields({ place: fields(kPlace), refused_tags: fields({}) })))).toBe(false);
});
