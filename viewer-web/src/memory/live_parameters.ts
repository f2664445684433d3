// The live parameters of a team's processes, from the object live_parameters of a robot.

import type { LiveParameter as Parameter, LiveParameters as Announced, RobotObject } from "./schema";
import { listOf, numberOf, textOf, wordOf, type Fields } from "./value";

export const kLiveParameters = "live_parameters" satisfies RobotObject;

export type ParameterValue = number | boolean | string;
export type ParameterType = "number" | "whole" | "yes_no" | "text" | "choice" | "button";
const kTypes: readonly string[] = ["number", "whole", "yes_no", "text", "choice", "button"] satisfies ParameterType[];

export interface LiveParameter {
  /** "walk.step_height" */
  name: string;
  /** "walk" */
  process: string;
  type: ParameterType;
  value: ParameterValue;
  /** From the process's own file. */
  initial: ParameterValue;
  /** Both included; infinite without a limit. */
  min: number;
  max: number;
  unit: string;
  description: string;
  choices: string[];
  /** The process has disconnected. */
  gone: boolean;
}

export interface LiveParameters {
  parameters: LiveParameter[];
  /** Sentences about announcements that the runtime refused. */
  problems: string[];
}

/** Parses the decoded message. Entries of an unknown type are left out. */
export function liveParametersOf(message: Fields<Announced>): LiveParameters {
  const problems = message.get("problem");
  return {
    parameters: listOf(message, "parameter").flatMap((fields) => parameterOf(fields) ?? []),
    problems: Array.isArray(problems) ? problems.filter((problem) => typeof problem === "string") : [],
  };
}

function parameterOf(fields: Fields<Parameter>): LiveParameter | undefined {
  const type = wordOf(fields, "type");
  if (!kTypes.includes(type)) return undefined;
  const value = (number: "number" | "initial_number", text: "text" | "initial_text"): ParameterValue =>
    type === "text" || type === "choice"
      ? textOf(fields, text)
      : type === "yes_no"
        ? numberOf(fields, number) === 1
        : numberOf(fields, number);
  const [min, max] = [numberOf(fields, "min"), numberOf(fields, "max")];
  const limited = min !== 0 || max !== 0;
  const name = textOf(fields, "name");
  const choices = fields.get("choice");
  return {
    name,
    process: name.split(".", 1)[0]!,
    type: type as ParameterType,
    value: value("number", "text"),
    initial: value("initial_number", "initial_text"),
    min: limited ? min : -Infinity,
    max: limited ? max : Infinity,
    unit: textOf(fields, "unit"),
    description: textOf(fields, "description"),
    choices: Array.isArray(choices) ? choices.filter((choice) => typeof choice === "string") : [],
    gone: fields.get("gone") === true,
  };
}
