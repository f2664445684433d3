#include "robot/foresight/wording.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace robot::foreseeing {
namespace {

using Told = pb::Forecast::StrategyForecast;

constexpr double kNothing = 0.005;  // [unit] smaller gains are written as 0.00

/// Returns a gain such as "0.04 ± 0.09 goals", a loss without its sign.
std::string gain_of(const Told& told, pb::WhatIf::Measure measure) {
  char text[80];
  std::snprintf(text, sizeof text, "%.2f ± %.2f %s", std::abs(double{told.gain()}),
                double{told.gain_high()} - double{told.gain()},
                measure == pb::WhatIf::MEASURE_GOAL_DIFFERENCE ? "goals" : "in probability");
  return text;
}

std::string futures_of(const Told& told) { return " (" + std::to_string(told.rollouts()) + " futures)"; }

/// Whether the gain and its error would be written as zeros.
bool is_nothing(const Told& told) {
  return std::abs(double{told.gain()}) < kNothing && double{told.gain_high()} - double{told.gain()} < kNothing;
}

std::string no_difference(const std::string& from, const Told& told) {
  return "no difference from " + from + " was seen in " + std::to_string(told.rollouts()) + " futures";
}

/// Returns the reason to drop `told` for the first strategy.
std::string given_up(const Told& told, const pb::WhatIf& question) {
  const std::string gain = gain_of(told, question.measure());
  const std::string& name = told.strategy();
  if (is_nothing(told)) return no_difference(name, told);
  if (told.gain_high() < 0) return name + " would lose " + gain + futures_of(told);
  if (told.gain() <= 0) return name + " does not look better, with " + gain + " less" + futures_of(told);
  if (told.gain_low() <= 0) return name + " would gain " + gain + ", which may be chance" + futures_of(told);
  return name + " would gain " + gain + ", too little to be worth it" + futures_of(told);
}

}  // namespace

std::string reason_of(const pb::Forecast& forecast, const std::string& before, const std::string& chosen) {
  const auto told_of = [&](const std::string& name) {
    const auto found = std::ranges::find(forecast.strategies(), name, &Told::strategy);
    return found == forecast.strategies().end() ? nullptr : &*found;
  };
  const std::string& first = forecast.question().strategies(0);
  if (chosen == first) {
    if (before == first) return forecast.reason();
    const Told* const told = told_of(before);
    return "back to " + first + ": " + (told ? given_up(*told, forecast.question()) : before + " was not asked about");
  }
  const Told* const told = told_of(chosen);
  if (!told) return forecast.reason();
  const std::string what = before == chosen ? "stays with " + chosen : "changes from " + before + " to " + chosen;
  if (is_nothing(*told)) return what + ": " + no_difference(first, *told);
  const char* const way = told->gain() < 0 ? ": that loses " : ": that gains ";
  return what + way + gain_of(*told, forecast.question().measure()) + " over " + first + futures_of(*told);
}

}  // namespace robot::foreseeing
