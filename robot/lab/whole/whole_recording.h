// Answers about the whole of a played recording: numbers over time, runs of words, events.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "robot/body/replay/replay.h"
#include "robot/lab/whole/grid.h"
#include "robot/lab/whole/recorded_events.h"
#include "robot/lab/whole/runs.h"

namespace robot::lab {

/// A field of a topic, as the viewer writes it: "/14/2/ball.x".
struct WholeField {
  std::string text;
  std::string topic, path;  // "/14/2/ball", "x"
};

/// The answers, from a reading of the files for each question, and a memory of the last ones. A recording does not change
/// while it is played, so an answer stays right. Nothing is kept beside the files: a reading takes less than a second,
/// and a folder may be read-only or somebody else's. Any thread.
class WholeRecording {
 public:
  /// A kept summary has this many intervals, 73 ms each for 20 minutes. A finer question reads its range of the files.
  static constexpr std::size_t kKept = 16384;
  /// Kept summaries, of half a megabyte each; the one that nobody asked for longest goes first.
  static constexpr std::size_t kMostKept = 48;

  /// `replay` outlives this.
  explicit WholeRecording(const body::Replay& replay) : replay_(replay) {}

  /// Splits "/14/2/ball.x" at the longest topic that is played. Returns an Error if no topic fits.
  Result<WholeField> field(const std::string& text) const;

  /// A summary of one field, or a sentence that says why there is none.
  struct Summary {
    std::optional<Grid> grid;
    std::string problem;
    std::uint64_t damages = 0;  // places in the files that were passed over
  };

  /// Returns a summary of each field from `from_ns` to `to_ns` with at most `most` intervals, all from one reading.
  /// Returns nothing when it was cancelled, which it asks for every few messages.
  std::optional<std::vector<Summary>> summaries(const std::vector<WholeField>& fields, std::uint64_t from_ns,
                                                std::uint64_t to_ns, std::size_t most,
                                                const std::function<bool()>& cancelled);

  /// Returns the runs of these fields of a topic. Returns an Error if it is not played, cannot be decoded, or if the
  /// reading was cancelled.
  Result<Runs> runs(const std::string& topic, const std::vector<std::string>& paths,
                    const std::function<bool()>& cancelled) const;

  /// Returns all events of all robots. Returns null when it was cancelled.
  std::shared_ptr<const RecordedEvents> events(const std::function<bool()>& cancelled);

  std::uint64_t start_ns() const { return replay_.start_ns(); }
  std::uint64_t end_ns() const { return replay_.end_ns(); }

 private:
  struct Kept {
    std::string text;
    std::shared_ptr<const Summary> summary;
  };

  std::shared_ptr<const Summary> kept(const std::string& text);
  void keep(const std::string& text, std::shared_ptr<const Summary> summary);
  std::optional<std::vector<Summary>> read(const std::vector<WholeField>& fields, const Grid& empty,
                                           std::uint64_t to_ns, const std::function<bool()>& cancelled) const;

  const body::Replay& replay_;
  std::mutex lock_;       // held for a look-up only; guards the rest
  std::list<Kept> kept_;  // the last used first
  std::shared_ptr<const RecordedEvents> events_;
};

}  // namespace robot::lab
