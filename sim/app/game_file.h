// A simulated game as a recording: the truth, and every robot's memory as a live simulation writes it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/bridge/narrator.h"
#include "robot/bridge/simulated_game.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/writer.h"
#include "robot/memory/channels.h"

namespace sim::app {

/// Tick 0 of every recorded game, so that the same game gives the same bytes: 2012-06-18 12:00 UTC, the week of the
/// RoboCup that the thesis was written for.
inline constexpr std::uint64_t kGameEpochNs = 1'340'020'800'000'000'000;

/// The recorder of the objects that robot::bridge::Narrator writes. Without a successful close() its end removes the file,
/// so that a game that failed leaves none. Used by one thread.
class GameFile {
 public:
  /// Creates the file. Returns an Error if it exists. `seed` goes into the file's metadata.
  static robot::Result<GameFile> create(const std::filesystem::path& path, const robot::bridge::SimulatedGame& game,
                                        std::uint64_t seed);

  /// Adds the objects of the game's present tick. Call it at the beginning and after each tick.
  robot::Result<void> add(const robot::bridge::SimulatedGame& game);

  robot::Result<void> close();

  std::uint64_t messages() const { return file_->messages(); }
  std::uint64_t size_bytes() const { return file_->size_bytes(); }

 private:
  /// A channel of the memory, and the newest version that is in the file.
  struct Recorded {
    std::shared_ptr<robot::memory::Channel> channel;
    std::uint64_t sequence = 0;  // of that version
    std::uint64_t messages = 0;  // in the file
  };

  /// A file that is removed unless it is complete.
  struct Draft {
    explicit Draft(std::filesystem::path file) : path(std::move(file)) {}
    ~Draft();
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;

    const std::filesystem::path path;
    bool complete = false;
  };

  explicit GameFile(const robot::bridge::SimulatedGame& game);

  std::unique_ptr<robot::bridge::Narrator> narrator_;
  const robot::bridge::Timeline timeline_{.epoch_ns = kGameEpochNs};
  std::vector<Recorded> channels_;  // in the order of the file
  std::unique_ptr<Draft> draft_;
  std::optional<robot::logging::McapWriter> file_;
};

}  // namespace sim::app
