#include "robot/lab/clocks/start_gesture.h"

#include <algorithm>
#include <cmath>

namespace robot::lab {
namespace {

constexpr double kShortest = 0.3, kLongest = 4;  // [s] of an absence, and of the ball's return
constexpr double kCalm = 1;                      // [s] with the ball before and after the gesture
constexpr double kSilence = 0.5;                 // [s] without a message: nothing is known
constexpr double kSameRhythm = 0.15;             // [s] between matching moments

/// A stretch of time with the ball, or without it.
struct Stretch {
  double first = 0, last = 0;  // [s]
  bool seen = false;

  double length() const { return last - first; }
  bool lasts() const { return length() >= kShortest && length() <= kLongest; }
};

/// Returns the stretches of a recording without silence. They change half-way between two images.
std::vector<Stretch> stretches_of(const std::vector<Sighting>& sightings) {
  std::vector<Stretch> stretches;
  double before = 0;
  for (const Sighting& sighting : sightings) {
    if (stretches.empty() || stretches.back().seen != sighting.seen) {
      const double from = stretches.empty() ? sighting.at : (before + sighting.at) / 2;
      if (!stretches.empty()) stretches.back().last = from;
      stretches.push_back({.first = from, .last = from, .seen = sighting.seen});
    }
    stretches.back().last = before = sighting.at;
  }
  return stretches;
}

/// Joins the stretches with the ball over the missed images between them.
std::vector<Stretch> without_misses(const std::vector<Stretch>& stretches) {
  std::vector<Stretch> joined;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const bool missed = !stretches[i].seen && stretches[i].length() < kShortest && i > 0 && i + 1 < stretches.size();
    if (missed || (!joined.empty() && joined.back().seen == stretches[i].seen))
      joined.back().last = stretches[i].last;
    else
      joined.push_back(stretches[i]);
  }
  return joined;
}

void add_gestures(const std::vector<Stretch>& stretches, std::vector<Gesture>& gestures) {
  for (std::size_t i = 0; i + 6 < stretches.size(); ++i) {
    const Stretch* const all = &stretches[i];
    if (!all[0].seen || all[0].length() < kCalm || all[6].length() < kCalm) continue;
    if (!std::all_of(all + 1, all + 6, [](const Stretch& stretch) { return stretch.lasts(); })) continue;
    gestures.push_back({all[1].first, all[1].last, all[3].first, all[3].last, all[5].first, all[5].last});
  }
}

/// Returns the lag between two gestures, or nothing if their rhythms differ.
std::optional<Lag> lag_between(const Gesture& truth, const Gesture& robot) {
  double sum = 0, squares = 0;
  constexpr double kMoments = 6;
  for (std::size_t i = 0; i < truth.size(); ++i) sum += (robot[i] - truth[i]) / kMoments;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double off = robot[i] - truth[i] - sum;
    if (std::abs(off) > kSameRhythm) return std::nullopt;
    squares += off * off;
  }
  // six moments: the quantile of Student's t is 1.3 times that of a normal distribution
  constexpr double kFewMoments = 1.3, kLeast = 0.01;  // [s] images of 30 Hz
  return Lag{.seconds = sum,
             .deviation = std::max(kLeast, kFewMoments * std::sqrt(squares / (kMoments - 1) / kMoments))};
}

}  // namespace

std::vector<Gesture> gestures_in(std::vector<Sighting> sightings) {
  std::erase_if(sightings, [](const Sighting& sighting) { return !std::isfinite(sighting.at); });
  std::ranges::stable_sort(sightings, {}, &Sighting::at);
  std::vector<Gesture> gestures;
  for (auto begin = sightings.begin(); begin != sightings.end();) {
    auto end = begin + 1;
    while (end != sightings.end() && end->at - (end - 1)->at <= kSilence) ++end;
    add_gestures(without_misses(stretches_of({begin, end})), gestures);
    begin = end;
  }
  return gestures;
}

std::optional<Lag> gesture_lag(const std::vector<Gesture>& truth, const std::vector<Gesture>& robot,
                               const LagRange& range) {
  std::optional<Lag> best;
  std::vector<double> found;
  for (const Gesture& one : truth)
    for (const Gesture& other : robot) {
      const auto lag = lag_between(one, other);
      if (!lag || std::abs(lag->seconds - range.middle) > range.reach) continue;
      found.push_back(lag->seconds);
      if (!best || lag->deviation < best->deviation) best = lag;
    }
  const bool agree = std::ranges::all_of(found, [&](double lag) { return std::abs(lag - best->seconds) <= kSilence; });
  return agree ? best : std::nullopt;
}

}  // namespace robot::lab
