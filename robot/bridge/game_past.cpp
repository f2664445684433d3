#include "robot/bridge/game_past.h"

#include <algorithm>

namespace robot::bridge {
namespace {

constexpr sim::Tick kFirstInterval = 8;  // [ticks]

bool is_same(const sim::agent::Choice& one, const sim::agent::Choice& other) {
  return one.strategy == other.strategy && one.epoch == other.epoch;
}

}  // namespace

GamePast::GamePast() : frames_(kFrames) { edits_.reserve(kEdits); }

void GamePast::begin(const SimulatedGame& game) {
  interval_ = kFirstInterval;
  choices_.clear();
  edits_.clear();
  frames_[0] = game.moment();
  count_ = 1;
}

void GamePast::note(const SimulatedGame& game) {
  const sim::Tick now = game.state().world.tick;
  while (count_ > 1 && frames_[count_ - 1].state.world.tick > now) --count_;
  const auto undone = std::ranges::find_if(choices_, [&](const Followed& one) { return one.tick >= now; });
  choices_.erase(undone, choices_.end());
  std::erase_if(edits_, [&](const SimulatedGame::Moment& one) { return one.state.world.tick > now; });
  if (now == frames_[count_ - 1].state.world.tick || (now - first()) % interval_ != 0) return;
  if (count_ == kFrames) {
    // every second one stays
    for (std::size_t i = 1; 2 * i < count_; ++i) frames_[i] = frames_[2 * i];
    count_ = (count_ + 1) / 2;
    interval_ *= 2;
    if ((now - first()) % interval_ != 0) return;
  }
  frames_[count_++] = game.moment();
}

void GamePast::note_choice(sim::Tick tick, int robot, const sim::agent::Choice& choice) {
  if (choices_.empty() || !is_same(choices_.back().choice, choice)) choices_.push_back({tick, robot, choice});
}

bool GamePast::note_edit(const SimulatedGame::Moment& edited) {
  const sim::Tick now = edited.state.world.tick;
  std::erase_if(edits_, [&](const SimulatedGame::Moment& one) { return one.state.world.tick >= now; });
  if (edits_.size() == kEdits) return false;
  // the frame of this moment is that of the unedited game
  while (count_ > 1 && frames_[count_ - 1].state.world.tick >= now) --count_;
  if (now == first()) frames_[0] = edited;
  edits_.push_back(edited);
  return true;
}

void GamePast::go_to(sim::Tick tick, SimulatedGame& game) const {
  std::size_t frame = count_ - 1;
  while (frame > 0 && frames_[frame].state.world.tick >= tick) --frame;
  game.go_to(frames_[frame]);
  auto next = choices_.begin();
  auto edit = edits_.begin();
  // a frame may be older than the edit of its tick
  const auto take_edit = [&] {
    const sim::Tick now = game.state().world.tick;
    while (edit != edits_.end() && edit->state.world.tick < now) ++edit;
    if (edit != edits_.end() && edit->state.world.tick == now)
      game.change([&](sim::State& state) { state = edit->state; });
  };
  sim::referee::Events events;
  for (take_edit(); game.state().world.tick < tick && !game.finished(); take_edit()) {
    while (next != choices_.end() && next->tick <= game.state().world.tick) ++next;
    // the choice in force was followed in each tick
    if (next != choices_.begin()) game.follow(std::prev(next)->robot, std::prev(next)->choice);
    game.tick(events);
  }
}

}  // namespace robot::bridge
