#include "sim/contest/moments.h"

#include "sim/match/play.h"
#include "sim/referee/referee.h"

namespace sim::contest {
namespace {

bool has_just_looked(const State& state, int robot) {
  const Schedule& schedule = state.schedule;
  return schedule.turn[robot] != kNever && schedule.turn[robot] + 1 == state.world.tick + schedule.lag[robot];
}

}  // namespace

void for_each_moment(const Params& params, std::uint64_t seed, int count, int robot,
                     const std::function<void(const State&)>& see) {
  const Tick apart =
      ticks(params.rules.half_duration * static_cast<float>(params.rules.halves)) / static_cast<Tick>(count + 1);
  referee::Events events;
  State state = begin(params, {.seed = seed}, events);
  for (int i = 0; i < count; ++i) {
    const Tick at = state.world.tick + apart;
    play(
        params, state,
        [&](const State& now) {
          return now.world.tick >= at && referee::in_play(now.book) && has_just_looked(now, robot);
        },
        [](const referee::Event&) {});
    if (finished(state)) return;
    see(state);
  }
}

}  // namespace sim::contest
