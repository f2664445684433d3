// Conditions on memory objects: expressions that are true or false. "ball.x > 2 && pose.deviation_x < 0.3",
// "distance(ball, truth.ball) > 0.5", "game.state == playing || !game.ball_seen". An absent value is neither true nor
// equal to anything.

import { checkTruth, compile, isTrue } from "./compile";
import { Complaint, orMistake, type Mistake } from "./expression";
import type { Look } from "./places";
import type { Vocabulary } from "./vocabulary";

export interface Condition {
  /** All topics that the condition reads, each once. */
  topics: string[];
  holds(look: Look): boolean;
}

/** Compiles a condition, or returns a sentence about the mistake and its place. */
export const conditionOf = (text: string, vocabulary: Vocabulary): Condition | Mistake =>
  orMistake(() => {
    const { node, topics, kind, path, value } = compile(text, vocabulary);
    checkTruth(node, { kind, constant: topics.length === 0, path });
    if (topics.length === 0) throw new Complaint("The condition never changes: name a path such as ball.x.", node);
    return { topics, holds: (look: Look) => isTrue(value(look)) };
  });
