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

}  // namespace sim::motion
