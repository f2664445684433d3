#include "robot/fit/kicks/kick_run.h"

#include <algorithm>
#include <cstdint>

#include "proto/foresight/motion.pb.h"
#include "robot/logging/sessions/read_all.h"

namespace robot::fit {
namespace {

constexpr double kCommanded = 2;  // [s] of a kick whose end was not recorded

std::vector<KickRun> commanded(const WatchedRobot& robot) {
  std::vector<KickRun> runs;
  double before = -kCommanded;  // time of the last command to kick
  const auto add = [&](const foresight::MotionCommand& command, std::uint64_t capture_ns) {
    if (!command.has_kick()) return;
    const double at = robot.true_seconds(capture_ns);
    const foresight::Kick& kick = command.kick();
    const bool left = kick.leg() != foresight::Kick::LEG_RIGHT;
    if (at > before + kCommanded / 2 || runs.back().kind != kick.type() || runs.back().left != left)
      runs.push_back({.kind = kick.type(), .left = left, .begin = at, .end = at});
    runs.back().end = at + kCommanded;
    before = at;
  };
  logging::read_each<foresight::MotionCommand>(robot.session, "/" + robot.session.info.robot + "/motion_command", add);
  return runs;
}

/// Returns the runs in the motion status. The foot is that of the last command at their begin.
std::vector<KickRun> reported(const WatchedRobot& robot, const std::vector<KickRun>& commands) {
  std::vector<KickRun> runs;
  std::string running;
  double before = 0;
  const auto add = [&](const foresight::MotionStatus& status, std::uint64_t capture_ns) {
    const double at = robot.true_seconds(capture_ns);
    if (status.running() != running && !status.running().empty())  // it began between two messages
      runs.push_back(
          {.kind = status.running(), .left = true, .begin = (before + at) / 2, .end = at, .step = at - before});
    if (!status.running().empty()) runs.back().end = at;
    if (status.running().empty() && !running.empty()) runs.back().end = (before + at) / 2;
    running = status.running();
    before = at;
  };
  logging::read_each<foresight::MotionStatus>(robot.session, "/" + robot.session.info.robot + "/motion_status", add);
  std::erase_if(runs, [&](KickRun& run) {
    const auto next = std::ranges::upper_bound(commands, run.end, {}, &KickRun::begin);
    const auto same = std::find_if(std::make_reverse_iterator(next), commands.rend(),
                                   [&](const KickRun& command) { return command.kind == run.kind; });
    if (same == commands.rend()) return true;  // another motion than a kick
    run.left = same->left;
    return false;
  });
  return runs;
}

}  // namespace

std::vector<KickRun> read_kick_runs(const WatchedRobot& robot) {
  std::vector<KickRun> commands = commanded(robot);
  std::vector<KickRun> runs = reported(robot, commands);
  return runs.empty() ? commands : runs;
}

}  // namespace robot::fit
