// The one place that decides which field is drawn.

import { valueOf } from "../memory/memory_object";
import type { Field as FieldMessage } from "../memory/schema";
import { kSimulation } from "../memory/simulation";
import { fieldsOf, numberOf, textOf, type Fields, type NumberIn } from "../memory/value";
import { kFields, type Field } from "./field";
import type { Told } from "./scene";

/** Robots whose rules nobody reports play by the newest of the SPL, as robots foresee by default. */
export const kAssumed = "spl2025";

export interface KnownField {
  field: Field;
  /** "reported": by the simulation, a forecast or the server; "chosen": by the person; "assumed": nobody knows. */
  from: "reported" | "chosen" | "assumed";
}

/** `chosen`: the name of rules that a person has chosen, or "". */
export function knownField(told: Told[], chosen: string): KnownField {
  for (const { memory } of told) {
    const field = fieldOf(fieldsOf(valueOf(memory.world(kSimulation)), "field"));
    if (field) return { field, from: "reported" };
  }
  for (const { memory, robots } of told)
    for (const robot of robots) {
      const field = kFields[rulesNameOf(textOf(valueOf(memory.of(robot, "forecast")), "rules"))];
      if (field) return { field, from: "reported" };
    }
  for (const { rules } of told) {
    const field = kFields[rulesNameOf(rules ?? "")];
    if (field) return { field, from: "reported" };
  }
  return kFields[chosen] ? { field: kFields[chosen], from: "chosen" } : { field: kFields[kAssumed]!, from: "assumed" };
}

/** "spl2025" of "spl2025:5,half_duration=60". */
const rulesNameOf = (rules: string): string => /^[a-z0-9]*/.exec(rules)![0];

/** Reads the field of /sim/state, or returns undefined. */
export function fieldOf(fields: Fields<FieldMessage>): Field | undefined {
  if (!(numberOf(fields, "length") > 0 && numberOf(fields, "width") > 0)) return undefined;
  const size = (name: NumberIn<FieldMessage>) => numberOf(fields, name) || 0;
  return {
    length: size("length"),
    width: size("width"),
    border: size("border"),
    lineWidth: size("line_width"),
    centreCircleRadius: size("centre_circle_radius"),
    goalAreaLength: size("goal_area_length"),
    goalAreaWidth: size("goal_area_width"),
    penaltyAreaLength: size("penalty_area_length"),
    penaltyAreaWidth: size("penalty_area_width"),
    penaltyMark: size("penalty_mark"),
    goalWidth: size("goal_width"),
    goalDepth: size("goal_depth"),
  };
}
