// The cameras of a robot and the streams of each one's images.

import type { MemoryObject } from "./memory_object";

export interface Camera {
  /** Such as "top" for camera_top. */
  label: string;
  /** Every image as it is in memory. */
  full: MemoryObject;
  /** The same images, compressed by the robot: smaller and at a lower rate. Undefined if not offered. */
  light: MemoryObject | undefined;
}

/**
 * Groups the image objects by camera: camera_top with camera_top/jpeg. Top comes before bottom. The sensors of ground truth
 * are no cameras of a robot.
 */
export function camerasOf(objects: MemoryObject[]): Camera[] {
  const images = objects.filter(({ isImage, name }) => isImage && !name.startsWith("truth/"));
  const names = [...new Set(images.map(({ name }) => name.split("/")[0]!))].sort((a, b) => order(a) - order(b));
  return names.map((name) => {
    const ways = images.filter((image) => image.name.split("/")[0] === name);
    const full = ways.find(({ derived }) => !derived) ?? ways[0]!;
    const light = ways.find((way) => way !== full && way.channel.schemaName.endsWith("CompressedImage"));
    return { label: name.replace(/^camera_/, "").replaceAll("_", " "), full, light };
  });
}

const order = (name: string): number => (name.includes("top") ? 0 : name.includes("bottom") ? 1 : 2);
