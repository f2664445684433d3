import { expect, test } from "vitest";
import { Forecasts } from "./forecasts";
import { History } from "./history";
import type { MemoryObject } from "./memory_object";
import { EnumValue, type Fields } from "./value";

const told = (choice: string): Fields =>
  new Map<string, never>([
    ["choice", choice as never],
    ["advice", new EnumValue(2, "ADVICE_CHANGE") as never],
  ]);

test("a robot's forecasts are listed newest first, each read once, and the shown one is that of the moment", () => {
  const history = new History();
  let read = 0;
  const object = {
    history,
    moment: 0n,
    get shown() {
      return history.at(this.moment);
    },
    decode: (data: Uint8Array) => (++read, { fields: told(`s${data[0]}`) }),
    decoded() {
      return this.shown && this.decode(this.shown.data);
    },
  };
  const forecasts = new Forecasts(object as unknown as MemoryObject);
  expect(forecasts.list(5)).toEqual([]);
  expect(forecasts.shown()).toBeUndefined();
  for (let i = 1; i <= 3; ++i) history.add({ log_ns: BigInt(i), data: Uint8Array.of(i), arrived: i });
  expect(forecasts.list(5).map(({ choice, log_ns }) => [choice, log_ns])).toEqual([
    ["s3", 3n],
    ["s2", 2n],
    ["s1", 1n],
  ]);
  expect(forecasts.list(2)).toHaveLength(2);
  expect(read).toBe(3);
  expect(forecasts.shownIndex()).toBe(-1);
  object.moment = 2n;
  expect(forecasts.shown()?.choice).toBe("s2");
  expect(forecasts.shownIndex()).toBe(1);
  object.moment = 3n;
  expect(forecasts.shown()?.choice).toBe("s3");
});
