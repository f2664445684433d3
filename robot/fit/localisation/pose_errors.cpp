#include "robot/fit/localisation/pose_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "robot/fit/math/angles.h"
#include "robot/fit/math/resampling.h"

namespace robot::fit {
namespace {

constexpr double kSuperbPlace = 0.1, kSuperbTurn = 10 * std::numbers::pi / 180;  // as sim/perception/localisation.cpp
constexpr double kPoseGap = 1;                                                   // [s] between two poses
constexpr double kFirstPose = 0.5;                                               // [s] after an event
constexpr double kNearFall = 0.3;      // [s] from a pose to the begin or end of a fall
constexpr double kLongestFall = 30;    // [s]
constexpr double kTurnedRound = 0.8;   // [rad] from half a circle; likewise from 0: it is back
constexpr double kShortestFlip = 0.3;  // [s]
constexpr double kShortestSide = 120;  // [s] of play in one direction
constexpr double kStandingLag = 0.5;   // [s] between two places of a robot that stands
constexpr double kWalksFrom = 0.02;    // [m/s]
constexpr double kFarOff = 1;          // [m] farther off is not worse

/// The directions of play of one robot.
class Sides {
 public:
  explicit Sides(const WatchedMotion& motion) : motion_(motion) {
    for (const GameAt& game : motion.games) known_ = known_ || game.attacks_plus;
    if (!known_) guess();
  }

  bool are_known() const { return known_; }

  /// Returns 1 if the robot attacks +x at a moment, else -1. Moments come in the order of their times.
  double at(double seconds) {
    if (!known_) return seconds < change_ ? first_ : second_;
    const GameAt* game = latest(motion_.games, seconds, index_);
    if (game && game->attacks_plus) sign_ = *game->attacks_plus ? 1 : -1;
    if (sign_ == 0)
      for (const GameAt& one : motion_.games)
        if (one.attacks_plus) return *one.attacks_plus ? 1 : -1;
    return sign_;
  }

 private:
  /// Finds the sides with which the poses fit best.
  void guess() {
    TruthReader truth(motion_.truth);
    double sum = 0, least = 0, most = 0, least_at = 0, most_at = 0;
    for (const PoseAt& pose : motion_.poses) {
      const auto there = truth.at(pose.at);
      if (!there) continue;
      sum += std::min(kFarOff, std::hypot(pose.x - there->x, pose.y - there->y)) -
             std::min(kFarOff, std::hypot(pose.x + there->x, pose.y + there->y));
      if (sum < least) least = sum, least_at = pose.at;
      if (sum > most) most = sum, most_at = pose.at;
    }
    // the gain beside the better one of two constants
    const double down = std::min(0., sum) - least, up = std::min(sum, 0.) + most - sum;
    const double begin = motion_.poses.empty() ? 0 : motion_.poses.front().at;
    const double end = motion_.poses.empty() ? 0 : motion_.poses.back().at;
    const double change = down > up ? least_at : most_at;
    first_ = second_ = sum <= 0 ? 1 : -1;
    change_ = begin;
    const double poses = static_cast<double>(motion_.poses.size()) / std::max(1., end - begin);
    const double gain = std::max(down, up) / std::max(1., poses);  // [m s]
    if (gain < kShortestSide / 4 || change - begin < kShortestSide || end - change < kShortestSide) return;
    first_ = down > up ? 1 : -1;
    second_ = -first_;
    change_ = change;
  }

  const WatchedMotion& motion_;
  bool known_ = false;
  std::size_t index_ = 0;
  double sign_ = 0;
  double first_ = 1, second_ = 1, change_ = 0;
};

/// A fall, from the last moment upright to the first one.
struct FallTimes {
  double begin = 0, end = 0;  // [s]
  double falls = 1;
};

std::vector<FallTimes> falls_by_status(const std::vector<StatusAt>& status) {
  std::vector<FallTimes> falls;
  StatusAt::Body before = StatusAt::Body::upright;
  double upright = -INFINITY;
  for (const StatusAt& now : status) {
    const bool fell = now.body == StatusAt::Body::fallen && before != StatusAt::Body::fallen;
    if (fell && before == StatusAt::Body::upright)
      falls.push_back({.begin = upright, .end = INFINITY});
    else if (fell && !falls.empty())
      falls.back().falls += 1;
    if (now.body == StatusAt::Body::upright) {
      if (before != StatusAt::Body::upright && !falls.empty()) falls.back().end = now.at;
      upright = now.at;
    }
    before = now.body;
  }
  return falls;
}

std::vector<FallTimes> falls_by_truth(const std::vector<TrueMoment>& truth) {
  std::vector<FallTimes> falls;
  bool before = false;
  double upright = -INFINITY;
  for (const TrueMoment& now : truth) {
    if (now.fallen && !before) falls.push_back({.begin = upright, .end = INFINITY});
    if (!now.fallen && before && !falls.empty()) falls.back().end = now.at;
    if (!now.fallen) upright = now.at;
    before = now.fallen;
  }
  return falls;
}

/// Returns the moments at which the robot enters the field.
std::vector<double> entrances_of(const WatchedMotion& motion) {
  std::vector<double> entrances;
  const std::vector<GameAt>& games = motion.games;
  if (games.empty() || motion.poses.empty()) return entrances;
  if (!games.front().plays && !games.front().penalised) entrances.push_back(motion.poses.front().at);
  for (std::size_t i = 1; i < games.size(); ++i) {
    const bool returns = games[i - 1].penalised && !games[i].penalised;
    const bool half = games[i].half > games[i - 1].half && games[i - 1].half > 0;
    if (returns || half) entrances.push_back(games[i].at);
  }
  return entrances;
}

/// Collects the errors of one robot.
class ErrorReader {
 public:
  ErrorReader(const WatchedMotion& motion, Sides& sides) : motion_(motion), sides_(sides), truth_(motion.truth) {}

  std::vector<PoseError> read() {
    std::vector<PoseError> errors;
    for (const PoseAt& pose : motion_.poses)
      if (const auto there = truth_.at(pose.at)) errors.push_back(error_of(pose, *there));
    return errors;
  }

 private:
  PoseError error_of(const PoseAt& pose, const TrueMoment& truth) {
    const double sign = sides_.at(pose.at), x = sign * truth.x, y = sign * truth.y;
    const double heading = truth.heading + (sign > 0 ? 0 : std::numbers::pi);
    const StatusAt* status = latest(motion_.status, pose.at, status_);
    return {.at = pose.at,
            .x = pose.x - x,
            .y = pose.y - y,
            .heading = wrapped(pose.heading - heading),
            .true_x = x,
            .true_y = y,
            .deviation = pose.deviation,
            .deviation_heading = pose.deviation_heading,
            .noise = truth.noise,
            .upright = !truth.fallen && (!status || status->body == StatusAt::Body::upright),
            .walks = status && status->speed > kWalksFrom,
            .sign = sign};
  }

  const WatchedMotion& motion_;
  Sides& sides_;
  TruthReader truth_;
  std::size_t status_ = 0;
};

/// Returns the error as it is beside the flipped truth.
PoseError turned_round(PoseError error) {
  error.x += 2 * error.true_x;
  error.y += 2 * error.true_y;
  error.heading = wrapped(error.heading + std::numbers::pi);
  return error;
}

/// Finds the flips in the errors of a robot, in the order of their times.
class FlipFinder {
 public:
  FlipFinder(std::size_t recording, PoseErrors& all) : recording_(recording), all_(all) {}

  /// Turns the error round if the pose is flipped. `is_new`: the robot entered the field, or there was a gap.
  void see(PoseError& error, bool is_new) {
    if (is_new) end(false, last_);
    if (is_new || !was_seen_) flipped_ = false;
    const PoseError round = turned_round(error);
    const bool looks_flipped = std::abs(round.heading) < kTurnedRound && round.far() < error.far() + kTurnedRound;
    const bool looks_right = std::abs(error.heading) < kTurnedRound;
    if (looks_flipped && !flipped_) {
      flip_ = {.recording = recording_, .at = error.at, .seen_begin = was_seen_ && !is_new};
      flipped_ = true;
    } else if (looks_right && flipped_) {
      end(true, error.at);
    }
    if (flipped_) error = round, error.flipped = true;
    last_ = error.at;
    was_seen_ = true;
  }

  void finish() { end(false, last_); }

 private:
  void end(bool seen, double at) {
    if (!std::exchange(flipped_, false)) return;
    flip_.duration = at - flip_.at;
    flip_.seen_end = seen;
    if (flip_.duration >= kShortestFlip) all_.flips.push_back(flip_);
  }

  const std::size_t recording_;
  PoseErrors& all_;
  PoseFlip flip_;
  bool flipped_ = false, was_seen_ = false;
  double last_ = 0;
};

/// Returns the last error at or before a moment, or null.
const PoseError* last_before(const std::vector<PoseError>& errors, double at) {
  const auto after = std::ranges::upper_bound(errors, at, {}, &PoseError::at);
  return after == errors.begin() ? nullptr : &*(after - 1);
}

/// Adds the shifts by falls.
class FallJudge {
 public:
  FallJudge(const std::vector<PoseError>& errors, const TruthNoise& noise, std::size_t recording, PoseErrors& all)
      : errors_(errors), noise_(noise), recording_(recording), all_(all) {}

  void judge(const FallTimes& fall) {
    constexpr double kTiny = 1e-3;  // [s]
    const PoseError* before = last_before(errors_, fall.begin + kTiny);
    const PoseError* after = last_before(errors_, fall.end - kTiny);
    const bool good = before && after && fall.end - fall.begin < kLongestFall && fall.begin - before->at < kNearFall &&
                      fall.end - after->at < kNearFall && after->at > fall.begin + kTiny &&
                      before->flipped == after->flipped;
    if (!good) return void(++all_.falls_left_out);
    const double noise = before->noise + after->noise;
    all_.falls.push_back({.recording = recording_,
                          .at = fall.begin,
                          .x = after->x - before->x,
                          .y = after->y - before->y,
                          .heading = wrapped(after->heading - before->heading),
                          .events = fall.falls,
                          .place_noise = noise * noise_.place * noise_.place,
                          .heading_noise = noise * noise_.heading * noise_.heading});
  }

 private:
  const std::vector<PoseError>& errors_;
  const TruthNoise noise_;
  const std::size_t recording_;
  PoseErrors& all_;
};

void add_starts(const std::vector<double>& entrances, const std::vector<PoseError>& errors, const TruthNoise& noise,
                std::size_t recording, PoseErrors& all) {
  for (const double at : entrances) {
    const auto first = std::ranges::lower_bound(errors, at, {}, &PoseError::at);
    if (first == errors.end() || first->at > at + kFirstPose) continue;
    all.starts.push_back({.recording = recording,
                          .at = first->at,
                          .x = first->x,
                          .y = first->y,
                          .heading = first->heading,
                          .place_noise = first->noise * noise.place * noise.place,
                          .heading_noise = first->noise * noise.heading * noise.heading});
  }
}

/// Fills `since`, `entered` and `fell` of each error.
void add_ages(const std::vector<double>& entrances, const std::vector<FallTimes>& falls,
              std::vector<PoseError>& errors) {
  constexpr double kTiny = 1e-3;  // [s] a robot is upright at the begin of its fall
  struct Event {
    double at;
    bool PoseError::*kind;
  };
  std::vector<Event> events;
  for (const double at : entrances) events.push_back({.at = at, .kind = &PoseError::entered});
  for (const FallTimes& fall : falls) events.push_back({.at = fall.begin + kTiny, .kind = &PoseError::fell});
  std::ranges::sort(events, {}, &Event::at);
  std::size_t next = 0;
  double last = errors.empty() ? 0 : errors.front().at;
  for (PoseError& error : errors) {
    for (; next < events.size() && events[next].at <= error.at; ++next) {
      last = events[next].at;
      error.*events[next].kind = true;
    }
    error.since = error.at - last;
  }
}

void add_flips(const std::vector<double>& entrances, std::vector<PoseError>& errors, std::size_t recording,
               PoseErrors& all) {
  FlipFinder finder(recording, all);
  std::size_t next = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double pause = i == 0 ? INFINITY : errors[i].at - errors[i - 1].at;
    bool is_new = pause > kPoseGap;
    while (next < entrances.size() && entrances[next] <= errors[i].at) is_new = true, ++next;
    finder.see(errors[i], is_new);
    if (pause > kPoseGap) continue;
    all.watched_seconds += pause;
    if (errors[i].upright && !errors[i].flipped && errors[i].is_unsure()) all.unsure_seconds += pause;
  }
  finder.finish();
}

}  // namespace

bool PoseError::is_unsure() const {
  if (std::isnan(deviation) && std::isnan(deviation_heading)) return true;
  return deviation > kSuperbPlace || deviation_heading > kSuperbTurn;
}

TruthNoise truth_noise(const WatchedMotion& motion) {
  std::vector<double> places, headings;
  std::size_t status = 0, later = 0;
  double still_since = INFINITY;  // [s]
  for (const TrueMoment& moment : motion.truth) {
    const StatusAt* now = latest(motion.status, moment.at, status);
    const bool still = now && now->body == StatusAt::Body::upright && now->speed == 0 && now->turn_rate == 0;
    if (!still)
      still_since = INFINITY;
    else
      still_since = std::min(still_since, moment.at);
    while (later < motion.truth.size() && motion.truth[later].at < moment.at - kStandingLag) ++later;
    const TrueMoment& before = motion.truth[later];
    if (!still || before.at < still_since + kStandingLag || before.at > moment.at - kStandingLag / 2) continue;
    places.push_back(std::abs(moment.x - before.x));
    places.push_back(std::abs(moment.y - before.y));
    headings.push_back(std::abs(wrapped(moment.heading - before.heading)));
  }
  if (headings.empty()) return {};
  const double share = kOfMedian / std::sqrt(2.);
  return {.place = share * lab::median_of(std::move(places)), .heading = share * lab::median_of(std::move(headings))};
}

void add_pose_errors(const WatchedMotion& motion, PoseErrors& all) {
  const std::size_t recording = all.recordings.size();
  Sides sides(motion);
  std::vector<PoseError> errors = ErrorReader(motion, sides).read();
  all.damaged += motion.damaged;
  if (errors.empty()) return;
  all.recordings.push_back(motion.name);
  all.without_sides += sides.are_known() ? 0 : 1;

  // the truth is at least as bad as it scatters
  TruthNoise noise = truth_noise(motion);
  if (noise.place == 0) noise.place = motion.place_deviation;
  all.place_noise = std::max(all.place_noise, noise.place);
  all.heading_noise = std::max(all.heading_noise, noise.heading);

  const std::vector<double> entrances = entrances_of(motion);
  const auto falls = motion.status.empty() ? falls_by_truth(motion.truth) : falls_by_status(motion.status);
  add_ages(entrances, falls, errors);
  add_flips(entrances, errors, recording, all);
  add_starts(entrances, errors, noise, recording, all);
  FallJudge judge(errors, noise, recording, all);
  for (const FallTimes& fall : falls) judge.judge(fall);
  all.noises.push_back(noise);
  all.errors.push_back(std::move(errors));
}

}  // namespace robot::fit
