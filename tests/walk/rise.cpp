#include "tests/walk/rise.h"

#include <algorithm>

#include "tests/walk/robot_in_physics.h"

namespace robot::nao {
namespace {

constexpr int kLongest = 5000;  // [cycles] a minute
constexpr int kStands = 167;    // [cycles] two seconds

}  // namespace

Rise rise(walk::Servos servos, std::uint64_t seed, Lying side) {
  RobotInPhysics robot(servos, seed, false, true);
  robot.command.set_posture(foresight::MotionCommand::POSTURE_GET_UP);
  robot.body.drop(draw_drop(side, seed));
  Rise result;
  int falls = 0, failed = 0, stands = 0, from = -1;
  for (int i = 0; i < kLongest; ++i) {
    const Doing before = robot.guardian.doing();
    robot.cycle();
    const Doing now = robot.guardian.doing();
    if (now == Doing::getting_up && from < 0) from = i, result.lay = i * 0.012;
    falls += before == Doing::standing && now == Doing::falling && from >= 0;
    failed = std::max(failed, robot.guardian.failed_attempts());
    stands = from >= 0 && now == Doing::standing && robot.body.upright() ? stands + 1 : 0;
    result.stood = stands == kStands;
    if (result.stood) result.seconds = (i - from - kStands) * 0.012;
    if (result.stood || robot.guardian.reason() == Reason::stays_down) break;
  }
  result.failed = failed + falls;
  return result;
}

std::vector<Rise> rises(walk::Servos servos, std::uint64_t first_seed, int robots, Lying side) {
  std::vector<Rise> all;
  for (int i = 0; i < robots; ++i) all.push_back(rise(servos, first_seed + static_cast<std::uint64_t>(i), side));
  return all;
}

}  // namespace robot::nao
