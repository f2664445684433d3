import { expect, test } from "vitest";
import { Dismissed, withAlert, withoutAlerts, type Alert } from "./alerts";

const texts = (alerts: Alert[]) => alerts.map(({ text, times }) => `${times}x ${text}`);

test("the same sentence, or another one with the same id, stands once and is counted", () => {
  let alerts: Alert[] = [];
  alerts = withAlert(alerts, "warning", "slow");
  alerts = withAlert(alerts, "error", "12 dropped", "drops");
  alerts = withAlert(alerts, "warning", "slow");
  alerts = withAlert(alerts, "error", "13 dropped", "drops");
  expect(texts(alerts)).toEqual(["2x 13 dropped", "2x slow"]);
  expect(texts(withoutAlerts(alerts, ["drops"]))).toEqual(["2x slow"]);
});

test("a flood leaves the newest twenty", () => {
  let alerts: Alert[] = [];
  for (let i = 0; i < 100; ++i) alerts = withAlert(alerts, "error", `flood ${i}`);
  expect(alerts).toHaveLength(20);
  expect(alerts[0]!.text).toBe("flood 99");
});

test("a dismissed warning stays away for five minutes; errors and other warnings do not", () => {
  const dismissed = new Dismissed();
  dismissed.add("drops", 100);
  expect([100, 399, 401].map((now) => dismissed.hides("warning", "drops", now))).toEqual([true, true, false]);
  expect([dismissed.hides("error", "drops", 101), dismissed.hides("warning", "disk", 101)]).toEqual([false, false]);
});
