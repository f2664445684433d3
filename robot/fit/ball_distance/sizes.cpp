#include "robot/fit/ball_distance/sizes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "proto/foresight/vision.pb.h"
#include "robot/lab/clocks/true_motion.h"
#include "robot/logging/sessions/read_all.h"

namespace robot::fit {
namespace {

constexpr double kBorder = 1;                            // [px] a box nearer to the border may be cut by it
constexpr double kPause = 0.5, kLongestPass = 2;         // [s]
constexpr double kLeastRadius = 0.5, kMostRadius = 640;  // [px]

bool is_cut(const foresight::Vision& vision) {
  const foresight::Detection& ball = vision.ball().detection();
  if (!ball.has_box_width() || !ball.has_box_height()) return false;
  return ball.box_left() < kBorder || ball.box_top() < kBorder ||
         ball.box_left() + ball.box_width() > static_cast<float>(vision.image_width()) - kBorder ||
         ball.box_top() + ball.box_height() > static_cast<float>(vision.image_height()) - kBorder;
}

/// Returns the cosine of the angle between the optical axis and the ball, 1 if the vision does not report it.
double axis_cosine(const foresight::Detection& ball) {
  const double right = std::tan(ball.angle_x()), down = std::tan(ball.angle_y());
  return 1 / std::sqrt(1 + right * right + down * down);
}

/// Returns the radius as BallSize has it, or nothing if it cannot be one.
std::optional<double> scaled_radius(const foresight::Vision& vision) {
  if (vision.image_width() == 0) return std::nullopt;
  const double scale = kImageWidth / vision.image_width() * axis_cosine(vision.ball().detection());
  const double radius = vision.ball().radius() * scale;
  if (!(radius >= kLeastRadius && radius <= kMostRadius)) return std::nullopt;
  return radius;
}

void read_robot(const WatchedRobot& robot, std::size_t recording, BallSizes& found) {
  const lab::TruthRecord& truth = robot.game->record;
  const lab::TrueMotion motion(truth, robot.path);
  // the truth places robot and ball about equally well
  const double placed = std::numbers::sqrt2 * truth.ball_deviation;
  const auto add = [&](const foresight::Vision& vision, std::uint64_t capture_ns) {
    if (!vision.has_ball() || vision.ball().radius() == 0) return;
    const double at = robot.true_seconds(capture_ns);
    const auto radius = scaled_radius(vision);
    const auto moment = motion.at(at);
    if (!radius) {
      ++found.damaged;
    } else if (is_cut(vision)) {
      ++found.cut;
    } else if (!moment) {
      ++found.without_truth;
    } else {
      found.sizes.push_back(
          {.recording = recording,
           .at = at,
           .radius = *radius,
           .distance = moment->distance,
           .deviation = std::hypot(placed, moment->rate * robot.clock.deviation_at(robot.own_seconds(capture_ns))),
           .rate = moment->rate,
           .believed = vision.ball().detection().distance()});
    }
  };
  logging::read_each<foresight::Vision>(robot.session, "/" + robot.session.info.robot + "/vision", add);
}

}  // namespace

BallSizes read_ball_sizes(const Evidence& evidence) {
  BallSizes found;
  for (const WatchedRobot& robot : evidence.robots) {
    const std::size_t before = found.sizes.size();
    read_robot(robot, found.recordings.size(), found);
    if (found.sizes.size() == before) continue;
    found.recordings.push_back(robot.name);
    found.clock_deviation.push_back(robot.clock.deviation);
  }
  std::ranges::stable_sort(found.sizes, [](const BallSize& one, const BallSize& other) {
    return std::tie(one.recording, one.at) < std::tie(other.recording, other.at);
  });
  return found;
}

std::vector<Group> passes_of(const std::vector<BallSize>& sizes) {
  std::vector<Group> passes;
  double begun = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const BallSize& size = sizes[i];
    const bool goes_on = i > 0 && size.recording == sizes[i - 1].recording && size.at < sizes[i - 1].at + kPause &&
                         size.at < begun + kLongestPass;
    if (!goes_on) {
      passes.emplace_back();
      begun = size.at;
    }
    passes.back().push_back(i);
  }
  return passes;
}

void thin(BallSizes& seen, std::vector<Group>& passes, std::size_t most) {
  const std::size_t count = seen.sizes.size(), every = (count + most - 1) / std::max<std::size_t>(most, 1);
  if (every <= 1) return;
  std::vector<BallSize> some;
  for (Group& pass : passes) {
    Group rest;
    for (std::size_t i = 0; i < pass.size(); i += every) {
      rest.push_back(some.size());
      some.push_back(seen.sizes[pass[i]]);
    }
    pass = std::move(rest);
  }
  seen.thinned += count - some.size();
  seen.sizes = std::move(some);
}

}  // namespace robot::fit
