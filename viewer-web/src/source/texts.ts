// Text frames of the Foxglove WebSocket protocol v1: one JSON object with an `op`. Nothing in them is trusted.

import { isObject, listOf, textOf } from "./json";

/** A stream that the server offers. `topic` identifies it; its ids are valid for one connection only. */
export interface Channel {
  id: number;
  topic: string;
  encoding: string;
  schemaName: string;
  schema: string;
  metadata: Record<string, string>;
}

export interface ServerInfo {
  name: string;
  capabilities: string[];
  metadata: Record<string, string>;
  sessionId?: string;
  /** [ns since the epoch] The span of the recording that the server plays. */
  span?: { start_ns: bigint; end_ns: bigint };
}

export type Level = "info" | "warning" | "error";

export type ServerText =
  | { op: "serverInfo"; info: ServerInfo }
  | { op: "advertise"; channels: Channel[]; rejected: number }
  | { op: "unadvertise"; channelIds: number[] }
  | { op: "status"; level: Level; message: string; id?: string; cause?: string }
  | { op: "removeStatus"; statusIds: string[] }
  | { op: "parameterValues"; parameters: { name: string; value: unknown }[] }
  | { op: "advertiseServices"; services: { id: number; name: string }[] }
  | { op: "unadvertiseServices"; serviceIds: number[] }
  | { op: "serviceCallFailure"; call: number; message: string }
  | { op: "playhead"; own: boolean }
  | { op: "unknown"; name: string }
  | { op: "malformed"; why: string };

const isText = (value: unknown): value is string => typeof value === "string";
const isId = (value: unknown): value is number =>
  typeof value === "number" && Number.isInteger(value) && value >= 0 && value <= 0xffffffff;

/** Converts the protocol's {"sec": 1, "nsec": 5} to ns. */
function timeOf(value: unknown): bigint | undefined {
  const [sec, nsec] = isObject(value) ? [value["sec"], value["nsec"]] : [];
  const isCount = (part: unknown): part is number =>
    typeof part === "number" && Number.isSafeInteger(part) && part >= 0;
  return isCount(sec) && isCount(nsec) ? BigInt(sec) * 1_000_000_000n + BigInt(nsec) : undefined;
}
const textMapOf = (value: unknown): Record<string, string> =>
  Object.fromEntries(
    Object.entries(isObject(value) ? value : {}).filter((entry): entry is [string, string] => isText(entry[1])),
  );

function channelOf(value: unknown): Channel[] {
  if (!isObject(value) || !isId(value["id"]) || !isText(value["topic"]) || value["topic"] === "") return [];
  return [
    {
      id: value["id"],
      topic: value["topic"],
      encoding: textOf(value["encoding"]),
      schemaName: textOf(value["schemaName"]),
      schema: textOf(value["schema"]),
      metadata: textMapOf(value["metadata"]),
    },
  ];
}

/** Reads one text frame. Never throws: invalid entries are left out, and invalid channels are counted. */
export function readText(text: string): ServerText {
  let fields: unknown;
  try {
    fields = JSON.parse(text);
  } catch {
    return { op: "malformed", why: "text frame: not JSON" };
  }
  if (!isObject(fields) || !isText(fields["op"]))
    return { op: "malformed", why: "text frame: expected an object with 'op'" };

  switch (fields["op"]) {
    case "serverInfo": {
      const info: ServerInfo = {
        name: textOf(fields["name"]),
        capabilities: listOf(fields["capabilities"]).filter(isText),
        metadata: textMapOf(fields["metadata"]),
      };
      if (isText(fields["sessionId"])) info.sessionId = fields["sessionId"];
      const [start_ns, end_ns] = [timeOf(fields["dataStartTime"]), timeOf(fields["dataEndTime"])];
      if (start_ns !== undefined && end_ns !== undefined && start_ns <= end_ns) info.span = { start_ns, end_ns };
      return { op: "serverInfo", info };
    }
    case "advertise": {
      const offered = listOf(fields["channels"]);
      const channels = offered.flatMap(channelOf);
      return { op: "advertise", channels, rejected: offered.length - channels.length };
    }
    case "unadvertise":
      return { op: "unadvertise", channelIds: listOf(fields["channelIds"]).filter(isId) };
    case "status": {
      const level = ({ 0: "info", 1: "warning" } as const)[Number(fields["level"])] ?? "error";
      const message = textOf(fields["message"]);
      const { id, cause } = fields;
      return { op: "status", level, message, ...(isText(id) && { id }), ...(isText(cause) && { cause }) };
    }
    case "removeStatus":
      return { op: "removeStatus", statusIds: listOf(fields["statusIds"]).filter(isText) };
    case "parameterValues":
      return {
        op: "parameterValues",
        parameters: listOf(fields["parameters"]).flatMap((entry) =>
          isObject(entry) && isText(entry["name"]) ? [{ name: entry["name"], value: entry["value"] }] : [],
        ),
      };
    case "advertiseServices":
      return {
        op: "advertiseServices",
        services: listOf(fields["services"]).flatMap((entry) =>
          isObject(entry) && isId(entry["id"]) && isText(entry["name"])
            ? [{ id: entry["id"], name: entry["name"] }]
            : [],
        ),
      };
    case "unadvertiseServices":
      return { op: "unadvertiseServices", serviceIds: listOf(fields["serviceIds"]).filter(isId) };
    case "serviceCallFailure":
      if (!isId(fields["callId"])) return { op: "malformed", why: "serviceCallFailure: 'callId' is not a number" };
      return { op: "serviceCallFailure", call: fields["callId"], message: textOf(fields["message"]) };
    case "playhead":
      return { op: "playhead", own: fields["own"] === true };
    default:
      return { op: "unknown", name: fields["op"] };
  }
}
