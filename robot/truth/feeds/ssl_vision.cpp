#include "robot/truth/feeds/ssl_vision.h"

#include <algorithm>
#include <utility>

#include "robot/core/clock.h"
#include "robot/core/text.h"
#include "robot/truth/feeds/ssl_merge.h"

namespace robot::truth {
namespace {

constexpr std::uint64_t kSilenceNs = kSecond;  // a camera without packets for this time is gone
constexpr std::uint64_t kLongestRoundNs = 50 * kMillisecond;

/// Returns the time from `then` to `now`, or 0 if it is the other way round.
std::uint64_t since(std::uint64_t then, std::uint64_t now) { return now - std::min(then, now); }

}  // namespace

Result<std::optional<TimedTruth>> SslVision::take(std::string_view bytes, std::uint64_t received_ns) {
  ++counts_.packets;
  warning_.clear();
  Result<SslPacket> packet = read_ssl_packet(bytes, teams_);
  if (!packet) {
    ++counts_.unreadable;
    return packet.failure();
  }
  warning_ = std::move(packet->warning);
  if (packet->field) field_ = packet->field;
  if (!packet->view) return std::optional<TimedTruth>();
  const SslView& view = *packet->view;

  forget_silent_cameras(received_ns);
  if (is_old(view)) return std::optional<TimedTruth>();
  const std::uint64_t capture_ns = since(view.latency_ns, received_ns);
  std::optional<TimedTruth> world;
  if (closes_round(view.camera, capture_ns, longest_round_ns(view.camera, received_ns))) world = close_round();
  cameras_[view.camera] = {.frame = view.frame, .sent = view.sent, .received_ns = received_ns};

  if (round_.empty()) first_capture_ns_ = last_capture_ns_ = capture_ns;
  first_capture_ns_ = std::min(first_capture_ns_, capture_ns);
  last_capture_ns_ = std::max(last_capture_ns_, capture_ns);
  last_received_ns_ = received_ns;
  round_.push_back(std::move(*packet->view));
  // a world that waited for a camera which is gone is left out, once: this image is newer
  if (round_.size() >= cameras_.size()) world = close_round();
  return world;
}

/// Counts an old image, and one of a camera whose numbers begin again.
bool SslVision::is_old(const SslView& view) {
  const auto known = cameras_.find(view.camera);
  if (known == cameras_.end() || view.frame > known->second.frame) return false;
  if (view.sent <= known->second.sent) {
    ++counts_.old;
    return true;
  }
  ++counts_.restarts;
  warning_ = formatted(
      "camera %u: frame %u comes after frame %u: SSL-Vision was started again, or two of them use this camera number",
      view.camera, view.frame, known->second.frame);
  return false;
}

void SslVision::forget_silent_cameras(std::uint64_t now_ns) {
  std::erase_if(cameras_, [&](const auto& entry) { return since(entry.second.received_ns, now_ns) >= kSilenceNs; });
}

/// Returns the longest time between the first image of a world and one of this camera [ns].
///
/// The images of n cameras out of step spread over (n - 1) / n of the time between two images. If they take longer, an image
/// is paired with one of the moment before, as after the start with cameras in step: a new round gives better pairs.
std::uint64_t SslVision::longest_round_ns(std::uint32_t camera, std::uint64_t received_ns) const {
  const auto known = cameras_.find(camera);
  if (known == cameras_.end()) return kLongestRoundNs;
  const std::uint64_t between_images_ns = since(known->second.received_ns, received_ns);
  return std::min(kLongestRoundNs, between_images_ns - between_images_ns / (2 * cameras_.size()));
}

bool SslVision::closes_round(std::uint32_t camera, std::uint64_t capture_ns, std::uint64_t longest_ns) const {
  if (round_.empty()) return false;
  if (since(first_capture_ns_, capture_ns) > longest_ns || since(capture_ns, last_capture_ns_) > longest_ns)
    return true;
  return std::ranges::find(round_, camera, &SslView::camera) != round_.end();
}

TimedTruth SslVision::close_round() {
  TimedTruth world{.capture_ns = last_capture_ns_, .truth = merge(round_, field_)};
  world.truth.set_detected_ns(last_received_ns_);
  round_.clear();
  return world;
}

}  // namespace robot::truth
