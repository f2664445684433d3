#include "robot/truth/calibration/ground.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "robot/core/text.h"

namespace robot::truth {
namespace {

constexpr double kCarpet = 0.003;     // [m] deviation of a carpet from a plane
constexpr int kFewestPixels = 100;    // of a plane that may be the carpet
constexpr int kTrials = 300;          // planes through three pixels: half of them on the carpet gives 37 good planes
constexpr std::size_t kJudges = 600;  // pixels that vote on a trial

std::size_t index_of(int column, int row, int columns) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
}

/// A measured point and the deviation of its depth.
struct GroundSample {
  Eigen::Vector3d point;  // [m, sensor]
  double deviation;       // [m] along the ray, per metre of depth
};

struct Plane {
  Eigen::Vector3d normal;
  double height;

  double distance(const GroundSample& sample) const { return normal.dot(sample.point) + height; }
  double deviation(const GroundSample& sample) const {
    return std::hypot(normal.dot(sample.point) * sample.deviation, kCarpet);
  }
  bool holds(const GroundSample& sample) const { return std::abs(distance(sample)) < 3 * deviation(sample); }
};

std::optional<GroundSample> sample_at(const DepthFrame& frame, const Projection& camera, int column, int row) {
  const Intrinsics& image = frame.intrinsics;
  const double z = frame.unit * frame.depth[index_of(column, row, image.width)];
  const auto ray = z > 0 ? camera.ray({column + 0.5, row + 0.5}) : std::nullopt;
  if (!ray) return std::nullopt;
  const double rounding = DepthNoise::step(image, z) / std::sqrt(12.);
  return GroundSample{*ray * z, std::hypot(DepthNoise::deviation(z), rounding) / z};
}

/// Measured pixels in a grid. The noise of neighbours is alike, so they are at least three pixels apart.
struct SampleGrid {
  int columns = 0, rows = 0;
  std::vector<std::optional<GroundSample>> samples;

  const std::optional<GroundSample>& at(int column, int row) const { return samples[index_of(column, row, columns)]; }

  std::vector<GroundSample> measured() const {
    std::vector<GroundSample> all;
    for (const auto& sample : samples)
      if (sample) all.push_back(*sample);
    return all;
  }

  bool on(const Plane& plane, int column, int row) const {
    if (column < 0 || column >= columns || row < 0 || row >= rows) return true;
    return at(column, row) && plane.holds(*at(column, row));
  }

  /// Returns the samples on the plane whose four neighbours are on it, too. The foot of a wall or a robot is near enough to
  /// the carpet to be taken for it, but the pixels above it are not.
  std::vector<GroundSample> within(const Plane& plane) const {
    std::vector<GroundSample> inner;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        if (on(plane, column, row) && on(plane, column - 1, row) && on(plane, column + 1, row) &&
            on(plane, column, row - 1) && on(plane, column, row + 1))
          inner.push_back(*at(column, row));
    return inner;
  }
};

SampleGrid grid_of(const DepthFrame& frame, const Projection& camera) {
  const int spacing = std::max(3, frame.intrinsics.width / 80);
  SampleGrid grid{.columns = frame.intrinsics.width / spacing, .rows = frame.intrinsics.height / spacing};
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      grid.samples.push_back(sample_at(frame, camera, column * spacing + spacing / 2, row * spacing + spacing / 2));
  return grid;
}

/// Returns the sample of median depth around a click, or nothing where the sensor measured too little.
std::optional<GroundSample> sample_around(const DepthFrame& frame, const Projection& camera,
                                          const Eigen::Vector2d& click) {
  constexpr int kReach = 3;  // [px]
  std::vector<GroundSample> around;
  const int column = static_cast<int>(std::floor(click.x())), row = static_cast<int>(std::floor(click.y()));
  for (int v = std::max(0, row - kReach); v <= std::min(frame.intrinsics.height - 1, row + kReach); ++v)
    for (int u = std::max(0, column - kReach); u <= std::min(frame.intrinsics.width - 1, column + kReach); ++u)
      if (const auto sample = sample_at(frame, camera, u, v)) around.push_back(*sample);
  if (around.size() < kReach * kReach) return std::nullopt;
  const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
  std::nth_element(around.begin(), middle, around.end(),
                   [](const auto& a, const auto& b) { return a.point.z() < b.point.z(); });
  return *middle;
}

/// Returns the plane through three points, below the sensor, or nothing for points on a line.
std::optional<Plane> plane_through(const GroundSample& a, const GroundSample& b, const GroundSample& c) {
  const Eigen::Vector3d normal = (b.point - a.point).cross(c.point - a.point);
  if (normal.norm() < 0.01) return std::nullopt;
  const double height = -normal.normalized().dot(a.point);
  return Plane{(height < 0 ? -1 : 1) * normal.normalized(), std::abs(height)};
}

std::ptrdiff_t votes_for(const Plane& plane, const std::vector<GroundSample>& samples) {
  return std::count_if(samples.begin(), samples.end(), [&](const auto& sample) { return plane.holds(sample); });
}

/// Returns at most kJudges of the samples, from all over the image.
std::vector<GroundSample> judges_of(const std::vector<GroundSample>& samples) {
  std::vector<GroundSample> judges;
  const std::size_t each = samples.size() / kJudges + 1;
  for (std::size_t i = 0; i < samples.size(); i += each) judges.push_back(samples[i]);
  return judges;
}

/// Returns the plane with most votes of those on which at least half of the clicks lie.
std::optional<Plane> most_likely_plane(const std::vector<GroundSample>& samples,
                                       const std::vector<GroundSample>& clicked) {
  const auto judges = judges_of(samples);
  std::mt19937 random(1);
  const auto any = [&]() -> const GroundSample& { return samples[random() % samples.size()]; };
  std::optional<Plane> best;
  std::ptrdiff_t most = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const GroundSample &a = any(), &b = any(), &c = any();
    const auto plane = plane_through(a, b, c);
    if (!plane || 2 * votes_for(*plane, clicked) < static_cast<std::ptrdiff_t>(clicked.size())) continue;
    const std::ptrdiff_t votes = votes_for(*plane, judges);
    if (votes <= most) continue;
    best = plane;
    most = votes;
  }
  return best;
}

/// Returns the plane with the least sum of squares over the samples. `plane` gives their deviations.
Plane refined(const Plane& plane, const std::vector<GroundSample>& samples) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  double weights = 0;
  for (const GroundSample& sample : samples) {
    const double deviation = plane.deviation(sample), weight = 1 / (deviation * deviation);
    sum += weight * sample.point;
    squares += weight * sample.point * sample.point.transpose();
    weights += weight;
  }
  const Eigen::Vector3d middle = sum / weights;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares / weights - middle * middle.transpose());
  Eigen::Vector3d normal = solver.eigenvectors().col(0);
  if (normal.dot(plane.normal) < 0) normal = -normal;
  return {normal, -normal.dot(middle)};
}

Ground ground_of(const Plane& plane, const std::vector<GroundSample>& samples) {
  Ground ground{.normal = plane.normal, .height = plane.height, .pixels = static_cast<int>(samples.size())};
  Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
  for (const GroundSample& sample : samples) {
    const Eigen::Vector4d scaled = sample.point.homogeneous() / plane.deviation(sample);
    squares += scaled * scaled.transpose();
  }
  // a sensor that is noisier than its model counts less
  const Eigen::Vector4d parameters(plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.height);
  const double noise = ground.pixels > 0 ? parameters.dot(squares * parameters) / ground.pixels : 0;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(squares / std::max(1., noise));
  ground.roots =
      solver.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() * Eigen::Matrix4d(solver.eigenvectors().transpose());
  return ground;
}

}  // namespace

Result<Ground> find_ground(const DepthFrame& frame, const Lens& lens, const std::vector<Eigen::Vector2d>& clicks) {
  const Projection camera{frame.intrinsics, lens};
  if (frame.depth.size() != index_of(0, frame.intrinsics.height, frame.intrinsics.width))
    return Error{formatted("depth image: expected %d x %d depths, got %zu", frame.intrinsics.width,
                           frame.intrinsics.height, frame.depth.size())};

  const SampleGrid grid = grid_of(frame, camera);
  std::vector<GroundSample> clicked;
  for (const Eigen::Vector2d& click : clicks)
    if (const auto sample = sample_around(frame, camera, click)) clicked.push_back(*sample);

  constexpr int kRefinements = 8;
  const std::vector<GroundSample> measured = grid.measured();
  auto plane = measured.empty() ? std::nullopt : most_likely_plane(measured, clicked);
  for (int i = 0; plane && i < kRefinements; ++i) plane = refined(*plane, grid.within(*plane));
  const Ground ground = plane ? ground_of(*plane, grid.within(*plane)) : Ground{};
  if (ground.pixels < kFewestPixels)
    return Error{formatted("depth image: expected a carpet of at least %d measured points around the clicks, got %d",
                           kFewestPixels, ground.pixels)};
  return ground;
}

}  // namespace robot::truth
