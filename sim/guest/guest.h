// Behaviours of a team that are not trees: shared libraries and processes.
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

/// The players of one side in one game. They have a memory: one object per game, used by one thread. The game runs only
/// forwards, unless a saved memory is loaded.
class GuestBehaviour : public agent::Behaviour {
 public:
  const std::string& name() const final { return name_; }
  /// Decides as any behaviour. After an error all robots stand, and problem() returns the error.
  motion::Command decide(const agent::Surroundings& surroundings, const agent::Game& game,
                         const agent::Beliefs& beliefs, Tick now, agent::Mind& mind, agent::Trace* trace) const final;

  /// Returns the error as a sentence, or an empty text.
  const std::string& problem() const { return problem_; }

  /// Returns the memory of the players as bytes, or nothing when they cannot save it.
  virtual std::optional<std::string> save() const { return {}; }
  /// Restores the memory from the bytes of save() in the same game.
  virtual robot::Result<void> load(std::string_view) { return robot::Error{name_ + " cannot load"}; }

 protected:
  GuestBehaviour(std::string name, std::uint64_t seed) : name_(std::move(name)), seed_(seed) {}

  /// Fills the command. Returns an error sentence, or an empty text.
  virtual std::string ask(const ForesightPlayer& player, const ForesightMoment& moment, ForesightCommand& command) = 0;

 private:
  const std::string name_;
  const std::uint64_t seed_;
  std::array<ForesightPlayer, kMaxPlayers + 1> players_{};  // by number; number 0: not yet known
  std::string problem_;
};

/// The maker of guests. Thread-safe.
class GuestFactory {
 public:
  virtual ~GuestFactory() = default;
  /// Makes the players of one side for a new game. `seed` starts their own random numbers.
  virtual std::unique_ptr<GuestBehaviour> begin(std::uint64_t seed) const = 0;
  /// Returns whether the guest can save and load: a game can then be set back without playing it again.
  virtual bool saves() const = 0;
};

/// Returns whether `name` is a guest: "./my_behaviour.so" and "pipe:python3 my_behaviour.py" are
/// guests; other names are those of trees.
bool is_guest(const std::string& name);

/// Opens the guest `name`. Errors are found before any game begins.
robot::Result<std::shared_ptr<const GuestFactory>> open(const std::string& name);

/// Returns the sentence for a file that exists and is not named as a behaviour: a program is started by pipe:, and JSON
/// is found by its path. Returns "" if there is no such file, or if its name or content says that it is a tree.
std::string advice_about(const std::string& name);

/// Returns a hash of the content: the bytes of the library, or the command and the files that it names.
std::uint64_t content_of(const std::string& name);

}  // namespace sim::guest
