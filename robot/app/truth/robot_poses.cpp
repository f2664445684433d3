#include "robot/app/truth/robot_poses.h"

#include <algorithm>
#include <cmath>

namespace robot::app {
namespace {

/// Returns the message of a version, or nothing without one.
template <class Message>
std::optional<Message> message_of(const memory::VersionPtr& version) {
  Message message;
  if (!version || !message.ParseFromArray(version->bytes().data(), static_cast<int>(version->bytes().size())))
    return {};
  return message;
}

}  // namespace

std::optional<truth::OwnPose> own_pose_of(RobotName robot, const foresight::Pose& pose,
                                          const foresight::GameState& game, std::uint64_t capture_ns) {
  if (!game.has_attacks_positive_x()) return {};
  const double turn = game.attacks_positive_x() ? 1 : -1;
  const double deviation = std::hypot(pose.deviation_x(), pose.deviation_y()) / std::sqrt(2.);
  truth::OwnPose own{.capture_ns = capture_ns,
                     .team = static_cast<std::uint32_t>(robot.team),
                     .player = static_cast<std::uint32_t>(robot.player),
                     .position = {turn * pose.x(), turn * pose.y()},
                     .deviation = std::max(kLeastPoseDeviation, deviation)};
  if (!std::isfinite(deviation) || !own.position.allFinite()) return {};
  return own;
}

void RobotPoses::pass_on() {
  for (const auto& channel : robots_.all()) {
    const std::string& topic = channel->info().topic;
    const memory::ObjectName name = memory::object_name(topic);
    const memory::VersionPtr version = name.object == kPoseObject ? channel->newest() : nullptr;
    if (!version || passed_[topic] == version->capture_ns()) continue;
    passed_[topic] = version->capture_ns();
    const Result<RobotName> robot = parse_robot_name(name.robot);
    const auto game_channel = robots_.find("/" + std::string(name.robot) + "/" + kGameObject);
    const auto game = message_of<foresight::GameState>(game_channel ? game_channel->newest() : nullptr);
    const auto pose = message_of<foresight::Pose>(version);
    if (!robot || !pose || !game) continue;
    if (const auto own = own_pose_of(*robot, *pose, *game, version->capture_ns())) writer_.identify(*own);
  }
}

}  // namespace robot::app
