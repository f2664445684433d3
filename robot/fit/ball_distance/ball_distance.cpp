#include "robot/fit/ball_distance/ball_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/text_plot.h"

namespace robot::fit {
namespace {

constexpr std::size_t kMostImages = 4000;  // more take minutes and hardly narrow the interval
constexpr std::size_t kFewestImages = 30, kFewestPasses = 5;
constexpr double kLeastSpread = 1.5;  // the greatest distance is that many times the least
constexpr std::size_t kPassSamples = 200, kCurvePoints = 40, kParts = 5;
constexpr std::array kEdges{0.0, 0.5, 1.0, 2.0, 3.0, 4.5, 12.0};  // [m]
constexpr std::array<const char*, 3> kNames{"ball_distance.scale", "ball_distance.offset", "ball_distance.height"};
constexpr std::array<const char*, 3> kUnits{"m px", "px", "m"};

Result<void> check(const BallSizes& seen, const std::vector<Group>& passes) {
  if (seen.sizes.empty())
    return Error{
        formatted("no image shows a ball whose true distance is known (%zu without truth, %zu cut by the border, "
                  "%zu damaged)",
                  seen.without_truth, seen.cut, seen.damaged)};
  if (seen.sizes.size() < kFewestImages || passes.size() < kFewestPasses)
    return Error{formatted("expected at least %zu images with a ball in %zu passes, got %zu in %zu", kFewestImages,
                           kFewestPasses, seen.sizes.size(), passes.size())};
  const auto [nearest, farthest] = std::ranges::minmax_element(seen.sizes, {}, &BallSize::distance);
  if (farthest->distance < kLeastSpread * nearest->distance)
    return Error{formatted("all balls are %.2f to %.2f m away: expected distances that differ by a half or more",
                           nearest->distance, farthest->distance)};
  return {};
}

/// Returns the sizes with the distances of a recording that they have if its clock is off by one standard deviation.
std::vector<BallSize> shifted(std::vector<BallSize> sizes, std::size_t recording, double seconds) {
  for (BallSize& size : sizes)
    if (size.recording == recording) size.distance = std::max(0., size.distance + seconds * size.rate);
  return sizes;
}

/// The parameters of other fits, which show how uncertain a fit is.
struct OtherFits {
  std::vector<Vector> by_luck;    // of resampled passes
  std::vector<Vector> by_clocks;  // with the clock of each recording off by one standard deviation
};

OtherFits other_fits(const BallSizes& seen, const std::vector<Group>& passes) {
  OtherFits others;
  others.by_luck = resampled(passes, kPassSamples, [&](const std::vector<std::size_t>& chosen) {
    return fit_curve(CurveKind::pinhole, seen.sizes, chosen).parameters;
  });
  for (std::size_t i = 0; i < seen.recordings.size(); ++i) {
    if (seen.clock_deviation[i] <= 0) continue;
    const auto moved = shifted(seen.sizes, i, seen.clock_deviation[i]);
    others.by_clocks.push_back(fit_curve(CurveKind::pinhole, moved, all_of(moved.size())).parameters);
  }
  return others;
}

/// Returns one standard deviation of each value that `values_of` makes from the parameters of a fit.
Vector deviations(const Curve& fitted, const OtherFits& others,
                  const std::function<Vector(const Vector& parameters)>& values_of) {
  std::vector<Vector> values;
  for (const Vector& parameters : others.by_luck) values.push_back(values_of(parameters));
  Vector deviations = deviations_of(values);
  const Vector here = values_of(fitted.parameters);
  for (const Vector& parameters : others.by_clocks) {
    const Vector there = values_of(parameters);
    for (std::size_t k = 0; k < here.size(); ++k) deviations[k] = std::hypot(deviations[k], there[k] - here[k]);
  }
  return deviations;
}

HeldOut errors_between(const std::string& curve, double from, double to, const std::vector<BallSize>& sizes,
                       const std::vector<double>& distances) {
  double sum = 0;
  std::vector<double> errors;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i].distance < from || sizes[i].distance >= to) continue;
    sum += distances[i] - sizes[i].distance;
    errors.push_back(std::abs(distances[i] - sizes[i].distance));
  }
  const double bias = errors.empty() ? 0 : sum / static_cast<double>(errors.size());
  return {.curve = curve, .from = from, .to = to, .errors = lab::figures_of(std::move(errors)), .bias = bias};
}

void add_errors(const std::string& curve, const std::vector<BallSize>& sizes, const std::vector<double>& distances,
                std::vector<HeldOut>& into) {
  into.push_back(errors_between(curve, 0, kEdges.back(), sizes, distances));
  into.back().is_whole = true;
  for (std::size_t i = 0; i + 1 < kEdges.size(); ++i)
    if (const HeldOut bin = errors_between(curve, kEdges[i], kEdges[i + 1], sizes, distances); bin.errors.samples > 0)
      into.push_back(bin);
}

/// Returns the part of each image: its recording if there are several, else a fifth of all passes.
std::vector<std::size_t> parts_of(const BallSizes& seen, const std::vector<Group>& passes) {
  std::vector<std::size_t> parts(seen.sizes.size());
  const bool by_recording = seen.recordings.size() >= 2;
  for (std::size_t k = 0; k < passes.size(); ++k)
    for (const std::size_t i : passes[k])
      parts[i] = by_recording ? seen.sizes[i].recording : k * kParts / passes.size();
  return parts;
}

/// Returns the distances by curves that were fitted to the other parts.
std::vector<double> held_out_distances(CurveKind kind, const std::vector<BallSize>& sizes,
                                       const std::vector<std::size_t>& parts) {
  std::vector<double> distances(sizes.size());
  const std::size_t count = *std::ranges::max_element(parts) + 1;
  for (std::size_t part = 0; part < count; ++part) {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < sizes.size(); ++i)
      if (parts[i] != part) others.push_back(i);
    if (others.empty() || others.size() == sizes.size()) continue;
    const Curve curve = fit_curve(kind, sizes, others);
    for (std::size_t i = 0; i < sizes.size(); ++i)
      if (parts[i] == part) distances[i] = curve.distance(sizes[i].radius);
  }
  return distances;
}

void judge(const std::vector<Group>& passes, BallDistance& fit) {
  const std::vector<BallSize>& sizes = fit.seen.sizes;
  const std::vector<std::size_t> parts = parts_of(fit.seen, passes);
  fit.parts = fit.seen.recordings.size() >= 2 ? formatted("each of %zu recordings", fit.seen.recordings.size())
                                              : std::string("each fifth of the passes");
  for (const CurveKind kind : {CurveKind::pinhole, CurveKind::power_law, CurveKind::constant})
    add_errors(std::string(name_of(kind)), sizes, held_out_distances(kind, sizes, parts), fit.held_out);
  std::vector<double> believed;
  for (const BallSize& size : sizes) believed.push_back(size.believed);
  add_errors("the robot's own", sizes, believed, fit.held_out);
}

void draw_curve(const OtherFits& others, std::size_t freedom, BallDistance& fit) {
  for (std::size_t i = 0; i < kCurvePoints; ++i) {
    const double share = static_cast<double>(i) / (kCurvePoints - 1);
    fit.curve.push_back({.radius = fit.least_radius * std::pow(fit.most_radius / fit.least_radius, share)});
  }
  const auto distances = [&fit](const Vector& parameters) {
    const Curve curve{.kind = CurveKind::pinhole, .parameters = parameters, .noise = fit.pinhole.noise};
    Vector there;
    for (const CurvePoint& point : fit.curve) there.push_back(curve.distance(point.radius));
    return there;
  };
  const Vector there = distances(fit.pinhole.parameters);
  const Vector around = deviations(fit.pinhole, others, distances);
  for (std::size_t i = 0; i < fit.curve.size(); ++i) {
    const double half = two_sided(freedom) * around[i];
    fit.curve[i].distance = there[i];
    fit.curve[i].low = std::max(0., there[i] - half);
    fit.curve[i].high = there[i] + half;
  }
}

/// Formats the mean errors of one curve [cm], one column for each bin, and more of all distances.
std::string line_of(const std::vector<HeldOut>& bins) {
  const HeldOut& all = bins.front();
  std::string text = formatted("%-16s", all.curve.c_str());
  for (const HeldOut& bin : bins) text += formatted(" %10.1f", 100 * bin.errors.mean);
  return text + formatted(" %8.1f %6.1f %+6.1f\n", 100 * all.errors.median, 100 * all.errors.p95, 100 * all.bias);
}

}  // namespace

std::optional<double> BallDistance::distance(double radius) const {
  if (!(radius >= least_radius && radius <= most_radius)) return std::nullopt;
  return pinhole.distance(radius);
}

Result<BallDistance> fit_ball_distance(BallSizes seen) {
  std::vector<Group> passes = passes_of(seen.sizes);
  thin(seen, passes, kMostImages);
  if (Result<void> good = check(seen, passes); !good) return good.failure();
  BallDistance fit;
  fit.seen = std::move(seen);
  const std::vector<BallSize>& sizes = fit.seen.sizes;
  const auto [smallest, largest] = std::ranges::minmax_element(sizes, {}, &BallSize::radius);
  const auto [nearest, farthest] = std::ranges::minmax_element(sizes, {}, &BallSize::distance);
  fit.least_radius = smallest->radius, fit.most_radius = largest->radius;
  fit.pinhole = fit_curve(CurveKind::pinhole, sizes, all_of(sizes.size()));
  fit.power_law = fit_curve(CurveKind::power_law, sizes, all_of(sizes.size()));

  const OtherFits others = other_fits(fit.seen, passes);
  const auto same = [](const Vector& parameters) { return parameters; };
  const Vector around = deviations(fit.pinhole, others, same);
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const double value = fit.pinhole.parameters[i], half = two_sided(passes.size() - 1) * around[i];
    fit.figures.push_back(
        {.name = kNames[i],
         .unit = kUnits[i],
         .value = value,
         .low = value - half,
         .high = value + half,
         .events = passes.size(),
         .kind = "passes",
         .recordings = fit.seen.recordings,
         .domain = {.quantity = "true distance", .unit = "m", .from = nearest->distance, .to = farthest->distance}});
  }
  draw_curve(others, passes.size() - 1, fit);
  judge(passes, fit);
  return fit;
}

std::vector<std::vector<HeldOut>> by_curve(const std::vector<HeldOut>& held_out) {
  std::vector<std::vector<HeldOut>> curves;
  for (const HeldOut& errors : held_out) {
    if (curves.empty() || curves.back().front().curve != errors.curve) curves.emplace_back();
    curves.back().push_back(errors);
  }
  return curves;
}

std::string range_of(const HeldOut& errors) {
  return errors.is_whole ? "all" : formatted("%.1f-%.1f", errors.from, errors.to);
}

Table table_of(const BallDistance& fit) {
  Table table{.columns = {"time [s]", "radius [px of 640]", "true distance [m]", "deviation of the truth [m]",
                          "distance by vision [m]", "distance by the curve [m]"},
              .names = fit.seen.recordings,
              .rows = {}};
  for (const BallSize& size : fit.seen.sizes)
    table.rows.push_back({.recording = size.recording,
                          .values = {size.at, size.radius, size.distance, size.deviation, size.believed,
                                     fit.pinhole.distance(size.radius)}});
  return table;
}

std::string to_text(const BallDistance& fit) {
  const std::vector<BallSize>& sizes = fit.seen.sizes;
  const auto farthest = std::ranges::max_element(sizes, {}, &BallSize::distance);
  TextPlot plot({.left = 0, .right = fit.most_radius, .bottom = 0, .top = farthest->distance});
  for (const BallSize& size : sizes) {
    plot.dot('o', size.radius, size.believed);
    plot.dot('.', size.radius, size.distance);
  }
  for (const CurvePoint& point : fit.curve) plot.dot('#', point.radius, point.distance);
  std::string text = "distance of the ball [m] over its radius [px of 640]: . truth, o as vision had it, # fitted\n";
  text += plot.text();
  for (const Figure& figure : fit.figures) text += formatted("%-21s ", figure.name.c_str()) + to_text(figure) + "\n";
  text += "\nmean errors [cm] by true distance [m], on images held out: " + fit.parts + "\n" + std::string(16, ' ');
  const auto curves = by_curve(fit.held_out);
  for (const HeldOut& bin : curves.front()) text += formatted(" %10s", range_of(bin).c_str());
  text += formatted(" %8s %6s %6s\n", "median", "95 %", "bias");
  for (const std::vector<HeldOut>& bins : curves) text += line_of(bins);
  return text +
         formatted(
             "left out: %zu images without truth, %zu cut by the border, %zu damaged, %zu like others of their pass\n",
             fit.seen.without_truth, fit.seen.cut, fit.seen.damaged, fit.seen.thinned);
}

}  // namespace robot::fit
