// The command line: names of robots, with options before, between and after them.
import { BadInput } from "./failure.mjs";

/**
 * Parses `words`. `known` has one entry per option: true for a switch, else a function that converts the option's word to its
 * value, or throws a BadInput. Returns {names, options}; options that were not given are absent.
 */
export function readCommandLine(command, words, known) {
  const names = [];
  const options = {};
  for (let i = 0; i < words.length; ++i) {
    if (!words[i].startsWith("-")) {
      names.push(words[i]);
      continue;
    }
    const [option, ...rest] = words[i].split("=");
    const name = option.slice(2);
    if (!option.startsWith("--") || !Object.hasOwn(known, name)) throw new BadInput(`unknown option '${option}'; see scripts/${command} --help`);
    if (known[name] === true) {
      if (rest.length > 0) throw new BadInput(`${option} takes no value, got '${rest.join("=")}'`);
      options[name] = true;
      continue;
    }
    const value = rest.length > 0 ? rest.join("=") : words[++i];
    if (value === undefined) throw new BadInput(`${option} needs a value; see scripts/${command} --help`);
    options[name] = known[name](value, option);
  }
  return { names, options };
}

/** Returns the word unchanged; it must not be empty. */
export function anyText(value, option) {
  if (value === "") throw new BadInput(`${option}: expected a word, got nothing`);
  return value;
}

export const wholeNumber = (from, to) => (value, option) => {
  if (!/^\d+$/.test(value) || Number(value) < from || Number(value) > to)
    throw new BadInput(`${option}: expected a whole number ${from} .. ${to}, got '${value}'`);
  return Number(value);
};

export const oneOf = (words) => (value, option) => {
  if (!words.includes(value)) throw new BadInput(`${option}: expected ${words.join(", ")}, got '${value}'`);
  return value;
};
