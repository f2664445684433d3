#include "robot/app/truth/robot_poses.h"

#include <algorithm>
#include <cmath>

namespace robot::app {
namespace {

/// Least deviation [m] of an own pose. A robot that is surer than this is wrong now and then.
constexpr double kLeastDeviation = 0.1;

/// Returns the newest message of a channel, or nothing without one.
template <class Message>
std::optional<Message> newest(const memory::Channels& channels, const std::string& topic) {
  const auto channel = channels.find(topic);
  const memory::VersionPtr version = channel ? channel->newest() : nullptr;
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
                     .deviation = std::max(kLeastDeviation, deviation)};
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
    const auto pose = newest<foresight::Pose>(robots_, topic);
    const auto game = newest<foresight::GameState>(robots_, "/" + std::string(name.robot) + "/" + kGameObject);
    if (!robot || !pose || !game) continue;
    if (const auto own = own_pose_of(*robot, *pose, *game, version->capture_ns())) writer_.identify(*own);
  }
}

}  // namespace robot::app
