#include "robot/net/scene/scene_channels.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "proto/foresight/camera.pb.h"
#include "proto/foresight/runtime.pb.h"
#include "proto/foresight/truth.pb.h"
#include "proto/foxglove/RawImage.pb.h"
#include "robot/net/foxglove/derived_channels.h"
#include "robot/net/foxglove/rate_limit.h"
#include "robot/net/scene/depth_points.h"
#include "robot/net/scene/field_scene.h"
#include "robot/net/scene/frames.h"
#include "robot/net/scene/game_scene.h"
#include "robot/net/scene/schemas.h"

namespace robot::net {
namespace {

namespace pb = foresight;

using Bytes = Result<std::optional<std::string>>;

/// Parses a version, or returns an Error that names the expected message.
Result<void> parse(const memory::Version& version, google::protobuf::Message& message) {
  const std::string_view bytes = version.bytes();
  if (message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return {};
  return Error{"expected a " + message.GetTypeName() + ", got " + std::to_string(bytes.size()) +
               " bytes that cannot be parsed as one"};
}

/// Fills `message` with the newest value of `topic`. Returns false, and clears it, if there is none of that type.
bool read_newest(const memory::Channels& channels, std::string_view topic, google::protobuf::Message& message) {
  message.Clear();
  const std::shared_ptr<memory::Channel> channel = channels.find(topic);
  if (!channel || channel->info().schema.name != message.GetTypeName()) return false;
  const memory::VersionPtr version = channel->newest();
  if (version && parse(*version, message)) return true;
  message.Clear();
  return false;
}

/// The numbers of "14/2".
struct Numbers {
  std::uint32_t team = 0, player = 0;
};

Numbers numbers_of(std::string_view robot) {
  Numbers numbers;
  const std::size_t slash = std::min(robot.find('/'), robot.size());
  std::from_chars(robot.data(), robot.data() + slash, numbers.team);
  if (slash < robot.size()) std::from_chars(robot.data() + slash + 1, robot.data() + robot.size(), numbers.player);
  return numbers;
}

/// Returns the home team of the simulation, else the smallest of the robots that have channels, else that of the truth.
std::uint32_t home_team(const memory::Channels& channels, const pb::GroundTruth& truth) {
  pb::Simulation simulation;
  if (read_newest(channels, memory::kSimulationTopic, simulation) && simulation.home().number() > 0)
    return simulation.home().number();
  std::uint32_t least = 0;
  const auto take = [&](std::uint32_t team) {
    if (team > 0 && (least == 0 || team < least)) least = team;
  };
  for (const auto& channel : channels.all()) take(numbers_of(memory::object_name(channel->info().topic).robot).team);
  if (least == 0)
    for (const pb::GroundTruth::TrueRobot& robot : truth.robots()) take(robot.team());
  return least;
}

Liveries liveries_in(const memory::Channels& channels, const pb::GroundTruth& truth = {}) {
  const std::uint32_t home = home_team(channels, truth);
  pb::GameState game;
  for (const auto& channel : channels.all()) {
    if (memory::object_name(channel->info().topic).object != "game") continue;
    if (read_newest(channels, channel->info().topic, game) && game.own().field_colour() &&
        game.opponent().field_colour())
      return liveries_of(home, game);
  }
  return liveries_of(home, {});
}

Believed beliefs_of(const memory::Channels& channels, std::string_view robot) {
  const auto topic = [&](std::string_view object) { return "/" + std::string(robot) + "/" + std::string(object); };
  const Numbers numbers = numbers_of(robot);
  Believed believed{.team = numbers.team, .player = numbers.player};
  read_newest(channels, topic("ball"), believed.ball);
  read_newest(channels, topic("team"), believed.mates);
  read_newest(channels, topic("opponents"), believed.opponents);
  read_newest(channels, topic("game"), believed.game);
  read_newest(channels, topic("motion_status"), believed.motion);
  return believed;
}

memory::ChannelInfo info_of(std::string topic, const EmbeddedSchema& schema) {
  return {.topic = std::move(topic), .schema = schema.schema()};
}

MakeScene truth_of(const SceneSources& sources) {
  return [&sources](const memory::Version& version) -> Result<Scene> {
    pb::GroundTruth truth;
    if (auto parsed = parse(version, truth); !parsed) return parsed.failure();
    return truth_scene(truth, liveries_in(sources.channels, truth));
  };
}

MakeScene beliefs_of_robot(const memory::ChannelInfo& source, const SceneSources& sources) {
  return [&sources, robot = std::string(memory::object_name(source.topic).robot)](
             const memory::Version& version) -> Result<Scene> {
    Believed believed = beliefs_of(sources.channels, robot);
    if (auto parsed = parse(version, believed.pose); !parsed) return parsed.failure();
    return belief_scene(believed, liveries_in(sources.channels), version.capture_ns());
  };
}

Convert updates_of(const MakeScene& make) {
  return [make, stream = SceneStream()](const memory::Version& version) mutable -> Bytes {
    const Result<Scene> scene = make(version);
    if (!scene) return scene.failure();
    return std::optional(stream.update(*scene, version.capture_ns()));
  };
}

Derived robot_frame_of(const memory::ChannelInfo& source, const SceneSources& sources) {
  const std::string robot(memory::object_name(source.topic).robot);
  return {.info = info_of(source.topic + "/transforms", kFrameTransforms),
          .make_convert = [&sources, robot]() -> Convert {
            return [&sources, robot](const memory::Version& version) -> Bytes {
              pb::Pose pose;
              if (auto parsed = parse(version, pose); !parsed) return parsed.failure();
              pb::GameState game;
              read_newest(sources.channels, "/" + robot + "/game", game);
              return robot_transform(robot_frame(robot), pose_in_field(pose, game), version.capture_ns());
            };
          }};
}

std::vector<Derived> of_camera(const memory::ChannelInfo& source) {
  constexpr std::string_view kEnding = "_matrix";
  if (!source.topic.ends_with(kEnding)) return {};
  const std::string camera = camera_frame(source.topic.substr(0, source.topic.size() - kEnding.size()));
  const std::string robot = robot_frame(memory::object_name(source.topic).robot);
  const auto convert = [](auto make) {
    return [make]() -> Convert {
      return [make](const memory::Version& version) -> Bytes {
        pb::CameraMatrix matrix;
        if (auto parsed = parse(version, matrix); !parsed) return parsed.failure();
        return make(matrix, version.capture_ns());
      };
    };
  };
  std::vector<Derived> derived;
  derived.push_back({.info = info_of(source.topic + "/transforms", kFrameTransforms),
                     .make_convert = convert([robot, camera](const pb::CameraMatrix& matrix, std::uint64_t capture_ns) {
                       return camera_transform(robot, camera, matrix, capture_ns);
                     })});
  derived.push_back({.info = info_of(source.topic + "/calibration", kCameraCalibration),
                     .make_convert = convert([camera](const pb::CameraMatrix& matrix, std::uint64_t capture_ns) {
                       return camera_calibration(camera, matrix, capture_ns);
                     })});
  return derived;
}

/// Returns the channel of points of a ground-truth sensor's depth image, "/truth/1/points" for "/truth/1/depth", at most
/// 10 Hz.
std::vector<Derived> of_depth(const memory::ChannelInfo& source, const SceneSources& sources) {
  constexpr std::string_view kFamily = "/truth/", kEnding = "/depth";
  constexpr double kRateHz = 10;
  if (!source.topic.starts_with(kFamily) || !source.topic.ends_with(kEnding)) return {};
  const std::string sensor = source.topic.substr(0, source.topic.size() - kEnding.size());
  return {{.info = info_of(sensor + "/points", kPointCloud),
           .make_convert = [&sources, sensor]() -> Convert {
             return [&sources, sensor, limit = RateLimit()](const memory::Version& version) mutable -> Bytes {
               if (!limit.passes(version.capture_ns(), kRateHz)) return std::optional<std::string>();
               ::foxglove::RawImage depth;
               if (auto parsed = parse(version, depth); !parsed) return parsed.failure();
               pb::TruthSensor known;
               read_newest(sources.channels, sensor + "/sensor", known);
               Result<std::string> points = depth_points(depth, known, version.capture_ns());
               if (!points) return points.failure();
               return std::optional(std::move(*points));
             };
           },
           .needs_others = true}};
}

}  // namespace

pb::Field known_field(const SceneSources& sources) {
  pb::Simulation simulation;
  const bool known = read_newest(sources.channels, memory::kSimulationTopic, simulation) &&
                     simulation.field().length() > 0 &&
                     can_be_drawn(simulation.field().length(), simulation.field().width());
  return known ? simulation.field() : sources.field();
}

memory::ChannelInfo field_channel() { return info_of("/field/scene", kSceneUpdate); }

MakeScene scene_of(const memory::ChannelInfo& source, const SceneSources& sources) {
  if (source.message_encoding != "protobuf") return {};
  if (source.topic == sources.each_second)
    return [&sources](const memory::Version&) -> Result<Scene> { return field_scene(known_field(sources)); };
  if (source.schema.name == pb::GroundTruth::descriptor()->full_name()) return truth_of(sources);
  if (source.schema.name == pb::Pose::descriptor()->full_name()) return beliefs_of_robot(source, sources);
  return {};
}

std::vector<Derived> scene_channels(const memory::ChannelInfo& source, const SceneSources& sources) {
  if (source.message_encoding == "protobuf" && source.schema.name == pb::CameraMatrix::descriptor()->full_name())
    return of_camera(source);
  if (source.schema.name == ::foxglove::RawImage::descriptor()->full_name()) return of_depth(source, sources);
  const MakeScene make = scene_of(source, sources);
  if (!make) return {};
  std::vector<Derived> derived;
  const bool field = source.topic == sources.each_second;
  derived.push_back({.info = field ? field_channel() : info_of(source.topic + "/scene", kSceneUpdate),
                     .make_convert = [make]() -> Convert { return updates_of(make); }});
  if (!field && source.schema.name == pb::Pose::descriptor()->full_name())
    derived.push_back(robot_frame_of(source, sources));
  for (Derived& one : derived) one.needs_others = true;
  return derived;
}

}  // namespace robot::net
