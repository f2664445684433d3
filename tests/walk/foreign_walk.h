// A walk from a library of another team (tests/walk/foresight_walk.h).
#pragma once

#include <filesystem>
#include <memory>

#include "robot/core/result.h"
#include "tests/walk/foresight_walk.h"
#include "tests/walk/trial.h"

namespace robot::nao::walk {

/// A loaded library. Its gaits must end before it.
class ForeignWalk {
 public:
  /// Loads the library, or says what is wrong with it.
  static Result<ForeignWalk> load(const std::filesystem::path& library);

  /// Returns the legs of a standing robot.
  Legs stand() const;
  /// Returns the height of its hips above the soles [m].
  double hip_height() const;
  /// Returns a new gait, or null if the library gives none.
  std::unique_ptr<Gait> begin() const;

 private:
  friend class ForeignGait;

  std::shared_ptr<void> library_;
  decltype(&foresight_walk_stand) stand_ = nullptr;
  decltype(&foresight_walk_begin) begin_ = nullptr;
  decltype(&foresight_walk_tick) tick_ = nullptr;
  decltype(&foresight_walk_end) end_ = nullptr;
};

}  // namespace robot::nao::walk
