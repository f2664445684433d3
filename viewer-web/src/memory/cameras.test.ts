import { expect, test } from "vitest";
import { camerasOf } from "./cameras";
import { Memory } from "./memory";
import { kPerceptChannel } from "./test_schema";

test("the streams of one camera are grouped, top before bottom, with the compressed stream if there is one", () => {
  const memory = new Memory();
  const offer = (topic: string, schemaName: string, derived: string) =>
    memory.offer({ ...kPerceptChannel, topic, schemaName, metadata: { derived } });
  offer("/14/2/camera_bottom", "foresight.Image", "");
  offer("/14/2/camera_top/raw", "foxglove.RawImage", "true");
  offer("/14/2/camera_top/jpeg", "foxglove.CompressedImage", "true");
  offer("/14/2/camera_top", "foresight.Image", "");
  offer("/14/2/camera_top_matrix", "foresight.CameraMatrix", "");
  const cameras = camerasOf(memory.objectsOf("14/2"));
  expect(cameras.map(({ label, full, light }) => [label, full.name, light?.name])).toEqual([
    ["top", "camera_top", "camera_top/jpeg"],
    ["bottom", "camera_bottom", undefined],
  ]);
});

test("sensors of ground truth and point clouds are no cameras of a robot", () => {
  const memory = new Memory();
  for (const [topic, schemaName] of [
    ["/truth/1/depth", "foxglove.RawImage"],
    ["/truth/1/points", "foxglove.PointCloud"],
  ] as const)
    memory.offer({ ...kPerceptChannel, topic, schemaName });
  expect(camerasOf(memory.objectsOf(""))).toEqual([]);
  expect([...memory.objects()].every(({ isImage }) => isImage)).toBe(true);
});
