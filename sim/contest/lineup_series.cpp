#include "sim/contest/lineup_series.h"

namespace sim::contest {
namespace {

constexpr int kPartsOfAThread = 2;
constexpr int kMostOfACast = 2 * static_cast<int>(kTogether);

}  // namespace

int games_of_a_cast(const Lineup& lineup, const Series& series) {
  if (lineup.has_guest(Side::home) || lineup.has_guest(Side::away)) return 1;
  const int parts = kPartsOfAThread * (series.threads > 0 ? series.threads : threads_for(series.games));
  return std::clamp((series.games + parts - 1) / parts, 1, kMostOfACast);
}

}  // namespace sim::contest
