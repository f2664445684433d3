#include "tests/bench/pcl_pipelines.h"

#include <pcl/common/transforms.h>
#include <pcl/filters/extract_indices.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/segmentation/euclidean_cluster_comparator.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/organized_connected_component_segmentation.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace bench {

using namespace robot::truth;

namespace {

using Point = PclPipelines::Point;
using Cloud = PclPipelines::Cloud;

// the thesis's thresholds [m], with a crop as large as the field of the scenes
constexpr float kHalfLength = 3.2F, kHalfWidth = 2.25F;
constexpr float kRobotFrom = 0.25F, kPerson = 0.7F, kBall = 0.15F;
constexpr float kApart = 0.1F;  // of clusters
constexpr int kRobotPoints = 200, kBallPoints = 5;

constexpr float kVoxel = 0.02F;  // [m]
// found by experiment; half of them take arms for robots, and find no more robots
constexpr int kRobotVoxels = 40, kComponentPoints = 400;

bool on_field(const Point& point) { return std::abs(point.x) < kHalfLength && std::abs(point.y) < kHalfWidth; }
bool of_robot(const Point& point) { return point.z > kRobotFrom && on_field(point); }

template <class Keep>
void crop(const Cloud& from, Cloud& kept, Keep&& keep) {
  kept.clear();
  for (const Point& point : from)
    if (keep(point)) kept.push_back(point);
}

/// Returns the clusters, the largest first.
std::vector<pcl::PointIndices> clusters_of(const Cloud::Ptr& cloud, int least) {
  std::vector<pcl::PointIndices> clusters;
  if (cloud->empty()) return clusters;
  // its own k-d tree does not sort the neighbours and is therefore faster than the tutorial's
  pcl::EuclideanClusterExtraction<Point> extraction;
  extraction.setClusterTolerance(static_cast<double>(kApart));
  extraction.setMinClusterSize(least);
  extraction.setInputCloud(cloud);
  extraction.extract(clusters);
  return clusters;
}

SeenRobot robot_of(const Cloud& cloud, const pcl::PointIndices& part) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  float top = 0;
  for (const auto index : part.indices) {
    const Point& point = cloud[static_cast<std::size_t>(index)];
    sum += point.getVector3fMap().head<2>().cast<double>();
    top = std::max(top, point.z);
  }
  SeenRobot robot;
  robot.place.position = sum / static_cast<double>(part.indices.size());
  robot.height = static_cast<double>(top);
  return robot;
}

/// Returns the parts that are lower than a person.
std::vector<SeenRobot> robots_of(const Cloud& cloud, const std::vector<pcl::PointIndices>& parts) {
  std::vector<SeenRobot> robots;
  for (const pcl::PointIndices& part : parts)
    if (const SeenRobot robot = robot_of(cloud, part); robot.height <= static_cast<double>(kPerson))
      robots.push_back(robot);
  return robots;
}

void thin_out(const Cloud::Ptr& cloud, Cloud& sparse) {
  pcl::VoxelGrid<Point> grid;
  grid.setInputCloud(cloud);
  grid.setLeafSize(kVoxel, kVoxel, kVoxel);
  grid.filter(sparse);
}

/// Removes the largest plane.
void remove_floor(const Cloud::Ptr& cloud, Cloud& rest) {
  pcl::SACSegmentation<Point> segmentation;
  segmentation.setOptimizeCoefficients(true);
  segmentation.setModelType(pcl::SACMODEL_PLANE);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setMaxIterations(100);
  segmentation.setDistanceThreshold(0.06);  // [m] 0.04 leaves floor at 5 m, where a step of the depth is 0.07 m
  segmentation.setInputCloud(cloud);
  const pcl::PointIndices::Ptr floor(new pcl::PointIndices);
  pcl::ModelCoefficients plane;
  segmentation.segment(*floor, plane);
  pcl::ExtractIndices<Point> extraction;
  extraction.setInputCloud(cloud);
  extraction.setIndices(floor);
  extraction.setNegative(true);
  extraction.filter(rest);
}

/// Returns the connected components of an organised cloud with at least this many points.
std::vector<pcl::PointIndices> components_of(const Cloud::Ptr& cloud, std::size_t least) {
  const pcl::EuclideanClusterComparator<Point>::Ptr near(new pcl::EuclideanClusterComparator<Point>);
  near->setInputCloud(cloud);
  near->setDistanceThreshold(kApart, false);
  pcl::OrganizedConnectedComponentSegmentation<Point, pcl::Label> segmentation(near);
  segmentation.setInputCloud(cloud);
  pcl::PointCloud<pcl::Label> labels;
  std::vector<pcl::PointIndices> components;
  segmentation.segment(labels, components);
  std::erase_if(components, [&](const pcl::PointIndices& each) { return each.indices.size() < least; });
  return components;
}

}  // namespace

PclPipelines::PclPipelines(const SensorPose& pose, double colour_shift_x)
    : pose_(pose),
      colour_shift_(static_cast<int>(colour_shift_x)),
      orange_test_(Orange{}),
      seen_(new Cloud),
      on_field_(new Cloud),
      cropped_(new Cloud),
      sparse_(new Cloud) {
  for (int column = 0; column < pose.intrinsics.width; ++column)
    across_.push_back(static_cast<float>(pose.ray(column + 0.5, 0).x()));
  for (int row = 0; row < pose.intrinsics.height; ++row)
    down_.push_back(static_cast<float>(pose.ray(0, row + 0.5).y()));
  seen_->resize(across_.size() * down_.size());
  seen_->width = static_cast<std::uint32_t>(across_.size());
  seen_->height = static_cast<std::uint32_t>(down_.size());
  seen_->is_dense = false;
}

void PclPipelines::take(const DepthFrame& frame) {
  const auto unit = static_cast<float>(frame.unit * pose_.depth_scale);
  std::size_t pixel = 0;
  for (const float down : down_)
    for (const float across : across_) {
      Point& point = (*seen_)[pixel];
      const std::uint16_t depth = frame.depth[pixel];
      const float z = depth == 0 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(depth) * unit;
      point.x = across * z, point.y = down * z, point.z = z;
      // at the right edge another row's colour, where no ball is
      const std::size_t coloured = std::min(pixel + static_cast<std::size_t>(colour_shift_), seen_->size() - 1);
      const std::uint8_t* const rgb = &frame.rgb[3 * coloured];
      point.r = rgb[0], point.g = rgb[1], point.b = rgb[2];
      ++pixel;
    }
}

void PclPipelines::take_on_field(const DepthFrame& frame) {
  take(frame);
  pcl::transformPointCloud(*seen_, *on_field_, pose_.field_from_sensor.matrix().cast<float>().eval());
}

void PclPipelines::crop_robots() { crop(*on_field_, *cropped_, of_robot); }

bool PclPipelines::orange(const Point& point) const {
  const std::array<std::uint8_t, 3> rgb{point.r, point.g, point.b};
  return orange_test_(rgb.data());
}

std::optional<SeenBall> PclPipelines::ball() {
  crop(*on_field_, *cropped_,
       [&](const Point& point) { return std::abs(point.z) < kBall && on_field(point) && orange(point); });
  const auto balls = clusters_of(cropped_, kBallPoints);
  if (balls.empty()) return std::nullopt;
  return SeenBall{robot_of(*cropped_, balls.front()).place};
}

Detections PclPipelines::clusters(const DepthFrame& frame) {
  take_on_field(frame);
  Detections seen{.ball = ball()};
  crop_robots();
  seen.robots = robots_of(*cropped_, clusters_of(cropped_, kRobotPoints));
  return seen;
}

Detections PclPipelines::voxels_and_clusters(const DepthFrame& frame) {
  take_on_field(frame);
  Detections seen{.ball = ball()};
  crop_robots();
  thin_out(cropped_, *sparse_);
  seen.robots = robots_of(*sparse_, clusters_of(sparse_, kRobotVoxels));
  return seen;
}

Detections PclPipelines::components(const DepthFrame& frame) {
  take_on_field(frame);
  Detections seen{.ball = ball()};
  for (Point& point : *on_field_)
    if (!of_robot(point)) point.x = std::numeric_limits<float>::quiet_NaN();
  seen.robots = robots_of(*on_field_, components_of(on_field_, kComponentPoints));
  return seen;
}

Detections PclPipelines::plane_and_clusters(const DepthFrame& frame) {
  constexpr double kLeastRobot = 0.35, kMostBall = 0.2;  // [m] heights
  constexpr int kLeastVoxels = 8, kLeastRobotVoxels = 60;
  take(frame);
  thin_out(seen_, *sparse_);
  remove_floor(sparse_, *cropped_);
  pcl::transformPointCloud(*cropped_, *on_field_, pose_.field_from_sensor.matrix().cast<float>().eval());
  crop(*on_field_, *cropped_, on_field);
  Detections seen;
  for (const pcl::PointIndices& part : clusters_of(cropped_, kLeastVoxels)) {
    const SeenRobot robot = robot_of(*cropped_, part);
    const auto oranges = std::count_if(part.indices.begin(), part.indices.end(), [&](auto index) {
      return orange((*cropped_)[static_cast<std::size_t>(index)]);
    });
    if (robot.height > kLeastRobot && robot.height <= static_cast<double>(kPerson) &&
        part.indices.size() > kLeastRobotVoxels)
      seen.robots.push_back(robot);
    else if (!seen.ball && robot.height < kMostBall && 2 * oranges > std::ssize(part.indices))
      seen.ball = SeenBall{robot.place};
  }
  return seen;
}

}  // namespace bench
