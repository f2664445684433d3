// The pictures of the radio.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/math/resampling.h"
#include "robot/fit/radio/packet_ages.h"
#include "robot/fit/radio/radio_evidence.h"
#include "sim/statistics/sample.h"

namespace robot::fit {
namespace {

/// Returns the chance of a delay from `from` to `to` [s].
double chance_between(double mean, double from, double to) {
  const auto later = [mean](double delay) {
    return delay > kLongestDelayInMeans * mean ? 0 : std::exp(-std::max(0., delay) / mean);
  };
  return later(from) - later(to);
}

Mark chances(const char* label, Mark::Role role, double mean, double width, double from, std::size_t bins) {
  Mark mark{.shape = Mark::Shape::line, .role = role, .label = label, .x = {}, .y = {}, .high = {}};
  for (std::size_t i = 0; i < bins; ++i) {
    const double left = from + width * static_cast<double>(i);
    if (left + width <= 0) continue;
    mark.x.push_back(left + width / 2);
    mark.y.push_back(100 * chance_between(mean, left, left + width));
  }
  return mark;
}

}  // namespace

void draw_delays(const RadioEvidence& radio, double fitted, double before, Report& report) {
  const double width = radio.step > 0 ? radio.step : fitted / 4;
  constexpr std::size_t kBins = 26;
  const double from = radio.step > 0 ? -width / 2 : -4 * width;
  Mark bars{.shape = Mark::Shape::bars,
            .role = Mark::Role::truth,
            .label = "packets",
            .x = {},
            .y = {},
            .high = {},
            .width = width};
  for (std::size_t i = 0; i < kBins; ++i) bars.x.push_back(from + width * static_cast<double>(i));
  bars.y.resize(kBins);
  const double one = 100 / static_cast<double>(radio.packets.delays.size());
  for (const Delay& delay : radio.packets.delays)
    if (const double bin = std::floor((delay.seconds - from) / width); bin >= 0 && bin < kBins)
      bars.y[static_cast<std::size_t>(bin)] += one;
  double top = *std::ranges::max_element(bars.y);
  const Mark curve = chances("fitted", Mark::Role::fitted, fitted, width, from, kBins);
  const Mark other = chances("the models before", Mark::Role::other, before, width, from, kBins);
  for (const Mark* mark : {&curve, &other}) top = std::max(top, *std::ranges::max_element(mark->y));
  report.pictures.push_back({.title = "Delays of packets",
                             .x_label = "delay [s]",
                             .y_label = "packets [%]",
                             .axes = {.left = from, .right = from + width * kBins, .bottom = 0, .top = 1.1 * top},
                             .marks = {std::move(bars), other, curve}});
}

namespace {

Mark age_line(const char* label, Mark::Role role, const AgeCurve& curve) {
  Mark mark{.shape = Mark::Shape::line, .role = role, .label = label, .x = curve.ages, .y = curve.shares, .high = {}};
  for (double& share : mark.y) share *= 100;
  return mark;
}

/// Returns the age that few packets reach [s]: the right edge of the picture.
double oldest_drawn(const AgeCurve& curve) {
  for (std::size_t i = 0; i < curve.ages.size(); ++i)
    if (curve.shares[i] < 0.01) return std::max(0.5, 1.2 * curve.ages[i]);
  return curve.ages.back();
}

}  // namespace

void draw_ages(const RadioEvidence& radio, const sim::perception::Radio& before, Report& report) {
  const AgeCurve seen = observed_ages(radio.records);
  if (seen.ages.empty()) return;
  Picture picture{.title = "Age of a mate's newest packet",
                  .x_label = "age [s]",
                  .y_label = "time with an older one [%]",
                  .axes = {.left = 0, .right = oldest_drawn(seen), .bottom = 0, .top = 100},
                  .marks = {age_line("robots", Mark::Role::truth, seen)}};
  const Figure *delay = report.figure("radio.delay"), *loss = report.figure("radio.loss");
  if (const AgeCurve curve = expected_ages(radio.records, before.delay, before.loss); !curve.ages.empty())
    picture.marks.push_back(age_line("the models before", Mark::Role::other, curve));
  if (delay && loss)
    if (const AgeCurve curve = expected_ages(radio.records, delay->value, loss->value); !curve.ages.empty())
      picture.marks.push_back(age_line("fitted", Mark::Role::fitted, curve));
  report.pictures.push_back(std::move(picture));
}

}  // namespace robot::fit
