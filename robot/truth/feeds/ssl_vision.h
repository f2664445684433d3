// Packets of SSL-Vision as ground truth.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"
#include "robot/truth/feeds/ssl_packet.h"
#include "robot/truth/feeds/timed_truth.h"

namespace robot::truth {

/// Counts of packets so far.
struct SslVisionCounts {
  std::uint64_t packets = 0;     // all
  std::uint64_t unreadable = 0;  // no packets of SSL-Vision, or with wrong numbers
  std::uint64_t old = 0;         // dropped: they arrived after a later one of their camera, or twice
  std::uint64_t restarts = 0;    // of the frame numbers of a camera
};

/// The world that SSL-Vision sees, from packets of all its cameras. Pure: the caller gives the times of arrival.
///
/// SSL-Vision sends one packet for each image of each camera. A world is complete when each camera that was heard in the
/// last second has sent one. A camera that sends again before another one has, or whose image fits better into the next
/// world, also completes it: the other camera's things are then missing. Images of one world are at most 50 ms apart.
///
/// Times: the sender's clock is not ours, so only its differences count. The capture time of an image is the time of its
/// packet's arrival minus (t_sent - t_capture). It is late by the network's delay, below 1 ms by cable. The capture time of
/// a world is that of its newest image.
class SslVision {
 public:
  explicit SslVision(const SslTeams& teams) : teams_(teams) {}

  /// Takes a packet that arrived at `received_ns` [ns since the epoch]. Returns the world that it completes, or nothing.
  /// Returns an Error for a packet that read_ssl_packet() refuses.
  ///
  /// A packet whose frame number and t_sent do not rise is old and dropped. If only t_sent rises, SSL-Vision was started
  /// again. After one second without a newer packet any packet of a camera is taken.
  Result<std::optional<TimedTruth>> take(std::string_view packet, std::uint64_t received_ns);

  const SslVisionCounts& counts() const { return counts_; }

  /// Returns the size of the field, or nothing before the first packet that has it.
  const std::optional<SslField>& field() const { return field_; }

  /// Returns a sentence about the last packet: an id that is no player, a restart. Empty: all is well.
  const std::string& warning() const { return warning_; }

 private:
  /// The newest image of a camera.
  struct Camera {
    std::uint32_t frame = 0;
    double sent = 0;                // [s, their clock]
    std::uint64_t received_ns = 0;  // ours
  };

  bool is_old(const SslView& view);
  void forget_silent_cameras(std::uint64_t now_ns);
  std::uint64_t longest_round_ns(std::uint32_t camera, std::uint64_t received_ns) const;
  bool closes_round(std::uint32_t camera, std::uint64_t capture_ns, std::uint64_t longest_ns) const;
  TimedTruth close_round();

  const SslTeams teams_;
  std::map<std::uint32_t, Camera> cameras_;  // heard in the last second
  std::vector<SslView> round_;               // the images of the world that is not complete yet
  std::uint64_t first_capture_ns_ = 0, last_capture_ns_ = 0, last_received_ns_ = 0;  // of the round
  std::optional<SslField> field_;
  SslVisionCounts counts_;
  std::string warning_;
};

}  // namespace robot::truth
