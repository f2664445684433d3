#include "tests/walk/rise.h"

#include <algorithm>
#include <numbers>

#include "robot/nao/guardian/guardian.h"
#include "tests/walk/dice.h"
#include "tests/walk/lola_body.h"

namespace robot::nao {
namespace {

constexpr std::uint64_t kCycle_ns = 12'000'000;  // of LoLA
constexpr int kLongest = 5000;                   // [cycles] a minute
constexpr int kStands = 167;                     // [cycles] two seconds
constexpr int kClick = 9;                        // [cycles] of a press of the chest button
constexpr double kLimbs = 0.4, kTorso = 0.15;    // [rad] deviations of a drop

/// A robot under its guardian, with one order at all times.
class Robot {
 public:
  Robot(walk::Servos servos, std::uint64_t seed) : body_(walk::draw_robot(seed, servos), seed, false, true) {
    cycle();
    for (int click = 0; click < 3; ++click)
      for (const float pressed : {1.0f, 0.0f}) {
        body_.sensors.touch[0] = pressed;
        for (int i = 0; i < kClick; ++i) cycle();
      }
    for (int i = 0; i < kLongest && guardian_.doing() != Doing::standing; ++i) cycle();
  }

  void cycle() {
    now_ns_ += kCycle_ns;
    body_.obey(guardian_.step({.now_ns = now_ns_, .sensors = &body_.sensors, .order = &order_}));
  }

  void drop(const Drop& drop) {
    order_.posture = Order::Posture::get_up;
    body_.drop(drop);
  }

  bool stands() const { return guardian_.doing() == Doing::standing && body_.upright(); }
  const Guardian& guardian() const { return guardian_; }

 private:
  LolaBody body_;
  Guardian guardian_;
  Order order_;
  std::uint64_t now_ns_ = 1'000'000'000;
};

}  // namespace

Drop draw_drop(Lying side, std::uint64_t seed) {
  walk::Dice dice(seed * 31 + static_cast<std::uint64_t>(side));
  Drop drop{.limbs = tuck()[0].position};
  for (std::size_t joint = l_shoulder_pitch; joint <= r_wrist_yaw; ++joint)
    drop.limbs[joint] = clamp(drop.limbs[joint] + static_cast<float>(kLimbs * dice.normal()), limits_of(joint).range);
  const double quarter = std::numbers::pi / 2;
  if (side == Lying::on_left) drop.roll = -quarter;
  if (side == Lying::on_right) drop.roll = quarter;
  if (side == Lying::on_back) drop.pitch = -quarter;
  if (side == Lying::on_front) drop.pitch = quarter;
  drop.roll += kTorso * dice.normal(), drop.pitch += kTorso * dice.normal();
  return drop;
}

Rise rise(walk::Servos servos, std::uint64_t seed, Lying side) {
  Robot robot(servos, seed);
  robot.drop(draw_drop(side, seed));
  Rise result;
  int falls = 0, failed = 0, stands = 0, from = -1;
  for (int i = 0; i < kLongest; ++i) {
    const Doing before = robot.guardian().doing();
    robot.cycle();
    const Doing now = robot.guardian().doing();
    if (now == Doing::getting_up && from < 0) from = i;
    falls += before == Doing::standing && now == Doing::falling && from >= 0;
    failed = std::max(failed, robot.guardian().failed_attempts());
    stands = from >= 0 && robot.stands() ? stands + 1 : 0;
    result.stood = stands == kStands;
    if (result.stood) result.seconds = (i - from - kStands) * 0.012;
    if (result.stood || robot.guardian().reason() == Reason::stays_down) break;
  }
  result.failed = failed + falls;
  return result;
}

}  // namespace robot::nao
