// Two network namespaces with a cable of limited rate between them. Needs root.
import { atEnd, command } from "./programs.mjs";

/** Returns the reason why such a network is impossible here, or undefined. */
export function whyNoNetwork() {
  if (process.getuid() !== 0) return "network namespaces need root";
  try {
    command("ip", "netns", "list");
    command("tc", "-V");
    return undefined;
  } catch (error) {
    return `network namespaces do not work here: ${error.message.trim()}`;
  }
}

let links = 0;

/**
 * `rate` in tc's notation, such as "5mbit"; both directions; `latency` [ms] is the longest queue of the router on the way.
 * The robot is at `robot.address`; both ends have the words that run a program there in `before`.
 */
export function link({ rate, burst = "32kbit", latency = 400 }) {
  const id = `fb${process.pid % 100000}${String.fromCharCode(97 + links++)}`;
  const ends = [
    { name: `${id}r`, device: `${id}r`, address: "10.98.14.2" },
    { name: `${id}l`, device: `${id}l`, address: "10.98.14.1" },
  ];
  for (const end of ends) {
    command("ip", "netns", "add", end.name);
    atEnd(() => command("ip", "netns", "delete", end.name));
    end.before = ["ip", "netns", "exec", end.name];
  }
  command(
    "ip",
    "link",
    "add",
    ends[0].device,
    "netns",
    ends[0].name,
    "mtu",
    "1500",
    "type",
    "veth",
    "peer",
    "name",
    ends[1].device,
    "netns",
    ends[1].name,
    "mtu",
    "1500",
  );
  for (const { name, device, address } of ends) {
    command("ip", "-n", name, "address", "add", `${address}/24`, "dev", device);
    command("ip", "-n", name, "link", "set", "lo", "up");
    command("ip", "-n", name, "link", "set", device, "up");
    command(
      "tc",
      "-n",
      name,
      "qdisc",
      "add",
      "dev",
      device,
      "root",
      "tbf",
      "rate",
      rate,
      "burst",
      burst,
      "latency",
      `${latency}ms`,
    );
  }
  return { robot: ends[0], lab: ends[1], words: `${rate} (tbf, MTU 1500)` };
}
