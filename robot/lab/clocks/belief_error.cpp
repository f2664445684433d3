#include "robot/lab/clocks/belief_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "robot/lab/clocks/true_motion.h"

namespace robot::lab {
namespace {

constexpr std::array kEdges{0.0, 0.5, 1.0, 2.0, 3.0, 4.0, static_cast<double>(INFINITY)};  // [m]
constexpr std::size_t kBins = kEdges.size() - 1;

/// The errors [m] of one bin.
struct Errors {
  std::vector<double> place, distance;

  BeliefErrorBin bin(double from, double to) const {
    return {.from = from, .to = to, .place = figures_of(place), .distance = figures_of(distance)};
  }
};

/// Returns the error of the ball on the field [m].
double place_error(const BallBelief& ball, const PoseBelief& pose, const PlaceAt& truth) {
  const double c = std::cos(pose.heading), s = std::sin(pose.heading);
  return std::hypot(pose.x + c * ball.x - s * ball.y - truth.x, pose.y + s * ball.x + c * ball.y - truth.y);
}

std::size_t bin_of(double distance) {
  return static_cast<std::size_t>(std::ranges::upper_bound(kEdges, distance) - kEdges.begin()) - 1;
}

void join(Errors& all, const Errors& bin) {
  all.place.insert(all.place.end(), bin.place.begin(), bin.place.end());
  all.distance.insert(all.distance.end(), bin.distance.begin(), bin.distance.end());
}

std::string line_of(const std::string& name, const BeliefErrorBin& bin) {
  const auto figures = [](const ErrorFigures& errors) {
    return formatted("%8zu %7.3f %7.3f %7.3f", errors.samples, errors.mean, errors.median, errors.p95);
  };
  return formatted("%-12s %s   %s\n", name.c_str(), figures(bin.place).c_str(), figures(bin.distance).c_str());
}

std::string name_of(const BeliefErrorBin& bin) {
  return std::isfinite(bin.to) ? formatted("%.1f-%.1f m", bin.from, bin.to) : formatted("> %.1f m", bin.from);
}

nlohmann::json json_of(const ErrorFigures& errors) {
  return {{"samples", errors.samples}, {"mean", errors.mean}, {"median", errors.median}, {"p95", errors.p95}};
}

nlohmann::json json_of(const BeliefErrorBin& bin) {
  nlohmann::json json{{"from", bin.from}, {"place", json_of(bin.place)}, {"distance", json_of(bin.distance)}};
  if (std::isfinite(bin.to)) json["to"] = bin.to;
  return json;
}

}  // namespace

ErrorFigures figures_of(std::vector<double> errors) {
  if (errors.empty()) return {};
  std::ranges::sort(errors);
  const std::size_t last = errors.size() - 1;
  double sum = 0;
  for (const double error : errors) sum += error;
  return {.samples = errors.size(),
          .mean = sum / static_cast<double>(errors.size()),
          .median = (errors[last / 2] + errors[errors.size() / 2]) / 2,
          .p95 = errors[last * 95 / 100]};
}

BeliefErrors belief_errors(const TruthRecord& truth, const OwnPath& own, const RobotRecord& robot,
                           const DataOffset& clock) {
  const TrueMotion motion(truth, own.path);
  BeliefErrors found;
  std::array<Errors, kBins> bins;
  for (const BallBelief& ball : robot.balls) {
    const auto moment = motion.at(ball.at - clock.at(ball.at));
    if (!moment) {
      ++found.without_truth;
      continue;
    }
    if (moment->speed * clock.deviation_at(ball.at) > truth.ball_deviation) {
      ++found.too_fast;
      continue;
    }
    Errors& errors = bins[bin_of(moment->distance)];
    errors.distance.push_back(std::abs(std::hypot(ball.x, ball.y) - moment->distance));
    if (const PoseBelief* pose = pose_at(own.poses.poses, ball.at))
      errors.place.push_back(place_error(ball, *pose, moment->ball));
  }
  Errors all;
  for (std::size_t i = 0; i < kBins; ++i) {
    if (bins[i].distance.empty()) continue;
    join(all, bins[i]);
    found.bins.push_back(bins[i].bin(kEdges[i], kEdges[i + 1]));
  }
  found.all = all.bin(0, INFINITY);
  return found;
}

std::string to_text(const BeliefErrors& errors) {
  std::string text = formatted("%-12s %32s   %32s\n%-12s %8s %7s %7s %7s   %8s %7s %7s %7s\n", "",
                               "place on the field [m]", "distance from the robot [m]", "true dist.", "images", "mean",
                               "median", "p95", "images", "mean", "median", "p95");
  for (const BeliefErrorBin& bin : errors.bins) text += line_of(name_of(bin), bin);
  text += line_of("all", errors.all);
  text +=
      formatted("left out: %zu images without a truth, %zu in which the ball was too fast for the error of the clock\n",
                errors.without_truth, errors.too_fast);
  return text;
}

nlohmann::json to_json(const BeliefErrors& errors) {
  nlohmann::json bins = nlohmann::json::array();
  for (const BeliefErrorBin& bin : errors.bins) bins.push_back(json_of(bin));
  return {{"all", json_of(errors.all)},
          {"bins", std::move(bins)},
          {"too_fast", errors.too_fast},
          {"without_truth", errors.without_truth}};
}

}  // namespace robot::lab
