import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { causeOf } from "./calls";
import { Client, type Connection, type Listener, type Socket } from "./client";

/** The server's end of a connection. `sent` holds the messages of the client. */
class FakeSocket implements Socket {
  binaryType = "";
  onmessage: Socket["onmessage"] = null;
  onclose: Socket["onclose"] = null;
  sent: (Record<string, unknown> | Uint8Array)[] = [];
  closed = false;

  send(data: string | Uint8Array) {
    this.sent.push(typeof data === "string" ? JSON.parse(data) : data);
  }
  close() {
    this.closed = true;
  }
  say(...messages: object[]) {
    for (const message of messages) this.onmessage?.({ data: JSON.stringify(message) });
  }
  frame(...bytes: number[]) {
    this.onmessage?.({ data: Uint8Array.from(bytes).buffer });
  }
  /** Returns the messages with this op that were sent since the last call. */
  take(op: string) {
    const found = this.sent.filter((message) => !(message instanceof Uint8Array) && message["op"] === op);
    this.sent = this.sent.filter((message) => !found.includes(message));
    return found;
  }
}

const kChannel = { id: 3, topic: "/14/2/ball", encoding: "protobuf", schemaName: "foresight.Ball", schema: "AA==" };
const kInfo = { op: "serverInfo", name: "robot", capabilities: [], sessionId: "one" };

let sockets: FakeSocket[];
let events: string[];
let client: Client;

const listener: Listener = {
  connection: (connection: Connection) => events.push(connection.state),
  introduced: (_, fresh) => events.push(fresh ? "introduced fresh" : "introduced again"),
  advertised: (channels) => events.push(`advertised ${channels.map(({ topic }) => topic)}`),
  unadvertised: (channels) => events.push(`unadvertised ${channels.map(({ topic }) => topic)}`),
  subscribed: (topic, is) => events.push(`${is ? "subscribed" : "unsubscribed"} ${topic}`),
  message: (topic, log_ns, data) => events.push(`message ${topic} ${log_ns} [${data}]`),
  time: (now_ns) => events.push(`time ${now_ns}`),
  playhead: (own) => events.push(own ? "own playhead" : "shared playhead"),
  playback: ({ status, time_ns, request }) => events.push(`playback ${status} ${time_ns} ${request}`),
  status: (level, message) => events.push(`${level}: ${message}`),
  removeStatus: (ids) => events.push(`removeStatus ${ids}`),
  parameters: (values) => events.push(`parameters ${values.map(({ name, value }) => `${name}=${value}`)}`),
  services: () => {},
};

const newest = () => sockets.at(-1)!;
const turn = () => vi.advanceTimersByTimeAsync(0);

beforeEach(() => {
  vi.useFakeTimers();
  sockets = [];
  events = [];
  client = new Client(
    () => "ws://robot/live",
    listener,
    () => {
      sockets.push(new FakeSocket());
      return newest();
    },
  );
  client.start();
});
afterEach(() => vi.useRealTimers());

test("a wanted topic is subscribed as soon as it is offered, and only once for two users", async () => {
  client.want("/14/2/ball");
  client.want("/14/2/ball");
  newest().say(kInfo, { op: "advertise", channels: [kChannel, { ...kChannel, id: 4, topic: "/14/2/pose" }] });
  await turn();
  expect(newest().take("subscribe")).toEqual([{ op: "subscribe", subscriptions: [{ id: 0, channelId: 3 }] }]);
});

test("a subscription ends with its last user", async () => {
  const [first, second] = [client.want("/14/2/ball"), client.want("/14/2/ball")];
  newest().say(kInfo, { op: "advertise", channels: [kChannel] });
  await turn();
  first();
  first(); // a second release has no effect
  await turn();
  expect(newest().take("unsubscribe")).toEqual([]);
  second();
  await turn();
  expect(newest().take("unsubscribe")).toEqual([{ op: "unsubscribe", subscriptionIds: [0] }]);
});

test("a topic that is released and wanted again in one turn sends nothing", async () => {
  const release = client.want("/14/2/ball");
  newest().say(kInfo, { op: "advertise", channels: [kChannel] });
  await turn();
  newest().sent = [];
  release();
  client.want("/14/2/ball");
  await turn();
  expect(newest().sent).toEqual([]);
});

test("messages arrive with topic and capture time, and messages of an ended subscription are ignored", async () => {
  const release = client.want("/14/2/ball");
  newest().say(kInfo, { op: "advertise", channels: [kChannel] });
  await turn();
  const message = [1, 0, 0, 0, 0, 5, 0, 0, 0, 0, 0, 0, 0, 8, 1];
  newest().frame(...message);
  expect(events).toContain("message /14/2/ball 5 [8,1]");
  release();
  await turn();
  events = [];
  newest().frame(...message);
  expect(events).toEqual([]);
});

test("after a lost connection the client retries every second and subscribes again with the new ids", async () => {
  client.want("/14/2/ball");
  newest().say(kInfo, { op: "advertise", channels: [kChannel] });
  await turn();
  newest().onclose?.({ code: 1006, reason: "" });
  expect(events).toContain("unsubscribed /14/2/ball");
  await vi.advanceTimersByTimeAsync(1000);
  newest().onclose?.({ code: 1006, reason: "" });
  await vi.advanceTimersByTimeAsync(1000);
  expect(sockets).toHaveLength(3);

  newest().say(kInfo, { op: "advertise", channels: [{ ...kChannel, id: 9 }] });
  await turn();
  expect(newest().take("subscribe")).toMatchObject([{ subscriptions: [{ channelId: 9 }] }]);
  expect(events).toContain("introduced again");
});

test("another session id is another run, also in the middle of a connection", async () => {
  client.want("/14/2/ball");
  newest().say(kInfo, { op: "advertise", channels: [kChannel] });
  await turn();
  newest().sent = events = [];
  newest().say({ ...kInfo, sessionId: "two" }, { op: "advertise", channels: [kChannel] });
  await turn();
  expect(events).toContain("introduced fresh");
  expect(newest().take("subscribe")).toMatchObject([{ subscriptions: [{ channelId: 3 }] }]);
});

test("a server whose time went back does not have to offer its channels again", async () => {
  client.want("/14/2/ball");
  newest().say(kInfo, { op: "advertise", channels: [kChannel] });
  await turn();
  newest().sent = events = [];
  newest().say({ ...kInfo, sessionId: "two" });
  await turn();
  expect(events).not.toContain("unadvertised /14/2/ball");
  expect(newest().take("unsubscribe")).toHaveLength(1);
  expect(newest().take("subscribe")).toMatchObject([{ subscriptions: [{ channelId: 3 }] }]);
});

test("a server whose metadata changed keeps its channels and subscriptions", async () => {
  client.want("/14/2/ball");
  newest().say(kInfo, { op: "advertise", channels: [kChannel] });
  await turn();
  newest().sent = events = [];
  newest().say({ ...kInfo, metadata: { rules: "spl2012" } });
  await turn();
  expect(events).toContain("introduced again");
  expect(events).not.toContain("unadvertised /14/2/ball");
  expect(newest().take("unsubscribe")).toHaveLength(0);
  expect(newest().take("subscribe")).toHaveLength(0);
});

test("a channel that returns with another schema is withdrawn first", async () => {
  client.want("/14/2/ball");
  newest().say(kInfo, { op: "advertise", channels: [kChannel] });
  await turn();
  newest().sent = events = [];
  newest().say({ op: "advertise", channels: [{ ...kChannel, schema: "BB==" }] });
  await turn();
  expect(events.slice(0, 2)).toEqual(["unadvertised /14/2/ball", "advertised /14/2/ball"]);
  expect(newest().take("unsubscribe")).toHaveLength(1);
  expect(newest().take("subscribe")).toHaveLength(1);
});

test("an unreadable frame is reported with a sentence, and the connection stays", () => {
  newest().say(kInfo);
  newest().onmessage?.({ data: "{" });
  newest().onmessage?.({ data: "[]" });
  newest().frame(2, 1, 2);
  newest().frame();
  newest().frame(99);
  newest().say({ op: "not yet invented" });
  newest().say({ op: "advertise", channels: [{ id: -1, topic: "/a" }, { id: 1 }, null, kChannel] });
  expect(events.filter((event) => event.startsWith("error"))).toHaveLength(5);
  expect(events).toContain("advertised /14/2/ball");
  expect(newest().closed).toBe(false);
});

test("a server that sent Time frames and is then silent is given up", async () => {
  newest().say(kInfo);
  newest().frame(2, 1, 0, 0, 0, 0, 0, 0, 0);
  await vi.advanceTimersByTimeAsync(4900);
  expect(newest().closed).toBe(false);
  await vi.advanceTimersByTimeAsync(200);
  expect(newest().closed).toBe(true);
  expect(events.at(-1)).toBe("waiting");
});

test("a server without Time frames may be silent", async () => {
  newest().say(kInfo);
  await vi.advanceTimersByTimeAsync(60000);
  expect(sockets).toHaveLength(1);
});

test("a connection that never opens is given up and retried", async () => {
  await vi.advanceTimersByTimeAsync(6100);
  expect(sockets).toHaveLength(2);
  expect(sockets[0]!.closed).toBe(true);
});

test("parameters are requested and followed if the server supports them", () => {
  newest().say({ ...kInfo, capabilities: ["parameters", "parametersSubscribe"] });
  expect(newest().take("getParameters")).toHaveLength(1);
  expect(newest().take("subscribeParameterUpdates")).toHaveLength(1);
  newest().say({ op: "parameterValues", parameters: [{ name: "recording", value: true }, 5] });
  expect(events.at(-1)).toBe("parameters recording=true");
});

test("a playhead is chosen by a message, and the server says whose it is", () => {
  expect(client.choosePlayhead(true)).toBe(false); // nobody is connected
  newest().say(kInfo);
  expect(client.choosePlayhead(true)).toBe(true);
  expect(newest().take("playhead")).toEqual([{ op: "playhead", own: true }]);
  newest().say({ op: "playhead", own: true }, { op: "playhead", own: "yes" });
  expect(events.slice(-2)).toEqual(["own playhead", "shared playhead"]);
});

test("each try to connect has an address of its own", async () => {
  let tries = 0;
  const addresses: string[] = [];
  client.stop();
  client = new Client(
    () => `ws://robot/${++tries}`,
    listener,
    (url) => {
      addresses.push(url);
      sockets.push(new FakeSocket());
      return newest();
    },
  );
  client.start();
  newest().onclose?.({ code: 1006, reason: "" });
  await vi.advanceTimersByTimeAsync(1000);
  expect(addresses).toEqual(["ws://robot/1", "ws://robot/2"]);
});

test("a server that plays a recording reports its span and answers playback requests", () => {
  expect(client.ask({ play: true, speed: 1 }, "early")).toBe(false);
  newest().say({
    ...kInfo,
    capabilities: ["playbackControl"],
    dataStartTime: { sec: 2, nsec: 5 },
    dataEndTime: { sec: 9, nsec: 0 },
  });
  expect(client.ask({ play: false, speed: 2, seek_ns: 7n }, "a")).toBe(true);
  expect(newest().sent.at(-1)).toBeInstanceOf(Uint8Array);
  newest().frame(5, 1, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 128, 63, 1, 1, 0, 0, 0, 97);
  expect(events.at(-1)).toBe("playback paused 7 a");
});

const response = (call: number, text: string) => [
  ...[3, 8, 0, 0, 0, call, 0, 0, 0, 4, 0, 0, 0],
  ...new TextEncoder().encode(`json${text}`),
];
const kServices = { op: "advertiseServices", services: [{ id: 8, name: "start_recording" }] };

test("a service call is answered, or rejected with the server's sentence", async () => {
  newest().say(kInfo, kServices);
  const [first, second] = [client.call("start_recording", { name: "a" }), client.call("start_recording", {})];
  newest().frame(...response(1, '{"ok": false, "error": "The disk is full."}'));
  newest().frame(...response(0, '{"ok": true, "session": "s"}'));
  await expect(first).resolves.toEqual({ ok: true, session: "s" });
  await expect(second).rejects.toThrow("The disk is full.");
});

test("a service call that cannot be answered rejects with the reason", async () => {
  await expect(client.call("start_recording", {})).rejects.toThrow("Not connected");
  newest().say(kInfo, kServices);
  await expect(client.call("fly", {})).rejects.toThrow("does not offer 'fly'");
  const [unreadable, refused, lost] = [0, 1, 2].map(() => client.call("start_recording", {}));
  newest().frame(...response(0, "{"));
  await expect(unreadable).rejects.toThrow("not JSON");
  newest().say({ op: "serviceCallFailure", serviceId: 8, callId: 1, message: "Not allowed." });
  await expect(refused).rejects.toThrow("Not allowed.");
  newest().onclose?.({ code: 1006, reason: "" });
  await expect(lost).rejects.toThrow("lost");
});

test("parameters are set in one message, while the connection stands", async () => {
  client.start();
  const values = new Map<string, number | boolean | string>([
    ["walk.height", 0.03],
    ["walk.name", "a"],
  ]);
  expect(client.setParameters(values)).toBe(false);
  newest().say(kInfo);
  expect(client.setParameters(values)).toBe(true);
  expect(newest().take("setParameters")).toEqual([
    {
      op: "setParameters",
      id: "set",
      parameters: [
        { name: "walk.height", value: 0.03 },
        { name: "walk.name", value: "a" },
      ],
    },
  ]);
});

test("a refusal's cause is a field of the answer and of the status", async () => {
  const causes: string[] = [];
  const hears: Listener = { ...listener, status: (_, __, ___, cause) => causes.push(cause ?? "") };
  client = new Client(
    () => "ws://robot/",
    hears,
    () => {
      sockets.push(new FakeSocket());
      return newest();
    },
  );
  client.start();
  newest().say(kInfo, kServices);
  const refused = client.call("start_recording", {}).catch((error: unknown) => error);
  newest().frame(...response(0, '{"ok": false, "error": "start: no", "cause": "token"}'));
  expect(causeOf(await refused)).toBe("token");
  const failed = client.call("start_recording", {}).catch((error: unknown) => error);
  newest().frame(...response(1, '{"ok": false, "error": "start: needs the control token"}'));
  expect(causeOf(await failed)).toBe(""); // words decide nothing
  newest().say(
    { op: "status", level: 2, message: "no", cause: "token" },
    { op: "status", level: 2, message: "no", cause: 3 },
  );
  expect(causes).toEqual(["token", ""]);
});
