#include "sim/motion/fall_table.h"

#include <algorithm>

#include "sim/math/angles.h"

namespace sim::motion {

float Toppling::probability(Vec2 impulse) const {
  constexpr float kLeast = 1e-6f;  // [N s] the logarithm of a smaller one is not needed
  const float strength = std::max(length(impulse), kLeast);
  // between the two nearest directions
  const float eighths = angle_of(impulse) * (4 / kPi) + 8;
  const int before = static_cast<int>(eighths);
  const float from = half[before % 8], to = half[(before + 1) % 8];
  const float middle = from + (eighths - static_cast<float>(before)) * (to - from);
  return 1 / (1 + exp(slope * (log(middle) - log(strength))));
}

float FallTable::usual_time() const {
  const auto time_of = [&](const GettingUp& one) {
    const float aside = std::max(0.f, 1 - alone.front - alone.back);
    return one.lying + alone.front * one.front + alone.back * one.back + aside * one.side;
  };
  return collisions.soft * time_of(soft.getting_up) + (1 - collisions.soft) * time_of(stiff.getting_up);
}

Lying lying_after(Vec2 push) {
  if (std::fabs(push.x) >= std::fabs(push.y)) return push.x > 0 ? Lying::on_front : Lying::on_back;
  return push.y > 0 ? Lying::on_left : Lying::on_right;
}

}  // namespace sim::motion
