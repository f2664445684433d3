// The names that an expression may use: the objects that a server announces, and their fields.

import type { Memory } from "./memory";
import type { WorldObject } from "./schema";
import { ofFields, shapeOf, type Shape } from "./shape";

export interface Vocabulary {
  /** The chosen robot, "14/2", or "" without one. */
  robot: string;
  topics: ReadonlySet<string>;
  /** "unknown" without a schema and without a message. */
  shapeOf(topic: string): Shape;
}

export const kTruth = "/truth/world" satisfies WorldObject;

/** Returns what the objects of `memory` announce now. */
export function vocabularyOf(memory: Memory, robot: string): Vocabulary {
  return {
    robot,
    topics: new Set([...memory.objects()].map(({ channel }) => channel.topic)),
    shapeOf: (topic) => {
      const object = memory.get(topic);
      if (!object) return { kind: "unknown" };
      const shape = shapeOf(object.channel);
      const fields = shape.kind === "unknown" && !object.isImage ? object.decoded()?.fields : undefined;
      return fields ? ofFields(fields, object.channel.schemaName) : shape;
    },
  };
}

const kOfRobot = /^\/(\d+\/\d+)\/(.+)$/;

/** "14/2" of "/14/2/ball", or "". */
export const robotOfTopic = (topic: string): string => kOfRobot.exec(topic)?.[1] ?? "";

/** All robots that announce an object. */
export const robotsOf = ({ topics }: Vocabulary): string[] => [
  ...new Set([...topics].map(robotOfTopic).filter((robot) => robot !== "")),
];

/** All names of objects: topics, and topics without their robot or their first slash. */
export const objectNames = ({ topics }: Vocabulary): string[] => [
  ...new Set([...topics].flatMap((topic) => [topic, kOfRobot.exec(topic)?.[2] ?? topic.replace(/^\//, "")])),
];

/** Returns the topic of an object as an expression names it, for one robot, or undefined if there is none. */
export function topicOf({ topics }: Vocabulary, robot: string, name: string): string | undefined {
  const names = name.startsWith("/") ? [name] : [`/${robot}/${name}`, `/${name}`];
  if (name === "truth") names.push(kTruth);
  return names.find((topic) => topics.has(topic));
}
