// A scene as coloured points, for viewers that draw no scenes.
#pragma once

#include <cstdint>
#include <string>

#include "robot/net/scene/scene.h"

namespace robot::net {

/// Returns a serialised foxglove.PointCloud with points along the edges of all shapes. It leaves out words, and what
/// SceneStream leaves out.
std::string point_cloud(const Scene& scene, std::uint64_t capture_ns);

}  // namespace robot::net
