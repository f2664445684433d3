// The playback of a recording as clients control it: one that they share, and playheads of their own.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "robot/body/replay/replay.h"
#include "robot/net/foxglove/playback.h"

namespace robot::app {

/// The most playheads at one time beside the shared one. Each has a thread and some MB of open chunks.
inline constexpr int kMostOwnPlayheads = 16;

/// The shared playback of a Replay. Any thread.
class RecordingPlayback final : public net::Playback {
 public:
  /// `replay` outlives this and every playhead. A playhead of a client's own has the `speed` and `loop` of the beginning.
  RecordingPlayback(body::Replay& replay, double speed, bool loop) : replay_(replay), speed_(speed), loop_(loop) {}

  std::uint64_t start_ns() const override { return replay_.start_ns(); }
  std::uint64_t end_ns() const override { return replay_.end_ns(); }
  State state() const override;
  bool control(const net::foxglove::PlaybackControl& wish) override;

  /// Returns an Error if there are kMostOwnPlayheads already, or if the system allows no more threads.
  Result<std::unique_ptr<net::OwnPlayhead>> own_playhead(std::optional<std::uint64_t> from_ns) override;

 private:
  body::Replay& replay_;
  const double speed_;
  const bool loop_;
  const std::shared_ptr<std::atomic<int>> own_ = std::make_shared<std::atomic<int>>(0);  // playheads that exist
};

}  // namespace robot::app
