#include "robot/fit/walking/drive_track.h"

#include <algorithm>
#include <cmath>

namespace robot::fit {
namespace {

constexpr double kTickSeconds = 1. / 30;

/// Returns the true headings [rad] in the middle of each tick.
std::vector<double> headings_of(const Drive& drive) {
  std::vector<double> headings(drive.commands.size());
  std::size_t next = 1;
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const double at = static_cast<double>(i) + 0.5;
    while (next + 1 < drive.poses.size() && drive.poses[next].tick < at) ++next;
    const DrivePose &before = drive.poses[next - 1], &after = drive.poses[next];
    const double share = std::clamp((at - before.tick) / (after.tick - before.tick), 0., 1.);
    headings[i] = before.heading + share * (after.heading - before.heading);
  }
  return headings;
}

BlockStep turned_into(const DriveTrack& track, double x, double y, double turn, std::size_t middle) {
  const double c = track.cosine(middle), s = track.sine(middle);
  return {.ahead = c * x + s * y, .left = c * y - s * x, .turn = turn};
}

}  // namespace

DriveTrack::DriveTrack(const Drive& drive) : drive_(drive) {
  for (const double heading : headings_of(drive))
    cosines_.push_back(std::cos(heading)), sines_.push_back(std::sin(heading));
  const std::size_t settled = std::min(drive.settled, drive.commands.size());
  counts_.resize((drive.commands.size() - settled) / kBlockTicks);
  seen_.resize(counts_.size());
  for (const DrivePose& pose : drive.poses) {
    const double beyond = pose.tick - static_cast<double>(settled);
    const std::size_t block = beyond < 0 ? counts_.size() : static_cast<std::size_t>(beyond / kBlockTicks);
    block_of_.push_back(block);
    if (block >= counts_.size()) continue;
    ++counts_[block];
    seen_[block].x += pose.x, seen_[block].y += pose.y, seen_[block].heading += pose.heading;
  }
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const double count = std::max(1., static_cast<double>(counts_[i]));
    seen_[i].x /= count, seen_[i].y /= count, seen_[i].heading /= count;
  }
}

std::vector<BlockMean> DriveTrack::predicted(const std::vector<WalkRates>& rates, double late) const {
  const std::size_t ticks = cosines_.size();
  const double whole = std::floor(late / kTickSeconds), rest = late / kTickSeconds - whole;
  const auto rate_at = [&](std::size_t tick, double back) {
    const double at = std::clamp(static_cast<double>(tick) - back, 0., static_cast<double>(ticks - 1));
    return rates[static_cast<std::size_t>(at)];
  };
  // the path at the begin of each tick
  std::vector<BlockMean> path(ticks + 1);
  for (std::size_t i = 0; i < ticks; ++i) {
    WalkRates rate = rates[i];
    if (late != 0) {
      const WalkRates one = rate_at(i, whole), other = rate_at(i, whole + 1);
      rate = {one.x + rest * (other.x - one.x), one.y + rest * (other.y - one.y),
              one.turn + rest * (other.turn - one.turn)};
    }
    path[i + 1] = {path[i].x + kTickSeconds * (cosines_[i] * rate.x - sines_[i] * rate.y),
                   path[i].y + kTickSeconds * (sines_[i] * rate.x + cosines_[i] * rate.y),
                   path[i].heading + kTickSeconds * rate.turn};
  }
  std::vector<BlockMean> means(counts_.size());
  for (std::size_t k = 0; k < drive_.poses.size(); ++k) {
    if (block_of_[k] >= means.size()) continue;
    const auto tick = static_cast<std::size_t>(drive_.poses[k].tick);
    const double share = drive_.poses[k].tick - static_cast<double>(tick),
                 part = 1. / static_cast<double>(counts_[block_of_[k]]);
    const BlockMean &from = path[tick], &to = path[std::min(tick + 1, ticks)];
    BlockMean& mean = means[block_of_[k]];
    mean.x += part * (from.x + share * (to.x - from.x));
    mean.y += part * (from.y + share * (to.y - from.y));
    mean.heading += part * (from.heading + share * (to.heading - from.heading));
  }
  return means;
}

BlockStep missed_between(const DriveTrack& track, const std::vector<BlockMean>& predicted, std::size_t from,
                         std::size_t to) {
  const BlockMean &a = track.seen(from), &b = track.seen(to), &p = predicted[from], &q = predicted[to];
  return turned_into(track, b.x - a.x - (q.x - p.x), b.y - a.y - (q.y - p.y),
                     b.heading - a.heading - (q.heading - p.heading), (from + to) / 2);
}

BlockStep seen_between(const DriveTrack& track, std::size_t from, std::size_t to) {
  const BlockMean &a = track.seen(from), &b = track.seen(to);
  return turned_into(track, b.x - a.x, b.y - a.y, b.heading - a.heading, (from + to) / 2);
}

}  // namespace robot::fit
