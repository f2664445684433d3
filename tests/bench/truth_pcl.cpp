// How much faster and more exact is ground truth's detection than the usual pipelines of the Point Cloud Library?
//
//   bench_truth_pcl [FRAMES]    ours and PCL's pipelines on this many synthetic images, 200 by default
//
// Prints a line of JSON for each pipeline. The images are those of the first case of bench_truth_frames. All pipelines
// take each image in turn, so that the load of other programs meets all of them. Ours takes a third more time here than
// alone: PCL's clouds of 10 MB presumably empty the caches. PCL's robots are moved by a constant from the surface to
// the middle, as ours are; `uncorrected_robots` are without it. Only our normalised errors mean something, because PCL
// states no covariance. Budget of ours: as bench_truth_frames.
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "robot/core/clock.h"
#include "robot/truth/detection/detector.h"
#include "robot/truth/synthetic/renderer.h"
#include "robot/truth/synthetic/sensor_poses.h"
#include "tests/bench/pcl_pipelines.h"
#include "tests/bench/truth_scenes.h"
#include "tests/bench/truth_score.h"
#include "tests/sim/support/fields.h"

namespace {

using namespace robot::truth;
using bench::PclPipelines;

struct Pipeline {
  const char* name;
  double surface_to_centre;  // [m] away from the sensor, beyond a correction of its own; the best for these images
  std::function<Detections(const DepthFrame&)> detect;
  bench::TruthScore score{}, uncorrected{};

  void take(const DepthFrame& image, const Scene& scene, bool ball_visible, const SensorPose& pose) {
    const std::uint64_t begin_ns = robot::thread_cpu_ns();
    Detections seen = detect(image);
    score.milliseconds.push_back(static_cast<double>(robot::thread_cpu_ns() - begin_ns) / 1e6);
    score.add_ball(*scene.ball, ball_visible, pose, seen.ball);
    uncorrected.add_robots(scene, pose, seen.robots);
    const Eigen::Vector2d eye = pose.field_from_sensor.translation().head<2>();
    for (SeenRobot& robot : seen.robots)
      robot.place.position += surface_to_centre * (robot.place.position - eye).normalized();
    score.add_robots(scene, pose, std::move(seen.robots));
  }

  nlohmann::json figures(int frames) const {
    nlohmann::json all = score.figures(frames);
    all["pipeline"] = name;
    all["uncorrected_robots"] = uncorrected.standing.figures(frames);
    return all;
  }
};

}  // namespace

int main(int count, char** words) {
  const int frames = count > 1 ? std::atoi(words[1]) : 200;
  if (frames < 1) {
    std::fputs("bench_truth_pcl: FRAMES must be a number above 0\n", stderr);
    return 2;
  }
  const SensorPose pose = mast(sim::kField2012);
  const DetectorOptions options{.ball_radius = 0.05, .colour_shift_x = 1};
  Renderer renderer(pose, {.field = sim::kField2012});
  bench::TruthScenes scenes(pose, options.ball_radius, BallColour::orange);
  robot::Result<Detector> ours = Detector::create(pose, sim::kField2012, options);
  PclPipelines pcl(pose, options.colour_shift_x);
  Pipeline pipelines[] = {
      {"ours", 0, [&](const DepthFrame& image) { return *ours->detect(image); }},
      {"PCL, the thesis's pipeline", 0.063, [&](const DepthFrame& image) { return pcl.clusters(image); }},
      {"PCL, RANSAC plane", 0.055, [&](const DepthFrame& image) { return pcl.plane_and_clusters(image); }},
      {"PCL, voxels", 0.057, [&](const DepthFrame& image) { return pcl.voxels_and_clusters(image); }},
      {"PCL, components", 0.066, [&](const DepthFrame& image) { return pcl.components(image); }},
  };
  for (int frame = 0; frame < frames; ++frame) {
    const Scene scene = scenes.next();
    const DepthFrame image = renderer.render(scene, static_cast<std::uint64_t>(frame));
    const bool ball_visible = bench::visible(renderer, *scene.ball);
    for (Pipeline& each : pipelines) each.take(image, scene, ball_visible, pose);
  }
  for (const Pipeline& each : pipelines) std::puts(each.figures(frames).dump().c_str());
}
