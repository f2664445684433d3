// The schemas of the foxglove.* messages that are written by hand, as protoc made them from proto/foxglove.
#pragma once

#include <string_view>

#include "robot/memory/channel.h"

namespace robot::net {

/// A schema that a program holds if it uses it.
struct EmbeddedSchema {
  std::string_view name;   // "foxglove.SceneUpdate"
  std::string_view bytes;  // a FileDescriptorSet with all imports

  memory::Schema schema() const;
};

extern const EmbeddedSchema kSceneUpdate, kFrameTransforms, kCameraCalibration, kPointCloud;

}  // namespace robot::net
