// A short summary of a recording: its events and the agent's skills, from its small objects.

import { byTime } from "../source/by_time";
import { recordedIn, type Recorded } from "../source/mcap";
import { decoderOf } from "./decoder";
import { changesTold, type EventKind } from "./game_events";
import type { DecisionTrace, RobotObject } from "./schema";
import { textOf, type Fields } from "./value";

export interface Summary {
  /** In order of time. */
  events: { log_ns: bigint; kind: EventKind; text: string }[];
  /** The agent's skill from each moment on. */
  skills: { from_ns: bigint; skill: string }[];
}

/** The objects that are read. The size of each is limited, so that a list of recordings appears at once. */
export const kSummarised: readonly string[] = ["game", "motion_status", "decision"] satisfies RobotObject[];
export const kMostSummarised = 4_000_000; // [bytes]

const kMostEvents = 500;

/** Summarises the files of these objects. Unreadable parts are left out. */
export function summaryOf(files: { name: string; file: Uint8Array }[]): Summary {
  const summary: Summary = { events: [], skills: [] };
  for (const { name, file } of files) {
    const recorded = recordedIn(file);
    if (name === ("decision" satisfies RobotObject)) readSkills(recorded, summary);
    else readEvents(name, recorded, summary);
  }
  summary.events.sort(byTime);
  summary.events.splice(kMostEvents);
  return summary;
}

function* decoded({ encoding, schemaName, schema, messages }: Recorded): Generator<{ log_ns: bigint; fields: Fields }> {
  const decode = decoderOf({ encoding, schemaName, schema });
  for (const { log_ns, data } of messages) {
    const { fields } = decode(data);
    if (fields) yield { log_ns, fields };
  }
}

function readEvents(name: string, recorded: Recorded, summary: Summary): void {
  const changes = changesTold(name);
  let before: Fields | undefined;
  for (const { log_ns, fields } of changes ? decoded(recorded) : []) {
    for (const change of before ? changes!(before, fields) : []) summary.events.push({ log_ns, ...change });
    before = fields;
  }
}

function readSkills(recorded: Recorded, { skills }: Summary): void {
  const skillOf = (decision: Fields<DecisionTrace>) => textOf(decision, "skill");
  for (const { log_ns, fields } of decoded(recorded)) {
    const skill = skillOf(fields);
    if (skills.at(-1)?.skill !== skill) skills.push({ from_ns: log_ns, skill });
  }
}
