// Answers of a server about the whole of the recording that it plays, also about parts that the page has not seen.
// Nothing in the answers is trusted.

import { isObject, listOf, textOf, type Json } from "./json";

const kPath = "/api/whole/";
const kPatienceMs = 120_000; // a first reading of a recording of hours

/** One event of the recording. `kind` may be one that the page does not know. */
export interface WholeEvent {
  log_ns: bigint;
  kind: string;
  text: string;
  robot: string;
}

/** Minimum, maximum and mean of a number per interval of time; NaN in an interval without a value. */
export interface WholeNumbers {
  field: string;
  from_ns: bigint;
  step_ns: number;
  least: Float64Array;
  most: Float64Array;
  mean: Float64Array;
  /** The reason why there are no values, or "". */
  problem: string;
}

/** A time in which the words of some fields stayed the same. */
export interface WholeRun {
  from_ns: bigint;
  to_ns: bigint;
  words: string[];
}

/** Fetches one answer as JSON. Rejects with a sentence. */
async function ask(question: string, parameters: Record<string, string>, signal?: AbortSignal): Promise<Json> {
  const patience = AbortSignal.timeout(kPatienceMs);
  let response: Response;
  try {
    response = await fetch(`${kPath}${question}?${new URLSearchParams(parameters)}`, {
      signal: signal ? AbortSignal.any([signal, patience]) : patience,
    });
  } catch {
    throw new Error("The server does not answer.");
  }
  if (!response.ok) throw new Error(`The server does not summarise its recording (HTTP ${response.status}).`);
  const answer: unknown = await response.json().catch(() => undefined);
  if (!isObject(answer)) throw new Error("The summary of the recording cannot be read.");
  return answer;
}

/** Fetches all events of the recording, in order of time. Rejects with a sentence. */
export const fetchEvents = async (signal?: AbortSignal): Promise<WholeEvent[]> =>
  eventsIn(await ask("events", {}, signal));

/** Fetches the summaries of some fields between two capture times [ns]. Rejects with a sentence. */
export const fetchNumbers = async (
  fields: string[],
  { from_ns, to_ns }: { from_ns: bigint; to_ns: bigint },
  intervals: number,
  signal?: AbortSignal,
): Promise<WholeNumbers[]> =>
  numbersIn(
    await ask(
      "numbers",
      { fields: fields.join(" "), from: String(from_ns), to: String(to_ns), intervals: String(intervals) },
      signal,
    ),
  );

/** Fetches the runs of some fields of a topic. Rejects with a sentence. */
export const fetchRuns = async (topic: string, fields: string[], signal?: AbortSignal): Promise<WholeRun[]> =>
  runsIn(await ask("runs", { topic, fields: fields.join(" ") }, signal));

const timeIn = (value: unknown): bigint | undefined =>
  /^\d{1,20}$/.test(textOf(value)) ? BigInt(textOf(value)) : undefined;
const isAmount = (value: unknown): value is number => typeof value === "number" && Number.isFinite(value) && value >= 0;

/** Returns the events of an answer. Those without a time are left out. */
export function eventsIn(answer: Json): WholeEvent[] {
  return listOf(answer["events"]).flatMap((event) => {
    const log_ns = isObject(event) ? timeIn(event["at"]) : undefined;
    if (!isObject(event) || log_ns === undefined) return [];
    return [{ log_ns, kind: textOf(event["kind"]), text: textOf(event["text"]), robot: textOf(event["robot"]) }];
  });
}

/** Returns the summaries of an answer. Throws a sentence if it has no time. */
export function numbersIn(answer: Json): WholeNumbers[] {
  const [from_ns, step_ns] = [timeIn(answer["from"]), answer["step_ns"]];
  if (from_ns === undefined || !isAmount(step_ns) || step_ns < 1)
    throw new Error("The summary of the recording does not say its time.");
  return listOf(answer["fields"])
    .filter(isObject)
    .map((one) => {
      const [least, most, mean] = ["least", "most", "mean"].map((name) => valuesIn(one[name]));
      const count = Math.min(least!.length, most!.length, mean!.length);
      return {
        field: textOf(one["field"]),
        from_ns,
        step_ns,
        least: least!.subarray(0, count),
        most: most!.subarray(0, count),
        mean: mean!.subarray(0, count),
        problem: textOf(one["problem"]),
      };
    });
}

const valuesIn = (value: unknown): Float64Array =>
  Float64Array.from(listOf(value), (one) => (typeof one === "number" ? one : NaN));

/** Returns the runs of an answer. Throws a sentence if it has no time; runs that cannot be read are left out. */
export function runsIn(answer: Json): WholeRun[] {
  const start_ns = timeIn(answer["from"]);
  if (start_ns === undefined) throw new Error("The runs of the recording do not say their time.");
  const words = listOf(answer["words"]).map(textOf);
  return listOf(answer["runs"]).flatMap((run) => {
    const [begin, length, ...indices] = listOf(run);
    if (!isAmount(begin) || !isAmount(length)) return [];
    const from_ns = start_ns + BigInt(Math.round(begin));
    return [
      { from_ns, to_ns: from_ns + BigInt(Math.round(length)), words: indices.map((i) => words[i as number] ?? "") },
    ];
  });
}
