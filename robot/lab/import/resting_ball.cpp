#include "robot/lab/import/resting_ball.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "proto/foresight/motion.pb.h"
#include "proto/foresight/truth.pb.h"
#include "proto/foresight/vision.pb.h"
#include "robot/core/clock.h"
#include "robot/core/text.h"
#include "robot/fit/math/least_squares.h"
#include "robot/fit/math/resampling.h"
#include "robot/memory/memory.h"

namespace robot::lab {
namespace {

namespace pb = foresight;

constexpr double kBallHeight = 0.04;                 // [m] of the ball's middle
constexpr double kTilt = std::numbers::pi / 180;     // [rad] one standard deviation of the camera's tilt
constexpr double kWayShare = 0.1;                    // of odometry, before it is measured
constexpr double kOwnChest = 5. / 6;                 // share of the picture's rows above the robot's chest
constexpr double kFits = 3, kLeastDeviation = 0.01;  // [standard deviations], [m]
constexpr std::size_t kFewestFitting = 10, kFewestRolled = 10, kMovedAfter = 3;
constexpr double kLongWay = 0.3;     // [m] its share of error can be measured
constexpr double kFarthestBall = 6;  // [m] the camera's tilt makes farther places useless
constexpr std::uint64_t kStepNs = kSecond / 30, kRollNs = 2 * kSecond, kLongestRestNs = 3600 * kSecond;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Returns the interpolated odometry at a moment, or nothing outside it.
std::optional<OdometryAt> odometry_at(const std::vector<OdometryAt>& odometry, std::uint64_t at_ns) {
  const auto after = std::ranges::lower_bound(odometry, at_ns, {}, &OdometryAt::at_ns);
  if (after == odometry.end()) return std::nullopt;
  if (after->at_ns == at_ns) return *after;
  if (after == odometry.begin()) return std::nullopt;
  const OdometryAt& before = *(after - 1);
  const double share = static_cast<double>(at_ns - before.at_ns) / static_cast<double>(after->at_ns - before.at_ns);
  return OdometryAt{
      .at_ns = at_ns,
      .x = before.x + share * (after->x - before.x),
      .y = before.y + share * (after->y - before.y),
      .heading = before.heading + share * std::remainder(after->heading - before.heading, 2 * std::numbers::pi)};
}

/// Returns the way from the first odometry to each one [m].
std::vector<double> ways_of(const std::vector<OdometryAt>& odometry) {
  std::vector<double> ways(odometry.size());
  for (std::size_t i = 1; i < odometry.size(); ++i)
    ways[i] = ways[i - 1] + std::hypot(odometry[i].x - odometry[i - 1].x, odometry[i].y - odometry[i - 1].y);
  return ways;
}

/// A sighting in the frame of the odometry.
struct PlacedBall {
  std::uint64_t at_ns;
  double x, y;
  double deviation;  // [m] by the camera's tilt
  double distance;   // [m] by the camera
  OdometryAt robot;
  double way;  // [m] of the robot until then
};

std::vector<PlacedBall> placed(const std::vector<BallSighting>& sightings, const std::vector<OdometryAt>& odometry) {
  const std::vector<double> ways = ways_of(odometry);
  std::vector<PlacedBall> balls;
  for (const BallSighting& seen : sightings) {
    const auto robot = odometry_at(odometry, seen.at_ns);
    const double distance = std::hypot(seen.x, seen.y), height = seen.height - kBallHeight;
    if (!robot || !(distance < kFarthestBall) || !(height > 0)) continue;
    const double c = std::cos(robot->heading), s = std::sin(robot->heading);
    const auto after = std::ranges::lower_bound(odometry, seen.at_ns, {}, &OdometryAt::at_ns);
    balls.push_back({.at_ns = seen.at_ns,
                     .x = robot->x + c * seen.x - s * seen.y,
                     .y = robot->y + s * seen.x + c * seen.y,
                     .deviation = std::max(kLeastDeviation, kTilt * (height * height + distance * distance) / height),
                     .distance = distance,
                     .robot = *robot,
                     .way = ways[static_cast<std::size_t>(after - odometry.begin())]});
  }
  return balls;
}

/// Returns the place that fits all balls, of which single ones may be elsewhere.
std::array<double, 2> common_place(const std::vector<PlacedBall>& balls, const PlacedBall& nearest) {
  const auto residuals = [&](const fit::Vector& place, fit::Vector& errors) {
    errors.clear();
    for (const PlacedBall& ball : balls) {
      const double deviation = std::hypot(ball.deviation, kWayShare * std::abs(ball.way - nearest.way));
      errors.push_back((ball.x - place[0]) / deviation);
      errors.push_back((ball.y - place[1]) / deviation);
    }
  };
  const fit::LeastSquares problem{
      .least = {-INFINITY, -INFINITY}, .most = {INFINITY, INFINITY}, .residuals = residuals, .loss = fit::Loss::cauchy};
  const fit::Vector place = fit::minimise(problem, {nearest.x, nearest.y}).parameters;
  return {place[0], place[1]};
}

/// Returns the first and the last picture of the rest around `nearest`: it ends before kMovedAfter that do not fit.
std::pair<std::size_t, std::size_t> rest_around(const std::vector<bool>& fits, std::size_t nearest) {
  std::size_t first = nearest, last = nearest;
  for (std::size_t i = nearest, missed = 0; i < fits.size() && missed < kMovedAfter; ++i) {
    missed = fits[i] ? 0 : missed + 1;
    if (fits[i]) last = i;
  }
  for (std::size_t i = nearest + 1, missed = 0; i-- > 0 && missed < kMovedAfter;) {
    missed = fits[i] ? 0 : missed + 1;
    if (fits[i]) first = i;
  }
  return {first, last};
}

/// Sets how far the ball rolled after its rest, from the pictures in which it lies again.
void measure_roll(const std::vector<PlacedBall>& balls, RestingBall& rest) {
  std::vector<double> x, y;
  double heading = 0;
  for (const PlacedBall& ball : balls) {
    if (ball.at_ns <= rest.end_ns) heading = ball.robot.heading;
    if (ball.at_ns <= rest.end_ns + kRollNs) continue;
    x.push_back(ball.x), y.push_back(ball.y);
  }
  if (x.size() < kFewestRolled) return;
  const double dx = median(std::move(x)) - rest.x, dy = median(std::move(y)) - rest.y;
  rest.rolled = std::hypot(dx, dy);
  rest.direction = std::remainder(std::atan2(dy, dx) - heading, 2 * std::numbers::pi);
}

/// Returns the point [m, robot] where the ray of a pixel reaches the height of the ball's middle, or nothing above the horizon.
std::optional<std::array<double, 2>> on_plane(const pb::CameraMatrix& camera, const FoundBall& ball) {
  if (camera.rotation_size() != 9) return std::nullopt;
  const double right = (ball.x - camera.centre_x()) / camera.focal_x();
  const double down = (ball.y - camera.centre_y()) / camera.focal_y();
  std::array<double, 3> ray{};
  for (int row = 0; row < 3; ++row)
    ray[static_cast<std::size_t>(row)] =
        camera.rotation(3 * row) * right + camera.rotation(3 * row + 1) * down + camera.rotation(3 * row + 2);
  const double scale = (kBallHeight - camera.z()) / ray[2];
  if (!(scale > 0) || !std::isfinite(scale)) return std::nullopt;
  return std::array{camera.x() + scale * ray[0], camera.y() + scale * ray[1]};
}

void fill_detection(const FoundBall& ball, const pb::CameraMatrix& camera, const std::array<double, 2>& place,
                    pb::Detection& detection) {
  detection.set_camera(pb::Detection::CAMERA_BOTTOM);
  detection.set_image_x(static_cast<float>(ball.x));
  detection.set_image_y(static_cast<float>(ball.y));
  detection.set_box_left(static_cast<float>(ball.left));
  detection.set_box_top(static_cast<float>(ball.top));
  detection.set_box_width(static_cast<float>(ball.width));
  detection.set_box_height(static_cast<float>(ball.height));
  detection.set_angle_x(std::atan((static_cast<float>(ball.x) - camera.centre_x()) / camera.focal_x()));
  detection.set_angle_y(std::atan((static_cast<float>(ball.y) - camera.centre_y()) / camera.focal_y()));
  detection.set_x(static_cast<float>(place[0]));
  detection.set_y(static_cast<float>(place[1]));
  const double distance = std::hypot(place[0], place[1]);
  detection.set_distance(static_cast<float>(distance));
  detection.set_bearing(static_cast<float>(std::atan2(place[1], place[0])));
  const double ahead = std::hypot(place[0] - camera.x(), place[1] - camera.y());
  detection.set_elevation(static_cast<float>(-std::atan2(camera.z() - kBallHeight, ahead)));
}

/// The sink that looks for the ball.
class BallSink final : public ImportSink {
 public:
  explicit BallSink(ImportSink& sink) : sink_(sink) {}

  Result<void> message(std::string_view object, std::uint64_t capture_ns,
                       const google::protobuf::Message& value) override {
    if (Result<void> passed = sink_.message(object, capture_ns, value); !passed) return passed;
    if (const auto* const image = dynamic_cast<const pb::Image*>(&value); image && object == "camera_bottom")
      look(*image, capture_ns);
    if (const auto* const odometry = dynamic_cast<const pb::Odometry*>(&value))
      odometry_.push_back(
          {.at_ns = capture_ns, .x = odometry->x(), .y = odometry->y(), .heading = odometry->heading()});
    const auto* const camera = dynamic_cast<const pb::CameraMatrix*>(&value);
    if (camera && object == "camera_bottom_matrix" && seen_ns_ == capture_ns) return write_vision(*camera);
    return {};
  }

  Result<void> finish(ImportReport& report) {
    report.messages["vision"] += pictures_;
    std::ranges::stable_sort(odometry_, {}, &OdometryAt::at_ns);
    std::ranges::stable_sort(sightings_, {}, &BallSighting::at_ns);
    const Result<RestingBall> rest = find_rest(sightings_, odometry_);
    if (!rest) {
      report.warnings.push_back("no truth by odometry: " + rest.error());
      return {};
    }
    describe(*rest, report);
    return write_truth(*rest, report);
  }

 private:
  void look(const pb::Image& image, std::uint64_t capture_ns) {
    vision_.Clear();
    seen_ns_ = capture_ns;
    if (image.encoding() != pb::Image::ENCODING_YUYV || image.width() > 4096 || image.height() > 4096) return;
    const auto width = static_cast<int>(image.width()), height = static_cast<int>(image.height());
    vision_.set_image_width(image.width());
    vision_.set_image_height(image.height());
    ball_ = find_orange_ball({.width = width, .height = height, .yuyv = image.data()},
                             static_cast<int>(kOwnChest * height));
  }

  Result<void> write_vision(const pb::CameraMatrix& camera) {
    if (const auto place = ball_ ? on_plane(camera, *ball_) : std::nullopt) {
      fill_detection(*ball_, camera, *place, *vision_.mutable_ball()->mutable_detection());
      vision_.mutable_ball()->set_radius(static_cast<float>(ball_->radius));
      sightings_.push_back({.at_ns = seen_ns_, .x = (*place)[0], .y = (*place)[1], .height = camera.z()});
    }
    ball_.reset();
    ++pictures_;
    return sink_.message("vision", std::exchange(seen_ns_, 0), vision_);
  }

  void describe(const RestingBall& rest, ImportReport& report) const {
    std::string text = formatted(
        "truth by odometry, in its frame: the ball lies still in %zu pictures over %.1f s; by odometry and by the "
        "camera "
        "its distances differ by %.1f %% of the way",
        rest.pictures, static_cast<double>(rest.end_ns - rest.begin_ns) * 1e-9, 100 * rest.way_share);
    if (rest.rolled > 0)
      text += formatted("; then it rolls about %.1f m, %+.2f rad from the robot's heading, by the camera alone",
                        rest.rolled, rest.direction);
    report.about += (report.about.empty() ? "" : "; ") + text;
  }

  Result<void> write_truth(const RestingBall& rest, ImportReport& report) {
    const std::vector<double> ways = ways_of(odometry_);
    const auto way_at = [&](std::uint64_t at_ns) {
      const auto after = std::ranges::lower_bound(odometry_, at_ns, {}, &OdometryAt::at_ns);
      return after == odometry_.end() ? ways.back() : ways[static_cast<std::size_t>(after - odometry_.begin())];
    };
    for (std::uint64_t at_ns = rest.begin_ns; at_ns <= rest.end_ns; at_ns += kStepNs) {
      const auto robot = odometry_at(odometry_, at_ns);
      if (!robot) continue;
      pb::GroundTruth truth;
      const double error =
          std::hypot(rest.deviation, rest.way_share * std::abs(way_at(at_ns) - way_at(rest.nearest_ns)));
      truth.mutable_ball()->set_x(static_cast<float>(rest.x));
      truth.mutable_ball()->set_y(static_cast<float>(rest.y));
      truth.mutable_ball()->mutable_covariance()->set_xx(static_cast<float>(error * error));
      truth.mutable_ball()->mutable_covariance()->set_yy(static_cast<float>(error * error));
      pb::GroundTruth::TrueRobot& self = *truth.add_robots();
      self.set_x(static_cast<float>(robot->x));
      self.set_y(static_cast<float>(robot->y));
      self.set_heading(static_cast<float>(robot->heading));
      if (Result<void> written = sink_.message(memory::kTruthTopic, at_ns, truth); !written) return written;
      ++report.messages[std::string(memory::kTruthTopic)];
    }
    return {};
  }

  ImportSink& sink_;
  pb::Vision vision_;          // of the last picture
  std::uint64_t seen_ns_ = 0;  // its time; 0: its vision is written
  std::optional<FoundBall> ball_;
  std::uint64_t pictures_ = 0;
  std::vector<BallSighting> sightings_;
  std::vector<OdometryAt> odometry_;
};

}  // namespace

Result<RestingBall> find_rest(const std::vector<BallSighting>& sightings, const std::vector<OdometryAt>& odometry) {
  const std::vector<PlacedBall> balls = placed(sightings, odometry);
  const auto few = [](std::size_t count) {
    return Error{formatted("expected at least %zu pictures with a whole orange ball at one place, got %zu",
                           kFewestFitting, count)};
  };
  if (balls.size() < kFewestFitting) return few(balls.size());
  const auto nearest = std::ranges::min_element(balls, {}, &PlacedBall::deviation);
  const auto [x, y] = common_place(balls, *nearest);

  std::vector<bool> fits;
  for (const PlacedBall& ball : balls)
    fits.push_back(std::hypot(ball.x - x, ball.y - y) <
                   kFits * std::hypot(ball.deviation, kWayShare * (ball.way - nearest->way)));
  const auto [first, last] = rest_around(fits, static_cast<std::size_t>(nearest - balls.begin()));
  RestingBall rest{
      .x = x, .y = y, .begin_ns = balls[first].at_ns, .end_ns = balls[last].at_ns, .nearest_ns = nearest->at_ns};
  std::vector<double> shares, near;
  for (std::size_t i = first; i <= last; ++i) {
    if (!fits[i]) continue;
    ++rest.pictures;
    const double error = std::abs(balls[i].distance - std::hypot(balls[i].robot.x - x, balls[i].robot.y - y));
    const double way = std::abs(balls[i].way - nearest->way);
    if (way > kLongWay)
      shares.push_back(error / way);
    else
      near.push_back(error);
  }
  if (rest.pictures < kFewestFitting) return few(rest.pictures);
  if (rest.end_ns - rest.begin_ns > kLongestRestNs)
    return Error{formatted("the ball lies still for %.0f hours: expected at most one, so the times are wrong",
                           static_cast<double>(rest.end_ns - rest.begin_ns) / 3.6e12)};
  rest.way_share = shares.empty() ? kWayShare : fit::kOfMedian * median(std::move(shares));
  rest.deviation = std::max(kLeastDeviation / 2, fit::kOfMedian * median(std::move(near)));
  measure_roll(balls, rest);
  return rest;
}

Result<ImportReport> import_with_ball(ImportSink& sink,
                                      const std::function<Result<ImportReport>(ImportSink& sink)>& import) {
  BallSink with_ball(sink);
  Result<ImportReport> report = import(with_ball);
  if (!report) return report;
  if (const Result<void> finished = with_ball.finish(*report); !finished) return finished.failure();
  return report;
}

}  // namespace robot::lab
