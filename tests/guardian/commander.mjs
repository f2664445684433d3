// A team's process that writes commands to the body, and some commands.
import { spawn } from "node:child_process";
import { atEnd, root } from "../e2e/support.mjs";

/** A team's process that writes the object motion_command, from hexadecimal lines: Python, by the door. */
export function commander(t, door) {
  const program = `
import sys, threading, time, foresight
writer = foresight.Writer("motion_command", "foresight.MotionCommand")
newest = b""
def go():
    while True:
        writer.write(foresight.now_ns(), newest)
        time.sleep(0.03)
threading.Thread(target=go, daemon=True).start()
for line in sys.stdin: newest = bytes.fromhex(line.strip())
`;
  const child = spawn("python3", ["-c", program], {
    stdio: ["pipe", "inherit", "inherit"],
    env: { ...process.env, FORESIGHT_DOOR: door, PYTHONPATH: `${root}/robot/client` },
  });
  atEnd(t, () => child.kill("SIGKILL"));
  return (hex) => child.stdin.write(`${hex}\n`);
}
const float = (value) => {
  const bytes = Buffer.alloc(4);
  bytes.writeFloatLE(value);
  return bytes.toString("hex");
};
export const kKick = "1a00"; // kick
export const kSit = "2002"; // posture: SIT
export const kStand = "2001";
export const kHead = (yaw, pitch) => `320a0d${float(yaw)}15${float(pitch)}`; // head_angles
/** walk_speed [m/s], [rad/s] */
export const walkSpeed = (x, turnRate = 0) => `0a0a0d${float(x)}1d${float(turnRate)}`;
