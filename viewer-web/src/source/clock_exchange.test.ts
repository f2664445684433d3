import { describe, expect, test, vi } from "vitest";
import { ClockExchange, measured } from "./clock_exchange";

describe("a clock exchange", () => {
  test("finds the offset of a server's clock, also of one that is behind, if both ways take equally long", () => {
    for (const offset of [0n, 7n, 3_600_000_000_000n, -5_000_000_000n])
      expect(measured(1_000n + offset, 1_500n, 2_000n + offset)).toEqual({ offset_ns: offset, round_trip_ns: 1_000n });
  });

  test("is wrong by at most half the round trip, also when one way is slower", () => {
    for (const there of [0n, 250n, 1_000n]) {
      const { offset_ns, round_trip_ns } = measured(10_000n, 10_000n + there, 11_000n);
      expect(offset_ns <= round_trip_ns / 2n && offset_ns >= -round_trip_ns / 2n).toBe(true);
    }
  });

  test("reports its measurement with the next call", async () => {
    let time = 1_000n;
    const requests: object[] = [];
    const exchange = new ClockExchange(
      async (request) => {
        requests.push(request);
        time += 200n;
        return { ok: true, received_ns: "900" };
      },
      () => time,
    );
    await exchange.ask();
    await exchange.ask();
    expect(requests).toEqual([{ sent_ns: "1000" }, { sent_ns: "1200", offset_ns: "200", round_trip_ns: "200" }]);
  });

  test("continues after a refusal and after a senseless answer", async () => {
    const requests: object[] = [];
    const answers = [
      Promise.reject(new Error("no")),
      Promise.resolve({ received_ns: "x" }),
      Promise.resolve({ received_ns: "1" }),
    ];
    const exchange = new ClockExchange(
      (request) => (requests.push(request), answers.shift()!),
      () => 5n,
    );
    for (let i = 0; i < 3; ++i) await exchange.ask();
    expect(requests).toEqual([{ sent_ns: "5" }, { sent_ns: "5" }, { sent_ns: "5" }]);
  });

  test("asks at once and then every ten seconds until it is stopped", async () => {
    vi.useFakeTimers();
    const call = vi.fn(async () => ({ received_ns: "1" }));
    const exchange = new ClockExchange(call, () => 1n);
    exchange.start();
    exchange.start();
    expect(call).toHaveBeenCalledTimes(1);
    await vi.advanceTimersByTimeAsync(25_000);
    expect(call).toHaveBeenCalledTimes(3);
    exchange.stop();
    await vi.advanceTimersByTimeAsync(60_000);
    expect(call).toHaveBeenCalledTimes(3);
    vi.useRealTimers();
  });
});
