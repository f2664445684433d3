// The curves of a plot as the page's address keeps them: expressions, separated by spaces. A curve of another server ends
// with its host: "/14/2/ball.x@10.0.14.3:8765".

import { orMistake, parse, print } from "./expression";
import { withJointNames } from "./joints";

/** Splits at spaces that are in no bracket and between no quotes. */
export function curvesOf(setting: string): string[] {
  const curves: string[] = [];
  let [curve, deep, quote] = ["", 0, ""];
  for (const sign of setting) {
    if (quote !== "") {
      if (sign === quote) quote = "";
    } else if (sign === '"' || sign === "'") quote = sign;
    else if (sign === "(" || sign === "[") ++deep;
    else if ((sign === ")" || sign === "]") && deep > 0) --deep;
    if (sign === " " && quote === "" && deep === 0) {
      if (curve !== "") curves.push(curve);
      curve = "";
    } else curve += sign;
  }
  return curve === "" ? curves : [...curves, curve];
}

/** Splits a curve into its expression and its host; undefined: the page's own server. */
export function partsOf(curve: string): { expression: string; host: string | undefined } {
  const [, expression, host] = /^(.*)@([^@'"()\s]+)$/s.exec(curve) ?? [];
  return { expression: expression ?? curve, host };
}

/** Writes an expression that can be parsed so that it is one curve. */
export const curveOf = (expression: string, objects: Iterable<string>): string => print(parse(expression, objects), "");

/** Writes a curve for people: with spaces, and with names of joints for their numbers. */
export function titleOf(curve: string, objects: Iterable<string>): string {
  const { expression, host } = partsOf(curve);
  const printed = orMistake(() => print(parse(expression, objects)));
  return withJointNames(typeof printed === "string" ? printed : expression) + (host ? `@${host}` : "");
}
