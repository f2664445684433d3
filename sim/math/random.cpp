#include "sim/math/random.h"

#include <Random123/philox.h>

namespace sim {

std::array<std::uint32_t, 4> draw(RandomKey key, std::uint32_t robot, Event event, std::uint32_t number) {
  const philox4x32_ctr_t counter = {{number, static_cast<std::uint32_t>(event), robot, 0}};
  const philox4x32_key_t seed = {{static_cast<std::uint32_t>(key.seed), static_cast<std::uint32_t>(key.seed >> 32)}};
  const philox4x32_ctr_t words = philox4x32_R(7, counter, seed);
  return {words.v[0], words.v[1], words.v[2], words.v[3]};
}

}  // namespace sim
