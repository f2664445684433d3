#include "sim/debug/timeline.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

namespace sim::debug {
namespace {

constexpr auto tick_of = [](const auto& frame) { return frame->state.world.tick; };

}  // namespace

Timeline::Timeline(SharedSetup setup, const State& start, std::size_t most_bytes)
    : most_bytes_(most_bytes),
      seed_(start.world.key.seed),
      played_(start.world.tick),
      frames_{std::make_shared<const Frame>(Frame{start, {}})} {
  const bool has_players = setup->lineup != nullptr;
  parts_.push_back({played_, std::move(setup)});
  if (!has_players) return;
  begin_players(played_);
  saves_ = players_.cast->save().has_value();
  frames_.clear();
  keep(start);
}

const Timeline::Frame& Timeline::frame_before(Tick tick) const {
  return **(std::ranges::upper_bound(frames_, tick, {}, tick_of) - 1);
}

State Timeline::at(Tick tick) {
  assert(tick >= first());
  State state;
  if (!parts_.front().setup->lineup) {
    state = frame_before(tick).state;
  } else {
    if (!players_.cast || players_.state.world.tick > tick) begin_players(tick);
    state = players_.state;
  }
  referee::Events events;
  while (state.world.tick < tick && !finished(state)) advance(state, events);
  return state;
}

const SharedSetup& Timeline::setup_at(Tick tick) const {
  const auto behind = std::ranges::upper_bound(parts_, tick, {}, &Part::from);
  return behind == parts_.begin() ? behind->setup : (behind - 1)->setup;
}

void Timeline::begin_players(Tick tick) {
  const Frame& frame = saves_ ? frame_before(tick) : *frames_.front();
  const SharedSetup& setup = parts_.front().setup;
  players_.cast = std::make_unique<contest::Cast>(*setup->lineup, seed_);
  players_.part = nullptr;
  players_.state = frame.state;
  players_.problem.clear();
  if (frame.memory.empty()) return;
  if (const auto loaded = players_.cast->load(frame.memory); !loaded) players_.problem = loaded.error();
}

std::string Timeline::problem() const {
  if (!players_.problem.empty() || !players_.cast) return players_.problem;
  return players_.cast->problem();
}

const Params& Timeline::params_at(Tick tick) {
  const Setup& setup = *setup_at(tick);
  if (!players_.cast) return setup.params;
  if (players_.part == &setup) return players_.params;
  players_.part = &setup;
  players_.params = setup.params;
  for (const int side : {0, 1}) {
    const agent::Behaviour*& behaviour = players_.params.teams[side].behaviour;
    if (dynamic_cast<const Outside*>(behaviour)) behaviour = players_.cast->params().teams[side].behaviour;
  }
  return players_.params;
}

void Timeline::advance(State& state, referee::Events& events) {
  assert(!players_.cast || players_.state.world.tick == state.world.tick);
  step(params_at(state.world.tick), state, events);
  const Tick tick = state.world.tick;
  if (begins_part(tick)) state = frame_before(tick).state;
  if (players_.cast) players_.state = state;
  played_ = std::max(played_, tick);
  if (tick <= frames_.back()->state.world.tick || !is_due(tick)) return;
  keep(state);
  if (bytes() > most_bytes_) thin_out();
}

void Timeline::keep(const State& state) {
  auto memory = players_.cast && saves_ ? players_.cast->save() : std::nullopt;
  frames_.push_back(std::make_shared<const Frame>(Frame{state, memory ? *std::move(memory) : std::string()}));
}

void Timeline::thin_out() {
  interval_ *= 2;
  std::erase_if(frames_, [&](const auto& frame) { return !begins_part(tick_of(frame)) && !is_due(tick_of(frame)); });
}

void Timeline::change(const State& state, SharedSetup setup) {
  const Tick tick = state.world.tick;
  assert(tick >= first() && tick <= played_);
  if (parts_.front().setup->lineup) {
    at(tick);  // the behaviours from outside remember the past
    players_.state = state;
    players_.part = nullptr;
  }
  std::erase_if(frames_, [&](const auto& frame) { return tick_of(frame) >= tick; });
  std::erase_if(parts_, [&](const Part& part) { return part.from >= tick; });
  keep(state);
  parts_.push_back({tick, std::move(setup)});
  played_ = tick;
}

std::size_t Timeline::bytes() const {
  std::size_t sum = frames_.size() * sizeof(Frame);
  if (!parts_.front().setup->lineup) return sum;
  for (const auto& frame : frames_) sum += frame->memory.size();
  return sum;
}

std::vector<Tick> Timeline::key_frames() const {
  std::vector<Tick> ticks;
  for (const auto& frame : frames_) ticks.push_back(tick_of(frame));
  return ticks;
}

}  // namespace sim::debug
