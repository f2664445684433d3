import { expect, test, vi } from "vitest";
import { readPicture } from "./sensor_image.svelte";

const kDepth = new Map<string, unknown>([
  ["width", 2],
  ["height", 1],
  ["encoding", "16UC1"],
  ["data", new Uint8Array([1, 0, 2, 0])],
]);

/** An object that shows one image, or none. */
function objectWith(decoded: object | undefined) {
  const object = {
    shown: decoded && { log_ns: 1n, data: new Uint8Array(), arrived: 0 },
    decoded: vi.fn(() => decoded),
  };
  return { object, read: () => readPicture(object as never) };
}

test("an image is read once for all views, and again when another is shown", () => {
  const { object, read } = objectWith({ fields: kDepth });
  const first = read();
  expect(first).toMatchObject({ picture: { kind: "depth", width: 2, height: 1 }, problem: "" });
  expect(read()).toBe(first);
  expect(object.decoded).toHaveBeenCalledTimes(1);
  object.shown = { ...object.shown! };
  expect(read()).not.toBe(first);
});

test("an image that cannot be decoded or drawn has a sentence instead of a picture", () => {
  expect(objectWith({ error: "It does not fit." }).read()).toEqual({ picture: undefined, problem: "It does not fit." });
  const { picture, problem } = objectWith({ fields: new Map([...kDepth, ["encoding", "jpeg"]]) }).read();
  expect([picture, problem]).toEqual([undefined, expect.stringContaining("'jpeg'")]);
});

test("without an image there is neither a picture nor a problem", () => {
  expect(objectWith(undefined).read()).toEqual({ picture: undefined, problem: "" });
  expect(readPicture(undefined)).toEqual({ picture: undefined, problem: "" });
});
