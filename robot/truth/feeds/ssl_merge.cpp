#include "robot/truth/feeds/ssl_merge.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "robot/core/text.h"
#include "robot/truth/feeds/angle.h"

namespace robot::truth {
namespace {

namespace pb = foresight;

/// A thing in one image, and the camera that saw it.
template <class Thing>
struct Sighting {
  Thing thing;
  std::uint32_t camera = 0;
};

using RobotSighting = Sighting<SslRobot>;
using BallSighting = Sighting<SslBall>;

template <class Thing>
double distance(const Thing& a, const Thing& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// The mean of some sightings, weighted by their confidence.
class Mean {
 public:
  template <class Thing>
  void add(const Sighting<Thing>& sighting) {
    const double weight = weight_of(sighting.thing);
    x_ += weight * sighting.thing.x;
    y_ += weight * sighting.thing.y;
    weight_ += weight;
    confidence_ = std::max(confidence_, sighting.thing.confidence);
    cameras_ |= std::uint64_t{1} << sighting.camera;
  }
  void add_heading(const SslRobot& robot) {
    if (!robot.heading) return;
    cosine_ += weight_of(robot) * std::cos(*robot.heading);
    sine_ += weight_of(robot) * std::sin(*robot.heading);
    has_heading_ = true;
  }

  template <class Message>
  void fill(Message& message) const {
    message.set_x(static_cast<float>(x_ / weight_));
    message.set_y(static_cast<float>(y_ / weight_));
    message.set_confidence(static_cast<float>(confidence_));
    message.set_sensors(static_cast<std::uint32_t>(std::popcount(cameras_)));
  }
  std::optional<float> heading() const {
    return has_heading_ ? std::optional(static_cast<float>(in_one_turn(std::atan2(sine_, cosine_)))) : std::nullopt;
  }

 private:
  /// A confidence of 0 also counts, or a mean of such sightings would have no weight.
  template <class Thing>
  static double weight_of(const Thing& thing) {
    return thing.confidence + 1e-6;
  }

  double x_ = 0, y_ = 0, weight_ = 0, confidence_ = 0, cosine_ = 0, sine_ = 0;
  bool has_heading_ = false;
  std::uint64_t cameras_ = 0;  // one bit for each
};

/// Returns all robots, or all balls, of the views, the most confident one first. Of equals the one of the first view
/// comes first.
template <class Thing>
std::vector<Sighting<Thing>> by_confidence(const std::vector<SslView>& views, std::vector<Thing> SslView::*things) {
  std::vector<Sighting<Thing>> all;
  for (const SslView& view : views)
    for (const Thing& thing : view.*things) all.push_back({thing, view.camera});
  std::ranges::stable_sort(all, std::ranges::greater(),
                           [](const Sighting<Thing>& sighting) { return sighting.thing.confidence; });
  return all;
}

bool inside(const SslBall& ball, const std::optional<SslField>& field) {
  return !field || (std::abs(ball.x) <= field->length / 2 + field->border &&
                    std::abs(ball.y) <= field->width / 2 + field->border);
}

void set_ball(const std::vector<BallSighting>& balls, const std::optional<SslField>& field, pb::GroundTruth& truth) {
  const auto best = std::ranges::find_if(balls, [&](const BallSighting& ball) { return inside(ball.thing, field); });
  if (best == balls.end()) return;
  Mean mean;
  for (const BallSighting& ball : balls)
    if (distance(ball.thing, best->thing) <= kSameBall) mean.add(ball);
  mean.fill(*truth.mutable_ball());
}

/// The sightings of one robot. The first one is the most confident, and its place counts.
struct Cluster {
  std::vector<RobotSighting> sightings;

  const SslRobot& robot() const { return sightings.front().thing; }
  bool near(const SslRobot& other) const { return distance(robot(), other) <= kSameRobot; }
};

/// Returns the cluster to which a robot belongs, or the end.
std::vector<Cluster>::iterator cluster_of(const SslRobot& robot, std::vector<Cluster>& clusters) {
  return std::ranges::find_if(clusters, [&](const Cluster& cluster) {
    if (robot.team != cluster.robot().team) return false;
    return robot.player ? robot.player == cluster.robot().player : cluster.near(robot);
  });
}

/// Groups the sightings. Robots with a number come first, so that one without joins the numbered one at its place.
std::vector<Cluster> clusters_of(const std::vector<RobotSighting>& robots) {
  std::vector<Cluster> clusters;
  for (const bool numbered : {true, false})
    for (const RobotSighting& robot : robots) {
      if (robot.thing.player.has_value() != numbered) continue;
      const auto found = cluster_of(robot.thing, clusters);
      if (found == clusters.end())
        clusters.push_back({{robot}});
      else
        found->sightings.push_back(robot);
    }
  return clusters;
}

std::string disagreement(const RobotSighting& one, const RobotSighting& other) {
  return formatted("robot %u/%u: camera %u sees it at (%.2f, %.2f), camera %u at (%.2f, %.2f), %.2f m apart",
                   one.thing.team, one.thing.player.value_or(0), one.camera, one.thing.x, one.thing.y, other.camera,
                   other.thing.x, other.thing.y, distance(one.thing, other.thing));
}

void add_robot(const Cluster& cluster, pb::GroundTruth& truth) {
  Mean mean;
  for (const RobotSighting& sighting : cluster.sightings) {
    if (!cluster.near(sighting.thing)) {
      truth.add_disagreements(disagreement(cluster.sightings.front(), sighting));
      continue;
    }
    mean.add(sighting);
    mean.add_heading(sighting.thing);
  }
  pb::GroundTruth::TrueRobot& robot = *truth.add_robots();
  mean.fill(robot);
  robot.set_team(cluster.robot().team);
  if (cluster.robot().player) robot.set_player(*cluster.robot().player);
  if (mean.heading()) robot.set_heading(*mean.heading());
}

}  // namespace

pb::GroundTruth merge(const std::vector<SslView>& views, const std::optional<SslField>& field) {
  pb::GroundTruth truth;
  set_ball(by_confidence(views, &SslView::balls), field, truth);
  for (const Cluster& cluster : clusters_of(by_confidence(views, &SslView::robots))) add_robot(cluster, truth);
  return truth;
}

}  // namespace robot::truth
