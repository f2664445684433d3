// Binary frames of the Foxglove WebSocket protocol v1: one opcode byte, then little-endian fields.

/** A binary frame from the server. `data` is a view into the frame, not a copy. */
export type ServerFrame =
  | { kind: "message"; subscription: number; log_ns: bigint; data: Uint8Array }
  | { kind: "time"; now_ns: bigint }
  | { kind: "response"; service: number; call: number; encoding: string; data: Uint8Array }
  | { kind: "playback"; state: PlaybackState }
  | { kind: "unknown"; opcode: number }
  | { kind: "malformed"; why: string };

const kPlaybackStatus = ["playing", "paused", "buffering", "ended"] as const;

/** The state of a server's playback. */
export interface PlaybackState {
  status: (typeof kPlaybackStatus)[number];
  /** [ns since the epoch] capture time. */
  time_ns: bigint;
  /** 1 is real time. */
  speed: number;
  /** True if playback jumped: all later messages belong to the new time. */
  didSeek: boolean;
  /** The request that this state answers, or "" if it answers none of ours. */
  request: string;
}

/** The playback that a client asks for. */
export interface PlaybackWish {
  play: boolean;
  /** 0.01 .. 1000; 1 is real time. */
  speed: number;
  /** [ns since the epoch] Where to continue; undefined: where it is. */
  seek_ns?: bigint | undefined;
}

/** Reads one frame. Never throws: an unknown opcode gives `unknown`, a truncated frame gives `malformed`. */
export function readFrame(frame: ArrayBuffer): ServerFrame {
  const view = new DataView(frame);
  if (view.byteLength === 0) return { kind: "malformed", why: "binary frame: empty, expected an opcode byte" };

  const opcode = view.getUint8(0);
  const least = { 1: 13, 2: 9, 3: 13, 5: 19 }[opcode];
  if (least === undefined) return { kind: "unknown", opcode };
  const short = (expected: number): ServerFrame => ({
    kind: "malformed",
    why: `binary frame with opcode ${opcode}: expected at least ${expected} bytes, got ${view.byteLength}`,
  });
  if (view.byteLength < least) return short(least);

  switch (opcode) {
    case 1:
      return {
        kind: "message",
        subscription: view.getUint32(1, true),
        log_ns: view.getBigUint64(5, true),
        data: new Uint8Array(frame, 13),
      };
    case 2:
      return { kind: "time", now_ns: view.getBigUint64(1, true) };
    case 5: {
      const status = kPlaybackStatus[view.getUint8(1)];
      const requestEnd = 19 + view.getUint32(15, true);
      if (view.byteLength < requestEnd) return short(requestEnd);
      if (!status)
        return { kind: "malformed", why: `playback state: expected a status of 0 .. 3, got ${view.getUint8(1)}` };
      const request = new TextDecoder().decode(new Uint8Array(frame, 19, requestEnd - 19));
      const state = {
        status,
        time_ns: view.getBigUint64(2, true),
        speed: view.getFloat32(10, true),
        didSeek: view.getUint8(14) !== 0,
        request,
      };
      return { kind: "playback", state };
    }
    default: {
      const encodingEnd = 13 + view.getUint32(9, true);
      if (view.byteLength < encodingEnd) return short(encodingEnd);
      return {
        kind: "response",
        service: view.getUint32(1, true),
        call: view.getUint32(5, true),
        encoding: new TextDecoder().decode(new Uint8Array(frame, 13, encodingEnd - 13)),
        data: new Uint8Array(frame, encodingEnd),
      };
    }
  }
}

/** Returns the request frame of a service call. The answer carries the same `call`. */
export function writeServiceCall(service: number, call: number, encoding: string, data: Uint8Array): Uint8Array {
  const name = new TextEncoder().encode(encoding);
  const frame = new Uint8Array(13 + name.length + data.length);
  const view = new DataView(frame.buffer);
  view.setUint8(0, 2);
  view.setUint32(1, service, true);
  view.setUint32(5, call, true);
  view.setUint32(9, name.length, true);
  frame.set(name, 13);
  frame.set(data, 13 + name.length);
  return frame;
}

/** Returns the frame that asks for another playback. The answer carries the same `request`, which must not be empty. */
export function writePlaybackWish({ play, speed, seek_ns }: PlaybackWish, request: string): Uint8Array {
  const id = new TextEncoder().encode(request);
  const frame = new Uint8Array(19 + id.length);
  const view = new DataView(frame.buffer);
  view.setUint8(0, 3);
  view.setUint8(1, play ? 0 : 1);
  view.setFloat32(2, speed, true);
  view.setUint8(6, seek_ns === undefined ? 0 : 1);
  view.setBigUint64(7, seek_ns ?? 0n, true);
  view.setUint32(15, id.length, true);
  frame.set(id, 19);
  return frame;
}
