#include "sim/contest/lineup.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <utility>

#include "sim/io/chooser.h"

namespace sim::contest {
namespace {

using robot::Result;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kSampled = 17;  // every 17th decision of a tree is timed: no multiple of a team's size

Result<Named> find(const std::string& name, const io::Matchup& game, Side side) {
  if (guest::is_guest(name)) {
    auto source = guest::open(name);
    if (!source) return source.failure();
    return Named{.tree = nullptr, .guest = *std::move(source)};
  }
  auto tree = io::load_behaviour(name, game, side);
  if (!tree) {
    if (std::string advice = guest::advice_about(name); !advice.empty()) return robot::Error{std::move(advice)};
    return tree.failure();
  }
  return Named{.tree = *std::move(tree), .guest = nullptr};
}

}  // namespace

Result<Lineup> Lineup::prepare(const LineupChoice& choice) {
  Lineup lineup;
  lineup.changed_ = choice.changed;
  // "idle" keeps the place of a guest until the game begins
  io::Matchup warm = choice.game;
  for (const int side : {0, 1}) {
    const std::string& rest = choice.rest[side];
    for (const std::string* name : {&choice.game.strategies[side], &rest}) {
      if (name->empty()) continue;
      auto named = find(*name, choice.game, static_cast<Side>(side));
      if (!named) return named.failure();
      if (named->guest) lineup.has_guest_[side] = true;
      (name == &rest ? lineup.rest_ : lineup.first_)[side] = *std::move(named);
    }
    if (lineup.first_[side].guest) warm.strategies[side] = "idle";
  }
  auto setup = io::prepare(warm);
  if (!setup) return setup.failure();
  lineup.setup_ = *std::move(setup);
  return lineup;
}

/// A behaviour that times its decisions.
class Cast::Player final : public agent::Behaviour {
 public:
  Player(const Named& named, std::uint64_t seed, Side side)
      : tree_(named.tree), guest_(named.guest ? named.guest->begin(seed) : nullptr), side_(side) {}

  const std::string& name() const override { return behaviour().name(); }

  motion::Command decide(const agent::Surroundings& surroundings, const agent::Game& game,
                         const agent::Beliefs& beliefs, Tick now, agent::Mind& mind,
                         agent::Trace* trace) const override {
    if (!guest_ && ++decisions_ % kSampled != 0) return tree_->decide(surroundings, game, beliefs, now, mind, trace);
    const Clock::time_point begin = Clock::now();
    const motion::Command command = behaviour().decide(surroundings, game, beliefs, now, mind, trace);
    cost_.add({.timed = 1, .ns = std::chrono::duration<double, std::nano>(Clock::now() - begin).count()});
    return command;
  }

  guest::GuestBehaviour* guest() const { return guest_.get(); }
  Side side() const { return side_; }
  const DecisionCost& cost() const { return cost_; }

 private:
  const agent::Behaviour& behaviour() const { return guest_ ? *guest_ : *tree_; }

  const std::shared_ptr<const agent::Behaviour> tree_;
  const std::unique_ptr<guest::GuestBehaviour> guest_;
  const Side side_;
  // used only by the thread that plays this game
  mutable std::uint64_t decisions_ = 0;
  mutable DecisionCost cost_;
};

Cast::Cast(const Lineup& lineup, std::uint64_t seed) : params_(lineup.params()) {
  for (const Side side : {Side::home, Side::away}) {
    const int index = static_cast<int>(side);
    const agent::Behaviour* first = seat(lineup.first_[index], seed, side);
    if (lineup.rest_[index].tree || lineup.rest_[index].guest) {
      const agent::Behaviour* rest = seat(lineup.rest_[index], seed, side);
      mixed_[index] = std::make_unique<agent::Mixed>(*first, lineup.changed_, *rest);
      first = mixed_[index].get();
    }
    params_.teams[index].behaviour = first;
  }
}

Cast::~Cast() = default;

const agent::Behaviour* Cast::seat(const Named& named, std::uint64_t seed, Side side) {
  players_.push_back(std::make_unique<Player>(named, 2 * seed + static_cast<std::uint64_t>(side), side));
  if (guest::GuestBehaviour* guest = players_.back()->guest()) guests_.push_back(guest);
  return players_.back().get();
}

bool Cast::failed() const {
  return std::ranges::any_of(guests_, [](const guest::GuestBehaviour* guest) { return !guest->problem().empty(); });
}

std::string Cast::problem() const {
  for (const guest::GuestBehaviour* guest : guests_)
    if (!guest->problem().empty()) return guest->problem();
  return {};
}

DecisionCost Cast::cost(Side side) const {
  DecisionCost sum;
  for (const auto& player : players_)
    if (player->side() == side) sum.add(player->cost());
  return sum;
}

std::optional<std::string> Cast::save() const {
  std::string all;
  for (const guest::GuestBehaviour* guest : guests_) {
    const auto bytes = guest->save();
    if (!bytes) return {};
    const std::uint64_t length = bytes->size();
    all.append(reinterpret_cast<const char*>(&length), sizeof length).append(*bytes);
  }
  return all;
}

Result<void> Cast::load(std::string_view bytes) {
  for (guest::GuestBehaviour* guest : guests_) {
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof length);
    bytes.remove_prefix(sizeof length);
    if (auto loaded = guest->load(bytes.substr(0, length)); !loaded) return loaded;
    bytes.remove_prefix(length);
  }
  return {};
}

void Costs::add(const Cast& cast) {
  const std::lock_guard guard(lock_);
  for (const Side side : {Side::home, Side::away}) cost_[static_cast<int>(side)].add(cast.cost(side));
}

std::string Costs::text() const {
  const std::lock_guard guard(lock_);
  return cost_text(cost_[0], cost_[1]);
}

std::string cost_text(const DecisionCost& home, const DecisionCost& away) {
  char text[100];
  std::snprintf(text, sizeof text, "\na decision costs  home %.2f us, away %.2f us\n", home.mean_us(), away.mean_us());
  return text;
}

}  // namespace sim::contest
