// A scene as coloured points, for viewers that draw no scenes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/net/scene/scene.h"
#include "robot/net/scene/scene_channels.h"

namespace robot::net {

/// Returns a serialised foxglove.PointCloud with points along the edges of all shapes. It leaves out words, and what
/// SceneStream leaves out.
std::string point_cloud(const Scene& scene, std::uint64_t capture_ns);

/// Returns the scenes of scene_channels() as points, `<topic>/points` and `/field/points` (foxglove.PointCloud), at most
/// 5 Hz. They are for files, whose viewers may know no foxglove.SceneUpdate.
std::vector<Derived> point_channels(const memory::ChannelInfo& source, const SceneSources& sources);

}  // namespace robot::net
