#include "robot/fit/walking/drives.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "robot/fit/math/angles.h"
#include "robot/fit/math/resampling.h"
#include "robot/fit/walking/mean_walk.h"
#include "sim/math/tick.h"

namespace robot::fit {
namespace {

constexpr double kDriveTick = 1. / 30;                         // [s]
constexpr double kLongestDrive = 20;                           // [s] of a drive
constexpr double kSettlingTime = 1.5;                          // [s] a start with its delay, or a stop
constexpr double kShortestDrive = 1;                           // [s] after that
constexpr double kCommandHeld = 0.5;                           // [s] that a command is in force without a repetition
constexpr double kIdleKept = 2;                                // [s] of standing that a drive keeps
constexpr double kBeforeDisturbed = 0.1, kAfterDisturbed = 1;  // [s] around a disturbed moment
constexpr double kCarried = 0.3;                               // [m] between two places: the robot was carried
constexpr std::size_t kScatterSamples = 20'000;

/// Returns the scatter of values about lines through their neighbours, one standard deviation.
double line_scatter_of(std::vector<double> second_differences) {
  if (second_differences.empty()) return 0;
  for (double& difference : second_differences) difference = std::abs(difference);
  return kOfMedian * lab::median_of(std::move(second_differences)) / std::sqrt(6.);
}

/// A part of a path between two times.
struct DriveSpan {
  double from = 0, to = 0;  // [s]
};

/// Looks at a path for the times in which a drive is possible.
class DriveSpans {
 public:
  DriveSpans(const std::vector<TimedCommand>& commands, const lab::Path& path, const DriveLimits& limits)
      : commands_(commands), path_(path), limits_(limits) {}

  std::vector<DriveSpan> find(double& disturbed) {
    for (std::size_t i = 1; i < path_.size(); ++i) {
      const lab::PlaceAt &before = path_[i - 1], &place = path_[i];
      const double step = place.at - before.at;
      const bool joined = step <= lab::SmoothCurve::kLongestGap && std::isfinite(before.heading) &&
                          std::isfinite(place.heading) && std::hypot(place.x - before.x, place.y - before.y) < kCarried;
      if (joined && !is_commanded(place.at)) {
        end();
      } else if (!joined || is_disturbed(place)) {
        if (joined) disturbed += step;
        end();
      } else {
        if (!open_) open_ = DriveSpan{before.at, place.at};
        open_->to = place.at;
      }
    }
    end();
    return std::move(spans_);
  }

 private:
  void end() {
    if (open_ && open_->to - open_->from >= kSettlingTime + kShortestDrive) spans_.push_back(*open_);
    open_.reset();
  }

  /// Reports whether a usable command is in force, and walking is not too far.
  bool is_commanded(double at) {
    while (next_ < commands_.size() && commands_[next_].at <= at) {
      if (asks_to_walk(commands_[next_].command)) walked_ = commands_[next_].at;
      ++next_;
    }
    if (next_ == 0 || !commands_[next_ - 1].usable || at - commands_[next_ - 1].at > kCommandHeld) return false;
    while (ahead_ < commands_.size() && (commands_[ahead_].at < at || !asks_to_walk(commands_[ahead_].command)))
      ++ahead_;
    const bool soon = ahead_ < commands_.size() && commands_[ahead_].at < at + kIdleKept;
    return soon || at - walked_ < kIdleKept;
  }

  bool is_disturbed(const lab::PlaceAt& place) {
    if (place.fallen.value_or(false)) return true;
    while (moment_ < limits_.disturbed.size() && limits_.disturbed[moment_] < place.at - kAfterDisturbed) ++moment_;
    return moment_ < limits_.disturbed.size() && limits_.disturbed[moment_] <= place.at + kBeforeDisturbed;
  }

  const std::vector<TimedCommand>& commands_;
  const lab::Path& path_;
  const DriveLimits& limits_;
  std::size_t next_ = 0, ahead_ = 0, moment_ = 0;
  double walked_ = -INFINITY;  // [s] last command to walk
  std::optional<DriveSpan> open_;
  std::vector<DriveSpan> spans_;
};

/// Returns the drive of a span, of which the first `settling` seconds are not settled. Its ticks begin with a command.
std::optional<Drive> drive_in(const std::vector<TimedCommand>& commands, const lab::Path& path, const DriveSpan& span,
                              double settling) {
  auto command = std::ranges::lower_bound(commands, span.from, {}, &TimedCommand::at);
  if (command == commands.end() || command->at >= span.to) return std::nullopt;
  Drive drive{.at = command->at, .settled = static_cast<std::size_t>(std::lround(settling / kDriveTick))};
  // half a tick of tolerance: a command counts from the nearest tick on
  for (double at = drive.at; at < span.to - kDriveTick; at += kDriveTick) {
    while (command + 1 != commands.end() && (command + 1)->at <= at + kDriveTick / 2) ++command;
    drive.commands.push_back(command->command);
  }
  auto place = std::ranges::lower_bound(path, drive.at, {}, &lab::PlaceAt::at);
  const double ticks = static_cast<double>(drive.commands.size());
  for (; place != path.end() && place->at <= span.to; ++place) {
    DrivePose pose{
        .tick = (place->at - drive.at) / kDriveTick, .x = place->x, .y = place->y, .heading = place->heading};
    if (pose.tick > ticks) break;
    if (!drive.poses.empty()) {
      const double before = drive.poses.back().heading;
      pose.heading = before + wrapped(pose.heading - before);
    }
    drive.poses.push_back(pose);
  }
  if (drive.poses.size() < 4) return std::nullopt;
  return drive;
}

}  // namespace

void cut_drives(const std::vector<TimedCommand>& commands, const lab::Path& path, const DriveLimits& limits,
                Drives& drives) {
  for (const DriveSpan& span : DriveSpans(commands, path, limits).find(drives.disturbed)) {
    // pieces of equal length: the first seconds of each are also the last ones of the piece before
    const double length = span.to - span.from - kSettlingTime;
    const double pieces = std::ceil(length / kLongestDrive);
    for (double i = 0; i < pieces; ++i) {
      const double from = span.from + i * length / pieces, to = from + kSettlingTime + length / pieces;
      auto drive = drive_in(commands, path, {from, std::min(to, span.to)}, kSettlingTime);
      if (!drive) continue;
      drive->robot = drives.robots.size() - 1;
      drives.drives.push_back(std::move(*drive));
    }
  }
}

void measure_scatter(const std::vector<const lab::Path*>& paths, Drives& drives) {
  std::size_t all = 0;
  for (const lab::Path* path : paths) all += path->size();
  const std::size_t every = all / kScatterSamples + 1;
  std::vector<double> places, headings;
  for (const lab::Path* path : paths)
    for (std::size_t i = 1; i + 1 < path->size(); i += every) {
      const lab::PlaceAt &a = (*path)[i - 1], &b = (*path)[i], &c = (*path)[i + 1];
      const double first = b.at - a.at, second = c.at - b.at;
      if (second > lab::SmoothCurve::kLongestGap || std::abs(first - second) > 0.2 * first) continue;
      places.push_back(a.x - 2 * b.x + c.x);
      places.push_back(a.y - 2 * b.y + c.y);
      const double turn = wrapped(c.heading - b.heading) - wrapped(b.heading - a.heading);
      if (std::isfinite(turn)) headings.push_back(turn);
    }
  drives.place_deviation = std::max(0.0005, line_scatter_of(std::move(places)));
  drives.heading_deviation = std::max(0.0005, line_scatter_of(std::move(headings)));
}

}  // namespace robot::fit
