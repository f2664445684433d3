#include "tests/walk/drop.h"

#include <numbers>

#include "tests/walk/dice.h"

namespace robot::nao {
namespace {

constexpr double kLimbs = 0.4, kTorso = 0.15;  // [rad] deviations

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

}  // namespace robot::nao
