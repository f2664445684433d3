#include "robot/fit/visibility/looks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

#include "proto/foresight/vision.pb.h"
#include "robot/core/text.h"
#include "robot/fit/math/angles.h"
#include "robot/fit/visibility/along.h"
#include "robot/fit/visibility/view.h"
#include "robot/logging/sessions/read_all.h"

namespace robot::fit {
namespace {

constexpr double kFastestRobot = 3, kFastestBall = 8;  // [m/s] a faster one was put elsewhere
constexpr double kSettled = 0.2;                  // [s] the camera still shows the place before it was put elsewhere
constexpr double kLongestImage = 0.1;             // [s]
constexpr std::uint64_t kSameImage = 20'000'000;  // [ns] between an image and its camera matrix
constexpr double kLongestTurn = 0.2;              // [s] between two camera matrices that give a speed
constexpr double kItself = 0.15;                  // [m] no other robot is that near
constexpr double kDoubt = 3;                      // [standard deviations] whether a robot hides the ball
constexpr double kHalfWindow = 0.5;               // [s] in which a robot's walk shows
constexpr double kWalked = 0.06, kTurned = 0.2;   // [m], [rad] in that window

double seconds_between(std::uint64_t from_ns, std::uint64_t to_ns) {
  return static_cast<double>(static_cast<std::int64_t>(to_ns - from_ns)) * 1e-9;
}

/// Reads the views of one camera, in the order of their times.
std::vector<View> read_views(const WatchedRobot& robot, const char* topic) {
  std::vector<View> views;
  const auto add = [&](const foresight::CameraMatrix& matrix, std::uint64_t capture_ns) {
    if (const auto view = view_of(matrix, capture_ns)) views.push_back(*view);
  };
  logging::read_each<foresight::CameraMatrix>(robot.session, "/" + robot.session.info.robot + topic, add);
  std::ranges::stable_sort(views, {}, &View::capture_ns);
  for (std::size_t i = 1; i < views.size(); ++i) {
    const double time = seconds_between(views[i - 1].capture_ns, views[i].capture_ns);
    if (time > 0 && time <= kLongestTurn) views[i].speed = angle_between(views[i - 1], views[i]) / time;
  }
  return views;
}

/// Returns the view at the time of an image, or nullptr.
const View* view_at(const std::vector<View>& views, std::uint64_t capture_ns) {
  const auto next = std::ranges::lower_bound(views, capture_ns, {}, &View::capture_ns);
  const View* nearest = nullptr;
  std::uint64_t least = kSameImage + 1;
  for (auto view = next == views.begin() ? next : next - 1; view != views.end() && view <= next; ++view) {
    const std::uint64_t far =
        view->capture_ns > capture_ns ? view->capture_ns - capture_ns : capture_ns - view->capture_ns;
    if (far < least) least = far, nearest = &*view;
  }
  return nearest;
}

/// The images of one robot while they are read.
class Watch {
 public:
  Watch(const WatchedRobot& robot, const sim::Models& base, std::size_t recording, Looks& found)
      : robot_(robot),
        truth_(robot.game->record),
        base_(base),
        recording_(recording),
        found_(found),
        own_(robot.path, kFastestRobot),
        ball_(truth_.ball, kFastestBall),
        top_(read_views(robot, "/camera_top_matrix")),
        bottom_(read_views(robot, "/camera_bottom_matrix")) {
    for (const lab::TrueRobotPath& other : truth_.robots) others_.emplace_back(other.path, kFastestRobot);
  }

  void add(const foresight::Vision& vision, std::uint64_t capture_ns) {
    const double at = robot_.true_seconds(capture_ns);
    Look look{.recording = recording_, .at = at, .duration = std::clamp(at - before_, 0., kLongestImage)};
    before_ = at;
    const auto own = own_.at(at);
    const auto ball = ball_.at(at);
    const View *top = view_at(top_, capture_ns), *bottom = view_at(bottom_, capture_ns);
    if (!top && !bottom)
      ++found_.without_camera;
    else if (!own || !ball || !settled(at))
      ++found_.without_truth;
    else if (!std::isfinite(own->heading))
      ++found_.without_heading;
    else if (own->fallen.value_or(false) || (top ? top : bottom)->z < base_.perception.camera.height / 2)
      ++found_.not_upright;
    else if (!take_ball(vision, look))
      ++found_.damaged;
    else {
      take_truth(*own, *ball, capture_ns, look);
      take_views(top, bottom, look);
      look.hiding = hiding(*own, *ball, look);
      found_.looks.push_back(look);
    }
  }

 private:
  /// Reports whether neither the robot nor the ball was put elsewhere recently.
  bool settled(double at) {
    for (double ago = kSettled; ago > 0; ago -= 1 / 30.)
      if (!ball_.at(at - ago)) return false;
    return own_.at(at - kSettled / 2) && own_.at(at - kSettled);
  }

  static bool take_ball(const foresight::Vision& vision, Look& look) {
    look.has_ball = vision.has_ball();
    if (!look.has_ball) return true;
    look.seen_x = vision.ball().detection().x();
    look.seen_y = vision.ball().detection().y();
    return std::isfinite(look.seen_x) && std::isfinite(look.seen_y);
  }

  void take_truth(const lab::PlaceAt& own, const lab::PlaceAt& ball, std::uint64_t capture_ns, Look& look) {
    const double x = ball.x - own.x, y = ball.y - own.y;
    look.distance = std::hypot(x, y);
    look.bearing = wrapped(std::atan2(y, x) - own.heading);
    const auto past = ball_.at(look.at - kSettled);
    const double speed = std::hypot(ball.x - past->x, ball.y - past->y) / kSettled;
    const double latency = base_.effects.latency ? base_.perception.camera.latency : 0;
    const double clock = robot_.clock.deviation_at(robot_.own_seconds(capture_ns));
    // the truth places robot and ball about equally well; a late image shows the ball where it was
    look.placed = std::hypot(std::numbers::sqrt2 * truth_.ball_deviation, speed * clock) + speed * latency / kDoubt;
    look.walking = walks(own);
  }

  bool walks(const lab::PlaceAt& own) {
    const auto from = own_.at(own.at - kHalfWindow), to = own_.at(own.at + kHalfWindow);
    if (!from || !to) return true;
    return std::hypot(to->x - from->x, to->y - from->y) > kWalked ||
           std::abs(wrapped(to->heading - from->heading)) > kTurned;
  }

  void take_views(const View* top, const View* bottom, Look& look) const {
    const double radius = base_.ball.radius;
    const double x = look.distance * std::cos(look.bearing), y = look.distance * std::sin(look.bearing);
    double best = -INFINITY;
    look.nearest = INFINITY, look.farthest = 0;
    for (const View* view : {top, bottom}) {
      if (!view) continue;
      const double height = view->z - radius, upper = view->tilt - view->up, lower = view->tilt + view->down;
      look.nearest = std::min(look.nearest, lower < M_PI_2 ? height / std::tan(std::max(lower, 1e-3)) : 0);
      look.farthest = std::max(look.farthest, upper > 0 ? height / std::tan(upper) : INFINITY);
      const View::Inside inside = view->inside(x, y, radius);
      if (const double least = std::min(inside.across, inside.upright); least > best) {
        best = least;
        look.across = inside.across, look.upright = inside.upright;
        look.axis = view->bearing, look.width = view->left + view->right;
        look.head_speed = view->speed, look.height = height;
      }
    }
  }

  /// Compares the places of all other robots with the line of sight.
  Hiding hiding(const lab::PlaceAt& own, const lab::PlaceAt& ball, const Look& look) {
    if (std::min(look.across, look.upright) < 0 || look.distance == 0) return Hiding::free;
    const double ux = (ball.x - own.x) / look.distance, uy = (ball.y - own.y) / look.distance;
    const double radius = base_.contact.hiding_radius, doubt = kDoubt * look.placed;
    Hiding found = Hiding::free;
    for (Along& path : others_) {
      const auto other = path.at(look.at);
      if (!other || other->fallen.value_or(false)) continue;
      const double x = other->x - own.x, y = other->y - own.y;
      const double along = x * ux + y * uy, across = std::abs(x * uy - y * ux);
      if (std::hypot(x, y) < kItself || along < 0 || along > look.distance + doubt || across > radius + doubt) continue;
      if (along < look.distance - doubt && across < radius - doubt) return Hiding::hidden;
      found = Hiding::unsure;
    }
    return found;
  }

  const WatchedRobot& robot_;
  const lab::TruthRecord& truth_;
  const sim::Models& base_;
  const std::size_t recording_;
  Looks& found_;
  Along own_, ball_;
  std::vector<Along> others_;
  std::vector<View> top_, bottom_;
  double before_ = -INFINITY;  // [s] time of the last image
};

}  // namespace

Looks read_looks(const Evidence& evidence, const sim::Models& base) {
  Looks found;
  for (const WatchedRobot& robot : evidence.robots) {
    const std::size_t before = found.looks.size();
    Watch watch(robot, base, found.recordings.size(), found);
    logging::read_each<foresight::Vision>(
        robot.session, "/" + robot.session.info.robot + "/vision",
        [&](const foresight::Vision& vision, std::uint64_t capture_ns) { watch.add(vision, capture_ns); });
    if (found.looks.size() > before) found.recordings.push_back(robot.name);
  }
  std::ranges::stable_sort(found.looks, [](const Look& one, const Look& other) {
    return std::tie(one.recording, one.at) < std::tie(other.recording, other.at);
  });
  return found;
}

std::string reason_without(const Looks& looks) {
  if (looks.without_heading > 0)
    return formatted("the truth has no headings of the robots (%zu images)", looks.without_heading);
  if (looks.without_camera > 0)
    return formatted("expected a camera matrix for each image, got none for all %zu", looks.without_camera);
  if (looks.without_truth > 0)
    return formatted("the truth does not place robot and ball at the time of any of %zu images", looks.without_truth);
  return "expected images of robots beside the truth (topic vision), got none";
}

std::string left_out(const Looks& looks) {
  return formatted(
      "Left out: %zu images without a true place of robot and ball, %zu without the robot's heading, %zu without a "
      "camera "
      "matrix, %zu of a robot that lies, %zu damaged.",
      looks.without_truth, looks.without_heading, looks.without_camera, looks.not_upright, looks.damaged);
}

}  // namespace robot::fit
