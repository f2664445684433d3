// Our ssh key among those that a robot lets in.
import { existsSync, readFileSync } from "node:fs";
import { homedir } from "node:os";
import { join } from "node:path";
import { BadInput } from "./failure.mjs";

// the servers of the old systems know no ed25519
const kKinds = { "nao-v6": ["ed25519", "ecdsa", "rsa"], "nao-v5": ["rsa", "ecdsa"], "nao-v4": ["rsa", "ecdsa"] };

/** The line of the public key that shall open `robot`: the one the robots file names, or this person's own. */
export function publicKey(robot, home = homedir()) {
  const files = robot.key ? [`${robot.key}.pub`] : kKinds[robot.model].map((kind) => join(home, ".ssh", `id_${kind}.pub`));
  const file = files.find((one) => existsSync(one));
  if (!file) throw new BadInput(`${robot.name}: expected a public ssh key in ${files.join(" or ")}, got none: ssh-keygen makes one`);
  const line = readFileSync(file, "utf8").trim();
  if (!/^(ssh|ecdsa|sk)-[\w@.-]+ [A-Za-z0-9+/=]+( [^\n]*)?$/.test(line)) throw new BadInput(`${file}: expected one public ssh key, got '${line.slice(0, 40)}'`);
  return line;
}

const bodyOf = (line) => line.split(" ").slice(0, 2).join(" ");

/** True if `text`, an authorized_keys, lets `line` in already. */
export const hasKey = (text, line) => text.split("\n").some((one) => !one.startsWith("#") && one.includes(bodyOf(line)));

/** `text` with `line` first: so that withoutKey() gives back every byte, also where the last line has no end. */
export const withKey = (text, line) => `${line}\n${text}`;

/** `text` without the first `line`, as withKey() put it there. */
export function withoutKey(text, line) {
  const at = `\n${text}`.indexOf(`\n${line}\n`);
  return at < 0 ? text : text.slice(0, at) + text.slice(at + line.length + 1);
}

/** Replaces the file, keeping its mode; whoever is cut off in the middle leaves the old one. */
export const kReplaceKeys = `
set -e
keys=.ssh/authorized_keys
if [ -e $keys ]; then cp -p $keys $keys.new; fi
(umask 077 && cat >$keys.new)
mv -f $keys.new $keys`;

/** Makes what is missing for the file, and notes it. */
export const kMakeKeysFile = `
set -e
if [ ! -d .ssh ]; then echo "folder .ssh" >>foresight/made; mkdir -m 700 .ssh; fi
if [ ! -e .ssh/authorized_keys ]; then echo "file .ssh/authorized_keys" >>foresight/made; (umask 077 && : >.ssh/authorized_keys); fi`;
