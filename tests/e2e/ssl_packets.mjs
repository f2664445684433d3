// Packets of SSL-Vision: the cheapest images of a field that the ground-truth server takes.
import { createSocket } from "node:dgram";
import { once } from "node:events";

const kMostAtOnce = 100; // packets that a receiver's buffer holds in any case
const kFrameBytes = 4;

const float = (field, value) =>
  Buffer.concat([Buffer.from([(field << 3) | 5]), Buffer.from(Float32Array.of(value).buffer)]);
const message = (field, ...parts) => {
  const bytes = Buffer.concat(parts);
  return Buffer.concat([Buffer.from([(field << 3) | 2, bytes.length]), bytes]);
};

/**
 * Returns one packet and the function that gives it a frame number and a time [s]. It shows a ball at (1.25, -0.5) m, and
 * the yellow robot 3 at (-1, 0.25) m with heading 0.5.
 */
export function packet() {
  const ball = message(5, float(1, 0.9), float(3, 1250), float(4, -500), float(6, 1), float(7, 1));
  const number = Buffer.from([2 << 3, 3]);
  const robot = message(
    6,
    float(1, 1),
    number,
    float(3, -1000),
    float(4, 250),
    float(5, 0.5),
    float(6, 1),
    float(7, 1),
  );
  const frame = Buffer.concat([Buffer.from([1 << 3]), Buffer.alloc(kFrameBytes)]);
  const time = (field) => Buffer.concat([Buffer.from([(field << 3) | 1]), Buffer.alloc(8)]);
  const bytes = message(1, frame, time(2), time(3), Buffer.from([4 << 3, 0]), ball, robot);
  const firstFrame = 3;
  const [captured, sent] = [firstFrame + kFrameBytes + 1, firstFrame + kFrameBytes + 10];
  const set = (number, seconds) => {
    for (let i = 0; i < kFrameBytes; ++i)
      bytes[firstFrame + i] = ((number >> (7 * i)) & 0x7f) | (i + 1 < kFrameBytes ? 0x80 : 0);
    bytes.writeDoubleLE(seconds, captured);
    bytes.writeDoubleLE(seconds + 0.001, sent);
  };
  return { bytes, set };
}

/** Sends this number of packets, at most `rate` a second, to a group on this machine. */
export async function sendPackets(count, rate, { group, port }) {
  const socket = createSocket("udp4");
  const { bytes, set } = packet();
  const began = performance.now();
  for (let sent = 0; sent < count;) {
    const due = Math.min(count, Math.floor(((performance.now() - began) / 1000) * rate));
    const now = Math.min(due, sent + kMostAtOnce);
    while (sent < now) {
      set(++sent, performance.now() / 1000);
      socket.send(Buffer.from(bytes), port, group);
    }
    await new Promise((done) => setTimeout(done, 1));
  }
  socket.close();
  await once(socket, "close");
}
