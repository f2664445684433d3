#include "sim/learn/step.h"

#include <utility>

#include "robot/core/json_library.h"
#include "sim/math/random.h"

namespace sim::learn {
namespace {

/// Deals each seed's scores to the strategies anew: who played well is then chance.
void shuffle(std::vector<Scores>& all, std::uint64_t first_seed) {
  if (all.empty()) return;
  for (std::size_t e = 0; e < all.front().size(); ++e)
    for (std::size_t i = 0; i < all.front()[e].size(); ++i)
      for (std::size_t last = all.size() - 1; last > 0; --last) {
        const auto drawn = draw({first_seed + i}, static_cast<std::uint32_t>(e), Draw::learning,
                                0x80000000u | static_cast<std::uint32_t>(last));
        std::swap(all[last][e][i], all[drawn[0] % (last + 1)][e][i]);
      }
}

}  // namespace

robot::Result<std::vector<Scores>> Practice::play(const std::vector<io::Json>& strategies, Purpose purpose,
                                                  int count) const {
  return play_on(strategies, seeds.take(purpose, static_cast<std::uint64_t>(count)), count);
}

robot::Result<std::vector<Scores>> Practice::play_on(const std::vector<io::Json>& strategies, std::uint64_t first,
                                                     int count) const {
  auto scores = arena.play(strategies, first, count);
  if (scores && shuffled) shuffle(*scores, first);
  return scores;
}

bool is_sure(const contest::Mean& gain, int tests) {
  // quantiles of the normal distribution for 2.5 % shared by 1, 2, 4, 8 and 16 tests
  constexpr double kQuantiles[] = {1.96, 2.24, 2.50, 2.73, 2.96};
  int doubled = 0;
  while (doubled < 4 && (1 << doubled) < tests) ++doubled;
  return gain.error > 0 && gain.mean > kQuantiles[doubled] * gain.error;
}

}  // namespace sim::learn
