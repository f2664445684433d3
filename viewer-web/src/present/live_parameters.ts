// Live parameters for people: search, ranges, refusals, and the file of values.

import type { LiveParameter, ParameterValue } from "../memory/live_parameters";

const kFormat = 1;
const kMostTextBytes = 200;

/** Whether the value is another one than in the process's own file. A button has none. */
export const isChanged = ({ type, value, initial }: LiveParameter): boolean => type !== "button" && value !== initial;

/** Whether all words of `search` are in the parameter's name, description or unit. */
export function isFound({ name, description, unit }: LiveParameter, search: string): boolean {
  const text = `${name} ${description} ${unit}`.toLowerCase();
  return search
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

/** Returns a value for people: "0.02 m", "yes", "fast", "“a b”". */
export function valueWords({ type, unit }: Pick<LiveParameter, "type" | "unit">, value: ParameterValue): string {
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value === "number") return unit ? `${numberWord(value)} ${unit}` : numberWord(value);
  return type === "text" ? `“${value}”` : value;
}

/** A number without the noise of floating point: 0.3, not 0.30000000000000004. */
export const numberWord = (value: number): string => String(Number(value.toPrecision(12)));

/** Returns how often a button was pressed: "pressed once". */
export const pressesWords = (presses: number): string =>
  presses === 0 ? "not pressed yet" : `pressed ${["", "once", "twice"][presses] ?? `${presses} times`}`;

/** Returns the range in words: "0 to 0.05 m", "at least 1", "" without limits. */
export function rangeWords(parameter: LiveParameter): string {
  const { min, max } = parameter;
  // the limits of a whole number that has no range of its own
  const low = min > -(2 ** 31), high = max < 2 ** 31 - 1; // prettier-ignore
  if (low && high) return `${numberWord(min)} to ${valueWords(parameter, max)}`;
  if (low) return `at least ${valueWords(parameter, min)}`;
  return high ? `at most ${valueWords(parameter, max)}` : "";
}

/** Whether a slider can show the value. */
export const hasSlider = ({ type, min, max }: LiveParameter): boolean =>
  (type === "number" || type === "whole") && max - min < (type === "whole" ? 10_000 : Infinity);

/** Returns the slider's step: a round part of the range, 100 to 500 steps. */
export function stepOf({ type, min, max }: LiveParameter): number {
  if (type === "whole") return 1;
  const part = (max - min) / 100;
  const power = 10 ** Math.floor(Math.log10(part));
  return [5, 2, 1].map((digit) => digit * power).find((step) => step <= part * 1.000001) ?? power;
}

/** Returns why `value` is not allowed, in one sentence, or "". */
export function refusalOf(parameter: LiveParameter, value: unknown): string {
  const { name, type, min, max, choices } = parameter;
  const no = (expected: string) => `${name}: expected ${expected}, got ${shown(value)}.`;
  switch (type) {
    case "yes_no":
      return typeof value === "boolean" ? "" : no("true or false");
    case "choice":
      return choices.includes(value as string) ? "" : no(`one of ${choices.join(", ")}`);
    case "text":
      if (typeof value !== "string") return no("a text");
      return new TextEncoder().encode(value).length <= kMostTextBytes
        ? ""
        : `${name}: expected a text of at most ${kMostTextBytes} bytes.`;
    case "button":
    case "whole":
    case "number": {
      const words = type === "number" ? "a number" : "a whole number";
      if (typeof value !== "number" || !Number.isFinite(value)) return no(words);
      if (type !== "number" && !Number.isSafeInteger(value)) return no(words);
      return value >= min && value <= max ? "" : no(rangeWords(parameter) || words);
    }
  }
}

function shown(value: unknown): string {
  const text = typeof value === "number" ? String(value) : (JSON.stringify(value) ?? "nothing");
  return text.length > 60 ? `${text.slice(0, 60)}…` : text;
}

// the file

/** Returns the text of a file with the values of all parameters whose process runs. Presses of buttons are no values. */
export function textOfValues(parameters: LiveParameter[]): string {
  const kept = parameters.filter(({ type, gone }) => type !== "button" && !gone);
  const values = Object.fromEntries(kept.map(({ name, value }) => [name, value]));
  return `${JSON.stringify({ foresight_parameters: kFormat, values }, null, 2)}\n`;
}

export interface LoadedValues {
  /** The values that differ from those that hold. */
  changes: Map<string, ParameterValue>;
  /** One sentence for each value that is not loaded. */
  problems: string[];
}

/** Parses a file of any kind. Returns one sentence if it is no file of values. */
export function valuesOf(text: string, parameters: LiveParameter[]): LoadedValues | { error: string } {
  const no = (why: string) => ({ error: `This is no file of parameters: ${why}.` });
  let file: unknown;
  try {
    file = JSON.parse(text);
  } catch {
    return no("it is not JSON");
  }
  const isObject = (value: unknown): value is Record<string, unknown> =>
    typeof value === "object" && value !== null && !Array.isArray(value);
  if (!isObject(file)) return no("expected an object");
  const { foresight_parameters: format, values } = file;
  if (format !== kFormat) return no(`expected 'foresight_parameters' to be ${kFormat}, got ${shown(format)}`);
  if (!isObject(values)) return no("'values' is no object");

  const known = new Map(parameters.map((parameter) => [parameter.name, parameter]));
  const changes = new Map<string, ParameterValue>();
  const problems: string[] = [];
  for (const [name, value] of Object.entries(values)) {
    const parameter = known.get(name);
    const problem = !parameter
      ? `${shown(name)}: no process announces this parameter.`
      : parameter.gone
        ? `${name}: its process has disconnected.`
        : parameter.type === "button"
          ? `${name}: a file presses no button.`
          : refusalOf(parameter, value);
    if (problem) problems.push(problem);
    else if (parameter!.value !== value) changes.set(name, value as ParameterValue);
  }
  return { changes, problems };
}
