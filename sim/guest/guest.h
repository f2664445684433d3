// Behaviours from outside: what a team brings, other than a tree.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "sim/agent/behaviour.h"
#include "sim/guest/foresight_behaviour.h"

namespace sim::guest {

/// The players of one side in one game. They remember: made for each game, used by one thread, its state played forwards
/// only unless it is loaded.
class GuestBehaviour : public agent::Behaviour {
 public:
  const std::string& name() const final { return name_; }
  /// As any behaviour, until something goes wrong; from then on everybody stands, and problem() says what it was.
  motion::Command decide(const agent::Surroundings& surroundings, const agent::Game& game,
                         const agent::Beliefs& beliefs, Tick now, agent::Mind& mind, agent::Trace* trace) const final;

  /// One sentence; empty: nothing is wrong.
  const std::string& problem() const { return problem_; }

  /// What the players remember, as bytes; nothing where they cannot save it.
  virtual std::optional<std::string> save() const { return {}; }
  /// Puts it back: what save() of the same game made.
  virtual robot::Result<void> load(std::string_view) { return robot::Error{name_ + " cannot load"}; }

 protected:
  GuestBehaviour(std::string name, std::uint64_t seed) : name_(std::move(name)), seed_(seed) {}

  /// Fills the command; empty, or what is wrong.
  virtual std::string ask(const ForesightPlayer& player, const ForesightMoment& moment, ForesightCommand& command) = 0;

 private:
  const std::string name_;
  const std::uint64_t seed_;
  std::array<ForesightPlayer, kMaxPlayers + 1> players_{};  // by number; number 0: not known yet
  std::string problem_;
};

/// Where guests come from; any thread.
class GuestFactory {
 public:
  virtual ~GuestFactory() = default;
  /// The players of one side for a new game. `seed`: of chance of their own.
  virtual std::unique_ptr<GuestBehaviour> begin(std::uint64_t seed) const = 0;
  /// A game can be taken back to a moment of it without playing it again.
  virtual bool saves() const = 0;
};

/// "./my_behaviour.so" and "pipe:python3 my_behaviour.py" are guests; other names are those of trees.
bool is_guest(const std::string& name);

/// `name` is such a one; what is wrong with it is told before any game begins.
robot::Result<std::shared_ptr<const GuestFactory>> open(const std::string& name);

/// A number for what is behind the name: the bytes of the library, the command and the files it names.
std::uint64_t content_of(const std::string& name);

}  // namespace sim::guest
