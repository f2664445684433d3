#include "robot/fit/localisation/pose_pictures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace robot::fit {
namespace {

constexpr double kLongestAge = 40, kAgeStep = 1;  // [s]
constexpr std::size_t kFewestOfBin = 60;          // poses, two seconds

/// Returns the value below which a share of the values lies; there is one.
double quantile_of(std::vector<double>& values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + at);
  return values[static_cast<std::size_t>(at)];
}

Mark line_of(Mark::Role role, const std::string& label) {
  return {.shape = Mark::Shape::line, .role = role, .label = label, .x = {}, .y = {}, .high = {}};
}

void add_age_picture(const PoseErrors& poses, Report& report) {
  std::vector<std::vector<double>> bins(static_cast<std::size_t>(kLongestAge / kAgeStep));
  for (const auto& errors : poses.errors)
    for (const PoseError& error : errors)
      if (error.upright && !error.flipped && error.since < kLongestAge)
        bins[static_cast<std::size_t>(error.since / kAgeStep)].push_back(error.far());
  Mark band = line_of(Mark::Role::robot, "from a tenth to nine tenths of them");
  band.shape = Mark::Shape::band;
  Mark middle = line_of(Mark::Role::robot, "median");
  double most = 0.1;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i].size() < kFewestOfBin) continue;
    const double at = (static_cast<double>(i) + 0.5) * kAgeStep;
    band.x.push_back(at), middle.x.push_back(at);
    band.y.push_back(quantile_of(bins[i], 0.1));
    middle.y.push_back(quantile_of(bins[i], 0.5));
    band.high.push_back(quantile_of(bins[i], 0.9));
    most = std::max(most, band.high.back());
  }
  if (middle.x.empty()) return;
  report.pictures.push_back({.title = "Error of the believed place after a fall or an entrance",
                             .x_label = "time since [s]",
                             .y_label = "error [m]",
                             .axes = {.left = 0, .right = kLongestAge, .bottom = 0, .top = 1.1 * most},
                             .marks = {std::move(band), std::move(middle)}});
}

Mark circle_of(Mark::Role role, const std::string& label, double radius) {
  Mark circle = line_of(role, label);
  for (int i = 0; i <= 72; ++i) {
    const double angle = 2 * std::numbers::pi * i / 72;
    circle.x.push_back(radius * std::cos(angle));
    circle.y.push_back(radius * std::sin(angle));
  }
  return circle;
}

double value_of(const Report& report, const std::string& name) {
  const Figure* const figure = report.figure(name);
  return figure ? figure->value : NAN;
}

void add_shift_picture(const std::string& title, const std::vector<PoseShift>& shifts, double fitted, double before,
                       Report& report) {
  if (shifts.empty()) return;
  Mark dots{.label = "one of them", .x = {}, .y = {}, .high = {}};
  double most = 2 * before;
  for (const PoseShift& shift : shifts) {
    dots.x.push_back(shift.x);
    dots.y.push_back(shift.y);
    most = std::max({most, std::abs(shift.x), std::abs(shift.y)});
  }
  Picture picture{.title = title,
                  .x_label = "along the field [m]",
                  .y_label = "across it [m]",
                  .axes = {.left = -1.1 * most, .right = 1.1 * most, .bottom = -1.1 * most, .top = 1.1 * most},
                  .marks = {std::move(dots)}};
  picture.marks.push_back(circle_of(Mark::Role::other, "one deviation of the models so far", before));
  if (std::isfinite(fitted)) picture.marks.push_back(circle_of(Mark::Role::fitted, "one deviation, fitted", fitted));
  report.pictures.push_back(std::move(picture));
}

/// The errors of each axis by the deviation that was reported.
void add_honesty_picture(const PoseErrors& poses, Report& report) {
  constexpr double kBin = 0.02, kMost = 1;  // [m]
  std::vector<double> squares(static_cast<std::size_t>(std::lround(kMost / kBin))), counts(squares.size());
  for (const auto& errors : poses.errors)
    for (const PoseError& error : errors) {
      if (!error.upright || error.flipped || !(error.deviation < kMost)) continue;
      const auto bin = static_cast<std::size_t>(error.deviation / kBin);
      squares[bin] += error.far() * error.far() / 2;
      counts[bin] += 1;
    }
  Mark dots{.role = Mark::Role::robot, .label = "root mean square of each axis", .x = {}, .y = {}, .high = {}};
  double most = 0.1;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (counts[i] < static_cast<double>(kFewestOfBin)) continue;
    dots.x.push_back((static_cast<double>(i) + 0.5) * kBin);
    dots.y.push_back(std::sqrt(squares[i] / counts[i]));
    most = std::max({most, dots.x.back(), dots.y.back()});
  }
  if (dots.x.empty()) return;
  Mark honest = line_of(Mark::Role::other, "an honest robot");
  honest.x = honest.y = {0, most};
  report.pictures.push_back({.title = "Errors of the place beside the deviation that the robot reports",
                             .x_label = "reported deviation [m]",
                             .y_label = "error [m]",
                             .axes = {.left = 0, .right = 1.1 * most, .bottom = 0, .top = 1.1 * most},
                             .marks = {std::move(honest), std::move(dots)}});
}

}  // namespace

void add_pose_pictures(const PoseErrors& poses, const sim::perception::Localisation& base, Report& report) {
  add_age_picture(poses, report);
  add_shift_picture("Shift of the believed place by a fall", poses.falls,
                    value_of(report, "localisation.fall_deviation"), static_cast<double>(base.fall_deviation), report);
  add_shift_picture("Error of the believed place after an entrance", poses.starts,
                    value_of(report, "localisation.start_deviation"), static_cast<double>(base.start_deviation),
                    report);
  add_honesty_picture(poses, report);
}

}  // namespace robot::fit
