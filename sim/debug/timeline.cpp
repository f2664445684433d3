#include "sim/debug/timeline.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace sim::debug {

Timeline::Timeline(SharedSetup setup, const State& start, std::size_t most_bytes)
    : most_bytes_(most_bytes), played_(start.world.tick), frames_{std::make_shared<const State>(start)} {
  parts_.push_back({played_, std::move(setup)});
}

State Timeline::at(Tick tick) {
  assert(tick >= first());
  const auto behind = std::ranges::upper_bound(frames_, tick, {}, [](const auto& frame) { return frame->world.tick; });
  State state = **(behind - 1);
  referee::Events events;
  while (state.world.tick < tick && !finished(state)) advance(state, events);
  return state;
}

const SharedSetup& Timeline::setup_at(Tick tick) const {
  const auto behind = std::ranges::upper_bound(parts_, tick, {}, &Part::from);
  return behind == parts_.begin() ? behind->setup : (behind - 1)->setup;
}

void Timeline::advance(State& state, referee::Events& events) {
  step(setup_at(state.world.tick)->params, state, events);
  const Tick tick = state.world.tick;
  played_ = std::max(played_, tick);
  if (tick <= frames_.back()->world.tick || !is_due(tick)) return;
  frames_.push_back(std::make_shared<const State>(state));
  if (bytes() > most_bytes_) thin_out();
}

void Timeline::thin_out() {
  interval_ *= 2;
  std::erase_if(frames_, [&](const auto& frame) {
    const Tick tick = frame->world.tick;
    const bool begins_part = std::ranges::any_of(parts_, [&](const Part& part) { return part.from == tick; });
    return !begins_part && !is_due(tick);
  });
}

void Timeline::change(const State& state, SharedSetup setup) {
  const Tick tick = state.world.tick;
  assert(tick >= first() && tick <= played_);
  std::erase_if(frames_, [&](const auto& frame) { return frame->world.tick >= tick; });
  std::erase_if(parts_, [&](const Part& part) { return part.from >= tick; });
  frames_.push_back(std::make_shared<const State>(state));
  parts_.push_back({tick, std::move(setup)});
  played_ = tick;
}

std::vector<Tick> Timeline::key_frames() const {
  std::vector<Tick> ticks;
  for (const auto& frame : frames_) ticks.push_back(frame->world.tick);
  return ticks;
}

}  // namespace sim::debug
