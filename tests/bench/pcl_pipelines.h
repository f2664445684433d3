// The usual ways to find robots and a ball with the Point Cloud Library (PCL), beside which ours is measured.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <optional>
#include <vector>

#include "robot/truth/detection/orange_test.h"
#include "robot/truth/frame/depth_frame.h"
#include "robot/truth/frame/detections.h"
#include "robot/truth/frame/sensor_pose.h"

namespace bench {

/// Pipelines for one sensor at one place. A robot or ball is at the mean of its visible surface, as in the thesis. Only
/// standing robots and orange balls are found. Memory is kept from image to image.
class PclPipelines {
 public:
  PclPipelines(const robot::truth::SensorPose& pose, double colour_shift_x);

  /// The pipeline of the thesis (Khandelwal and Stone 2012): all points to the field, a crop, Euclidean clusters.
  robot::truth::Detections clusters(const robot::truth::DepthFrame& frame);

  /// The pipeline of PCL's tutorials: voxel grid, RANSAC for the plane of the floor, Euclidean clusters of the rest.
  robot::truth::Detections plane_and_clusters(const robot::truth::DepthFrame& frame);

  /// The thesis's pipeline with a voxel grid between crop and clusters.
  robot::truth::Detections voxels_and_clusters(const robot::truth::DepthFrame& frame);

  /// The thesis's pipeline with connected components of the image, which need no k-d tree, in place of clusters.
  robot::truth::Detections components(const robot::truth::DepthFrame& frame);

  using Point = pcl::PointXYZRGB;
  using Cloud = pcl::PointCloud<Point>;

 private:
  void take(const robot::truth::DepthFrame& frame);
  void take_on_field(const robot::truth::DepthFrame& frame);
  void crop_robots();
  std::optional<robot::truth::SeenBall> ball();
  bool orange(const Point& point) const;

  robot::truth::SensorPose pose_;
  int colour_shift_;  // [px]
  robot::truth::OrangeTest orange_test_;
  std::vector<float> across_, down_;  // of the rays of columns and rows, in the frame `sensor`, with z = 1
  Cloud::Ptr seen_;                   // organised [m, sensor]; NaN: not measured
  Cloud::Ptr on_field_;               // [m, field]
  Cloud::Ptr cropped_, sparse_;
};

}  // namespace bench
