// Channels of scenes, frames and camera projections that other viewers draw. They are made only while somebody watches.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proto/foresight/sim.pb.h"
#include "robot/memory/channels.h"
#include "robot/net/foxglove/web_socket_out_provider.h"
#include "robot/net/scene/scene.h"

namespace robot::net {

/// The knowledge beyond the message itself that a scene needs.
struct SceneSources {
  const memory::Channels& channels;  // the newest values of all objects
  std::string each_second;           // the topic of a foresight.RuntimeStatistics with which the field is sent
  // returns the field of the rules, which may become known later; a simulation in `channels` knows better; any thread
  std::function<foresight::Field()> field;
};

/// Returns the channels that are derived from `source`, by its schema. Most have none.
/// - foresight.GroundTruth: `<topic>/scene` (foxglove.SceneUpdate).
/// - foresight.Pose: `<topic>/scene` with all beliefs of that robot, `<topic>/transforms` (foxglove.FrameTransforms).
/// - foresight.CameraMatrix: `<topic>/transforms`, `<topic>/calibration` (foxglove.CameraCalibration).
/// - foxglove.RawImage of a ground-truth sensor, `/truth/1/depth`: `/truth/1/points` (foxglove.PointCloud).
/// - The topic `each_second`: `/field/scene` with the field.
///
/// `sources` is read at each conversion, and outlives the streams.
std::vector<Derived> scene_channels(const memory::ChannelInfo& source, const SceneSources& sources);

/// Makes the scene of a version of a channel.
using MakeScene = std::function<Result<Scene>(const memory::Version& version)>;

/// Returns the maker of the scene of `source`, or an empty function if it has none.
MakeScene scene_of(const memory::ChannelInfo& source, const SceneSources& sources);

/// Returns the field of the simulation in `sources`, or else that of the rules.
foresight::Field known_field(const SceneSources& sources);

/// Returns the description of the channel with the field.
memory::ChannelInfo field_channel();

}  // namespace robot::net
