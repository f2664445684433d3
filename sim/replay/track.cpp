#include "sim/replay/track.h"

#include <algorithm>

#include "sim/math/angles.h"

namespace sim::replay {
namespace {

constexpr Tick kAround = 15;       // [ticks] before and after a sample, for the direction of the walk
constexpr float kStanding = 0.1f;  // [m] a robot that moved less in that time stands

/// Returns the direction of the walk at sample `i` [rad], or nothing while the robot stands.
std::optional<float> way_at(const std::vector<Sample>& samples, std::size_t i) {
  std::size_t first = i, last = i;
  while (first > 0 && samples[i].at - samples[first - 1].at <= kAround) --first;
  while (last + 1 < samples.size() && samples[last + 1].at - samples[i].at <= kAround) ++last;
  const Vec2 way = samples[last].position - samples[first].position;
  if (squared_length(way) < kStanding * kStanding) return {};
  return atan2(way.y, way.x);
}

}  // namespace

Track::Track(std::vector<Sample> samples) : samples_(std::move(samples)) {
  const auto same = [](const Sample& a, const Sample& b) { return a.at == b.at; };
  samples_.erase(std::unique(samples_.begin(), samples_.end(), same), samples_.end());
  float heading = 0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    Sample& sample = samples_[i];
    if (!sample.heading) sample.heading = way_at(samples_, i).value_or(heading);
    heading = *sample.heading;
  }
}

std::optional<Place> Track::at(Tick tick) const {
  const auto next = std::ranges::upper_bound(samples_, tick, {}, &Sample::at);
  if (next == samples_.begin()) return {};
  const Sample& before = *(next - 1);
  Place place{.position = before.position, .heading = *before.heading, .fallen = before.fallen};
  if (before.at == tick) return place;

  const bool bridged = next != samples_.end() && next->at - before.at <= kBridged;
  if (bridged) {
    const float share = static_cast<float>(tick - before.at) / static_cast<float>(next->at - before.at);
    place.position += share * (next->position - before.position);
    place.heading = normalized(place.heading + share * normalized(*next->heading - *before.heading));
    return place;
  }
  if (tick - before.at > kBridged) return {};
  place.held = true;
  return place;
}

Vec2 Track::velocity_at(Tick tick) const {
  const auto next = std::ranges::upper_bound(samples_, tick, {}, &Sample::at);
  if (next == samples_.begin() || next == samples_.end()) return {};
  const Tick passed = next->at - (next - 1)->at;
  if (passed > kBridged) return {};
  return (1 / (static_cast<float>(passed) * kTickDuration)) * (next->position - (next - 1)->position);
}

}  // namespace sim::replay
