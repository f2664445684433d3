#include "robot/truth/detection/ball_agreement.h"

#include <algorithm>
#include <cmath>

namespace robot::truth {
namespace {

using Eigen::Vector3f;

float capped_square(float x) { return std::min(x * x, 9.F); }

/// The surface of a ball as one sensor sees it.
class BallSurface {
 public:
  BallSurface(const Vector3f& centre, float radius)
      : centre_(centre), outside_(centre.squaredNorm() - radius * radius) {}

  /// Returns the depth at which a ray meets the ball, or 0 when it passes.
  float depth(const Vector3f& ray) const {
    const float along = ray.dot(centre_), squared = ray.squaredNorm(), root = along * along - squared * outside_;
    return root < 0 ? 0 : (along - std::sqrt(root)) / squared;
  }

 private:
  Vector3f centre_;
  float outside_;
};

/// The pixels within some distance of a place, every `step`-th in both directions.
struct Window {
  int first_row, end_row, first_column, end_column, step;

  Window(const Intrinsics& image, const Eigen::Vector2d& middle, double reach)
      : first_row(std::clamp(static_cast<int>(middle.y() - reach), 0, image.height)),
        end_row(std::clamp(static_cast<int>(middle.y() + reach) + 1, 0, image.height)),
        first_column(std::clamp(static_cast<int>(middle.x() - reach), 0, image.width)),
        end_column(std::clamp(static_cast<int>(middle.x() + reach) + 1, 0, image.width)),
        step(std::max(1, static_cast<int>(reach / 9))) {}
};

}  // namespace

BallAgreement ball_agreement(const Sight& sight, const DepthFrame& frame, const Eigen::Vector3d& centre,
                             double radius) {
  const Intrinsics& image = sight.pose().intrinsics;
  const Eigen::Vector2d middle(image.centre_x + image.focal_x * centre.x() / centre.z(),
                               image.centre_y + image.focal_y * centre.y() / centre.z());
  const Window window(image, middle, 1.6 * image.focal_x * radius / centre.z());
  const BallSurface surface(centre.cast<float>(), static_cast<float>(radius));
  const auto ball_depth = static_cast<float>(centre.z()), middle_row = static_cast<float>(middle.y());

  const int weight = window.step * window.step;
  float evidence = 0;
  BallAgreement sum;
  for (int row = window.first_row; row < window.end_row; row += window.step)
    for (int column = window.first_column; column < window.end_column; column += window.step) {
      const std::uint16_t depth = frame.depth[sight.index(row, column)];
      if (depth == 0) continue;
      const float z = sight.metres(depth), deviation = sight.deviation(depth);
      const float from_empty = capped_square((z - sight.background(row, column)) / deviation);
      if (const float on_ball = surface.depth(sight.sensor_ray(row, column)); on_ball > 0) {
        const float from_ball = capped_square((z - on_ball) / deviation);
        evidence += from_empty - from_ball;
        sum.fitting += from_ball < 9 ? weight : 0;
        sum.pixels += weight;
      } else if (static_cast<float>(row) < middle_row) {
        // a thing of the same depth that is higher or wider than a ball
        const float against = from_empty - capped_square((z - ball_depth) / deviation);
        evidence -= std::max(0.F, against);
        sum.clear += against <= 0 ? weight : 0;
        sum.around += weight;
      }
    }
  sum.evidence = static_cast<double>(evidence) * weight;
  return sum;
}

}  // namespace robot::truth
