#include "robot/fit/rolling/rolling.h"

#include <algorithm>
#include <cmath>

#include "robot/core/text.h"
#include "robot/fit/math/resampling.h"
#include "robot/fit/text_plot.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestRolls = 8, kRollSamples = 500;
constexpr double kMost = 5;  // [m/s²] no turf slows a ball more

double median_over(const std::vector<Roll>& rolls, double (*value_of)(const Roll&)) {
  std::vector<double> values;
  for (const Roll& roll : rolls) values.push_back(value_of(roll));
  return lab::median_of(std::move(values));
}

/// Returns the standard deviation between rolls that their own errors do not explain.
double spread_of(const std::vector<Roll>& rolls) {
  const double middle = median_over(rolls, [](const Roll& roll) { return roll.deceleration; });
  std::vector<double> errors, own;
  for (const Roll& roll : rolls) {
    errors.push_back(std::abs(roll.deceleration - middle));
    own.push_back(roll.deviation * roll.deviation);
  }
  const double all = kOfMedian * lab::median_of(std::move(errors));
  return std::sqrt(std::max(0., all * all - lab::median_of(std::move(own))));
}

double deceleration_of(const std::vector<Roll>& rolls, const std::vector<std::size_t>& chosen, double spread) {
  const auto residuals = [&](const Vector& p, Vector& errors) {
    errors.resize(chosen.size());
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const Roll& roll = rolls[chosen[k]];
      errors[k] = (roll.deceleration - p[0]) / std::hypot(roll.deviation, spread);
    }
  };
  const double start = median_over(rolls, [](const Roll& roll) { return roll.deceleration; });
  return minimise({.least = {0}, .most = {kMost}, .residuals = residuals, .loss = Loss::cauchy},
                  {std::clamp(start, 0., kMost)})
      .parameters[0];
}

Figure figure_of(const Rolling& fit) {
  const auto samples =
      resampled(single_groups(fit.rolls.size()), kRollSamples, [&](const std::vector<std::size_t>& chosen) -> Vector {
        return {deceleration_of(fit.rolls, chosen, fit.spread)};
      });
  const double value = deceleration_of(fit.rolls, all_of(fit.rolls.size()), fit.spread);
  const double half = two_sided(fit.rolls.size() - 1) * deviations_of(samples)[0];
  const auto slowest = std::ranges::min_element(fit.rolls, {}, &Roll::end_speed);
  const auto fastest = std::ranges::max_element(fit.rolls, {}, &Roll::speed);
  return {.name = "ball.deceleration",
          .unit = "m/s²",
          .value = value,
          .low = value - half,
          .high = value + half,
          .events = fit.rolls.size(),
          .kind = "free rolls",
          .recordings = fit.recordings,
          .domain = {.quantity = "speed", .unit = "m/s", .from = slowest->end_speed, .to = fastest->speed}};
}

}  // namespace

Result<Rolling> fit_rolling(const Evidence& evidence) {
  Rolling fit;
  double deviation = 0;
  for (const auto& game : evidence.games) {
    const std::vector<Roll> rolls = rolls_in(game->record, fit.recordings.size());
    if (rolls.empty()) continue;
    fit.rolls.insert(fit.rolls.end(), rolls.begin(), rolls.end());
    fit.recordings.push_back(game->name);
    deviation = std::max(deviation, game->record.ball_deviation);
  }
  if (fit.rolls.size() < kFewestRolls)
    return Error{
        formatted("expected at least %zu free rolls of half a second, got %zu", kFewestRolls, fit.rolls.size())};
  fit.spread = spread_of(fit.rolls);
  fit.deceleration = figure_of(fit);
  // the slope of a line through half a second at 30 images a second
  fit.kept =
      formatted("ball.stop_speed stays: with an error of %.0f mm, speeds below %.2f m/s look like a ball that lies",
                1000 * deviation, 2 * deviation * std::sqrt(12. / 15) / 0.5);
  return fit;
}

Table table_of(const Rolling& fit) {
  Table table{.columns = {"time [s]", "duration [s]", "speed [m/s]", "speed at the end [m/s]", "deceleration [m/s²]",
                          "deviation [m/s²]"},
              .names = fit.recordings,
              .rows = {}};
  for (const Roll& roll : fit.rolls)
    table.rows.push_back(
        {.recording = roll.recording,
         .values = {roll.at, roll.duration, roll.speed, roll.end_speed, roll.deceleration, roll.deviation}});
  return table;
}

std::string to_text(const Rolling& fit) {
  const Figure& figure = fit.deceleration;
  TextPlot plot({.left = 0, .right = figure.domain.to, .bottom = 0, .top = 3 * figure.value});
  for (int i = 0; i < TextPlot::kWidth; ++i) plot.dot('#', figure.domain.to * i / (TextPlot::kWidth - 1), figure.value);
  for (const Roll& roll : fit.rolls) plot.dot('.', roll.speed, roll.deceleration);
  return "deceleration of the ball [m/s²] over its speed [m/s]: . a free roll, # fitted\n" + plot.text() +
         formatted("%-21s ", figure.name.c_str()) + to_text(figure) +
         formatted("\nspread between rolls  %.3f m/s²\n", fit.spread);
}

}  // namespace robot::fit
