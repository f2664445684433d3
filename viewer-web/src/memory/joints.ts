// Names of the Nao's joints in LoLA's order, which the lists of the object `joints` have (proto/foresight/sensors.proto).

import { isTopicOf } from "./memory_object";

export const kJoints: readonly string[] = [
  "head_yaw",
  "head_pitch",
  "l_shoulder_pitch",
  "l_shoulder_roll",
  "l_elbow_yaw",
  "l_elbow_roll",
  "l_wrist_yaw",
  "l_hip_yaw_pitch",
  "l_hip_roll",
  "l_hip_pitch",
  "l_knee_pitch",
  "l_ankle_pitch",
  "l_ankle_roll",
  "r_hip_roll",
  "r_hip_pitch",
  "r_knee_pitch",
  "r_ankle_pitch",
  "r_ankle_roll",
  "r_shoulder_pitch",
  "r_shoulder_roll",
  "r_elbow_yaw",
  "r_elbow_roll",
  "r_wrist_yaw",
  "l_hand",
  "r_hand",
];

/** Whether the lists of this topic have one entry for each joint. */
export const isByJoint = (topic: string): boolean => isTopicOf(`/${topic}`, "joints");

/** Returns the joint's index in a list of the topic, or undefined if there is none of this name. */
export function jointIndex(topic: string, name: string): number | undefined {
  const index = isByJoint(topic) ? kJoints.indexOf(name.toLowerCase()) : -1;
  return index < 0 ? undefined : index;
}

/** Returns the name of an entry in a list of `count` entries of the topic, or undefined if the list is not by joint. */
export const jointName = (topic: string, index: number, count = kJoints.length): string | undefined =>
  isByJoint(topic) && count === kJoints.length ? kJoints[index] : undefined;

/** Writes names for indexes: "/14/2/joints.position[0]" becomes "/14/2/joints.position[head_yaw]". */
export const withJointNames = (text: string): string =>
  text.replace(/((?:^|[^\w])joints\.\w+)\[(\d+)\]/g, (all, before: string, index: string) => {
    const name = kJoints[Number(index)];
    return name === undefined ? all : `${before}[${name}]`;
  });
