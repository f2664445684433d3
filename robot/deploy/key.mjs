// Our ssh key in a robot's authorized_keys.
import { existsSync, readFileSync } from "node:fs";
import { homedir } from "node:os";
import { join } from "node:path";
import { BadInput } from "./failure.mjs";

// the servers of the old systems know no ed25519
const kKinds = { "nao-v6": ["ed25519", "ecdsa", "rsa"], "nao-v5": ["rsa", "ecdsa"], "nao-v4": ["rsa", "ecdsa"] };

/** Returns the line of the public key for `robot`: that of the robots file, or the user's own. */
export function publicKey(robot, home = homedir()) {
  const files = robot.key ? [`${robot.key}.pub`] : kKinds[robot.model].map((kind) => join(home, ".ssh", `id_${kind}.pub`));
  const file = files.find((one) => existsSync(one));
  if (!file) throw new BadInput(`${robot.name}: expected a public ssh key in ${files.join(" or ")}, got none: ssh-keygen makes one`);
  const line = readFileSync(file, "utf8").trim();
  if (!/^(ssh|ecdsa|sk)-[\w@.-]+ [A-Za-z0-9+/=]+( [^\n]*)?$/.test(line)) throw new BadInput(`${file}: expected one public ssh key, got '${line.slice(0, 40)}'`);
  return line;
}

const bodyOf = (line) => line.split(" ").slice(0, 2).join(" ");

/** Returns true if `text`, an authorized_keys, contains the key `line`. */
export const hasKey = (text, line) => text.split("\n").some((one) => !one.startsWith("#") && one.includes(bodyOf(line)));

/** Returns `text` with `line` first, so that withoutKey() restores every byte even if the last line has no newline. */
export const withKey = (text, line) => `${line}\n${text}`;

/** Returns `text` without the first `line`, which withKey() added. */
export function withoutKey(text, line) {
  const at = `\n${text}`.indexOf(`\n${line}\n`);
  return at < 0 ? text : text.slice(0, at) + text.slice(at + line.length + 1);
}

/** Replaces the file and keeps its mode; an interruption leaves the old file. */
export const kReplaceKeys = `
set -e
keys=.ssh/authorized_keys
if [ -e $keys ]; then cp -p $keys $keys.new; fi
(umask 077 && cat >$keys.new)
mv -f $keys.new $keys`;

/** Makes the missing folder and file, and notes them. */
export const kMakeKeysFile = `
set -e
if [ ! -d .ssh ]; then echo "folder .ssh" >>foresight/made; mkdir -m 700 .ssh; fi
if [ ! -e .ssh/authorized_keys ]; then echo "file .ssh/authorized_keys" >>foresight/made; (umask 077 && : >.ssh/authorized_keys); fi`;
