#include "robot/lab/synthetic/synthetic_camera.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace robot::lab::synthetic {
namespace {

// manufacturer's lengths, with bent knees; the camera is in front of and above the neck
constexpr Vector kNeck{0, 0, 0.435}, kCameraFromNeck{0.0587, 0, 0.0636};  // [m]
constexpr double kCameraTilt = 0.0209;                                    // [rad] down, 1.2°
constexpr double kFocal = 610.0 / 640;                                    // of the image's width

constexpr double kLineHalf = 0.025;                   // [m]
constexpr double kCarpetX = 5.2, kCarpetY = 3.7;      // [m] half its size
constexpr double kPenaltyX = 2.85, kPenaltyY = 2;     // [m] corner of the penalty area
constexpr double kGoalAreaX = 3.9, kGoalAreaY = 1.1;  // [m]
constexpr double kMarkX = 3.2, kMarkHalf = 0.05;      // [m] penalty mark
constexpr double kCentreCircleRadius = 0.75;          // [m]

Rotation about_x(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {1, 0, 0, 0, c, -s, 0, s, c};
}
Rotation about_y(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c, 0, s, 0, 1, 0, -s, 0, c};
}
Rotation about_z(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c, -s, 0, s, c, 0, 0, 0, 1};
}

Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

// --- colours ---

struct Colour {
  double y, u, v;
};
constexpr Colour kGreen{96, 108, 96}, kDarkGreen{90, 109, 97}, kWhite{228, 128, 127}, kFloor{78, 126, 131};
constexpr Colour kWall{168, 124, 131}, kBlack{28, 128, 128}, kShell{205, 128, 128};
constexpr Colour kRed{90, 104, 200}, kBlue{70, 190, 100};

Colour mix(const Colour& a, const Colour& b, double share) {
  return {a.y + share * (b.y - a.y), a.u + share * (b.u - a.u), a.v + share * (b.v - a.v)};
}

/// Returns the distance [m] of (x, y) from the centre of the nearest line. Both halves and sides are symmetric.
double line_distance(double x, double y) {
  x = std::abs(x);
  y = std::abs(y);
  const auto along_x = [&](double line_y, double from, double to) {  // a line at y = line_y
    return std::hypot(y - line_y, std::max({from - x, x - to, 0.0}));
  };
  const auto along_y = [&](double line_x, double to) { return std::hypot(x - line_x, std::max(y - to, 0.0)); };
  const double end = kFieldLength / 2, side = kFieldWidth / 2;
  double distance = std::min({along_x(side, 0, end), along_y(end, side), along_y(0, side)});
  distance = std::min(distance, std::abs(std::hypot(x, y) - kCentreCircleRadius));
  distance = std::min({distance, along_x(kPenaltyY, kPenaltyX, end), along_y(kPenaltyX, kPenaltyY)});
  distance = std::min({distance, along_x(kGoalAreaY, kGoalAreaX, end), along_y(kGoalAreaX, kGoalAreaY)});
  return std::min({distance, along_x(0, kMarkX - kMarkHalf, kMarkX + kMarkHalf), along_y(kMarkX, kMarkHalf)});
}

/// Returns the colour of the ground at (x, y), if one pixel covers about `footprint` [m].
Colour ground(double x, double y, double footprint) {
  if (std::abs(x) > kCarpetX || std::abs(y) > kCarpetY) return kFloor;
  const Colour carpet = static_cast<int>(std::floor(x + 100)) % 2 == 0 ? kGreen : kDarkGreen;
  const double white = (kLineHalf + footprint / 2 - line_distance(x, y)) / footprint;
  // a line narrower than a pixel colours it in part
  return mix(carpet, kWhite, std::clamp(white, 0.0, std::min(1.0, 2 * kLineHalf / footprint)));
}

// --- the image ---

class Canvas {
 public:
  explicit Canvas(const Camera& camera)
      : camera_(camera), pixels_(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height)) {}

  void background() {
    for (int v = 0; v < camera_.height; ++v)
      for (int u = 0; u < camera_.width; ++u) at(u, v) = seen(u + 0.5, v + 0.5);
  }

  /// Draws a bar from `from` to `to` with round ends, or a ball if both are the same. `paint` maps a place on it, right
  /// and down in radii (-1 .. 1), to a colour.
  template <class Paint>
  void bar(const Vector& from, const Vector& to, double radius, Paint&& paint) {
    const auto a = camera_.project(from), b = camera_.project(to);
    if (!a || !b || a->depth < 0.1 || b->depth < 0.1) return;
    const double radius_a = camera_.focal * radius / a->depth, radius_b = camera_.focal * radius / b->depth;
    const double reach = std::max(radius_a, radius_b) + 1;
    const int left = clamp_u(std::min(a->u, b->u) - reach), right = clamp_u(std::max(a->u, b->u) + reach);
    const int top = clamp_v(std::min(a->v, b->v) - reach), bottom = clamp_v(std::max(a->v, b->v) + reach);
    const double du = b->u - a->u, dv = b->v - a->v, squared = du * du + dv * dv;
    for (int v = top; v < bottom; ++v) {
      for (int u = left; u < right; ++u) {
        const double pu = u + 0.5 - a->u, pv = v + 0.5 - a->v;
        const double share = squared > 0 ? std::clamp((pu * du + pv * dv) / squared, 0.0, 1.0) : 0;
        const double off_u = pu - share * du, off_v = pv - share * dv;
        const double size = radius_a + share * (radius_b - radius_a);
        const double cover = std::clamp(size + 0.5 - std::hypot(off_u, off_v), 0.0, 1.0);
        if (cover > 0) at(u, v) = mix(at(u, v), paint(off_u / size, off_v / size), cover);
      }
    }
  }

  std::string yuyv() const {
    std::string bytes;
    bytes.reserve(2 * pixels_.size());
    const auto byte = [](double value) { return static_cast<char>(static_cast<unsigned char>(std::lround(value))); };
    for (std::size_t i = 0; i + 1 < pixels_.size(); i += 2) {
      const Colour &left = pixels_[i], &right = pixels_[i + 1];
      bytes += byte(left.y);
      bytes += byte((left.u + right.u) / 2);
      bytes += byte(right.y);
      bytes += byte((left.v + right.v) / 2);
    }
    return bytes;
  }

 private:
  Colour seen(double u, double v) const {
    const Vector ray = camera_.rotation *
                       Vector{(u - camera_.width / 2.0) / camera_.focal, (v - camera_.height / 2.0) / camera_.focal, 1};
    if (ray.z > -0.02) return mix(kWall, kShell, std::clamp(2 * ray.z, 0.0, 1.0));
    const double scale = camera_.position.z / -ray.z;
    const double footprint = scale / camera_.focal * std::sqrt(std::max(1.0, scale / camera_.position.z));
    return ground(camera_.position.x + scale * ray.x, camera_.position.y + scale * ray.y, footprint);
  }

  int clamp_u(double u) const { return static_cast<int>(std::clamp(u, 0.0, static_cast<double>(camera_.width))); }
  int clamp_v(double v) const { return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(camera_.height))); }
  Colour& at(int u, int v) {
    return pixels_[static_cast<std::size_t>(v) * static_cast<std::size_t>(camera_.width) + static_cast<std::size_t>(u)];
  }

  const Camera& camera_;
  std::vector<Colour> pixels_;
};

/// Returns the colour of the ball: white with six black patches, rotated by the rolled distance.
Colour ball_colour(double right, double down, double rolled) {
  const double front = std::sqrt(std::max(0.0, 1 - right * right - down * down));
  const double c = std::cos(rolled / kBallRadius), s = std::sin(rolled / kBallRadius);
  const double turned_down = c * down - s * front, turned_front = s * down + c * front;
  const double patch = std::max({std::abs(right), std::abs(turned_down), std::abs(turned_front)});
  return patch > 0.9 ? kBlack : mix(kBlack, kWhite, 0.75 + 0.25 * front);
}

void draw_goal(Canvas& canvas, double x) {
  const auto white = [](double right, double) { return mix(kBlack, kWhite, 1 - 0.3 * std::abs(right)); };
  const double half = kGoalWidth / 2 + kPostRadius;
  for (const double y : {-half, half}) canvas.bar({x, y, 0}, {x, y, kGoalHeight}, kPostRadius, white);
  canvas.bar({x, -half, kGoalHeight}, {x, half, kGoalHeight}, kPostRadius, white);
}

void draw_robot(Canvas& canvas, const OtherRobot& robot) {
  const auto shaded = [](const Colour& colour) {
    return [colour](double right, double) { return mix(colour, kBlack, 0.4 * right * right); };
  };
  const auto [x, y] = robot.position;
  // legs, trunk in the team's colour, head
  const double side_x = -0.05 * std::sin(robot.heading), side_y = 0.05 * std::cos(robot.heading);
  for (const double side : {-1.0, 1.0})
    canvas.bar({x + side * side_x, y + side * side_y, 0.04}, {x + side * side_x, y + side * side_y, 0.25}, 0.04,
               shaded(kShell));
  canvas.bar({x, y, 0.3}, {x, y, 0.4}, 0.09, shaded(robot.team == 14 ? kRed : kBlue));
  canvas.bar({x, y, 0.52}, {x, y, 0.52}, 0.06, shaded(kShell));
}

}  // namespace

Rotation operator*(const Rotation& a, const Rotation& b) {
  Rotation product{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      for (std::size_t i = 0; i < 3; ++i) product[3 * row + column] += a[3 * row + i] * b[3 * i + column];
  return product;
}

Vector operator*(const Rotation& a, const Vector& b) {
  return {a[0] * b.x + a[1] * b.y + a[2] * b.z, a[3] * b.x + a[4] * b.y + a[5] * b.z,
          a[6] * b.x + a[7] * b.y + a[8] * b.z};
}

std::optional<Camera::Pixel> Camera::project(const Vector& point) const {
  const Vector d{point.x - position.x, point.y - position.y, point.z - position.z};
  const Rotation& r = rotation;
  const double depth = r[2] * d.x + r[5] * d.y + r[8] * d.z;
  if (depth <= 0.01) return std::nullopt;
  return Pixel{width / 2.0 + focal * (r[0] * d.x + r[3] * d.y + r[6] * d.z) / depth,
               height / 2.0 + focal * (r[1] * d.x + r[4] * d.y + r[7] * d.z) / depth, depth};
}

bool Camera::shows(const Pixel& pixel, double margin) const {
  return pixel.u >= margin && pixel.v >= margin && pixel.u <= width - margin && pixel.v <= height - margin;
}

Camera camera_in_robot(const Bearing& bearing, int width, int height) {
  constexpr Rotation forward_left_up_from_camera{0, 0, 1, -1, 0, 0, 0, -1, 0};
  const Rotation torso = about_y(bearing.torso_pitch) * about_x(bearing.torso_roll);
  const Rotation yaw = torso * about_z(bearing.head_yaw);
  return {yaw * about_y(bearing.head_pitch + kCameraTilt) * forward_left_up_from_camera,
          torso * kNeck + yaw * about_y(bearing.head_pitch) * kCameraFromNeck, width, height, kFocal * width};
}

Camera moved(const Camera& camera_in_robot, Point position, double heading) {
  Camera camera = camera_in_robot;
  camera.rotation = about_z(heading) * camera_in_robot.rotation;
  camera.position = about_z(heading) * camera_in_robot.position + Vector{position.x, position.y, 0};
  return camera;
}

std::string draw(const Camera& camera, double t) {
  Canvas canvas(camera);
  canvas.background();
  for (const double x : {-kFieldLength / 2, kFieldLength / 2}) draw_goal(canvas, x);

  // near objects cover far objects
  std::vector<OtherRobot> robots = others_at(t);
  const auto distance = [&](Point p) { return std::hypot(p.x - camera.position.x, p.y - camera.position.y); };
  std::sort(robots.begin(), robots.end(),
            [&](const auto& a, const auto& b) { return distance(a.position) > distance(b.position); });
  const auto ball = ball_at(t);
  const auto draw_ball = [&] {
    const Vector centre{ball->position.x, ball->position.y, kBallRadius};
    canvas.bar(centre, centre, kBallRadius,
               [&](double right, double down) { return ball_colour(right, down, ball->rolled); });
  };
  bool ball_due = ball.has_value();
  for (const OtherRobot& robot : robots) {
    if (ball_due && distance(robot.position) < distance(ball->position)) draw_ball(), ball_due = false;
    draw_robot(canvas, robot);
  }
  if (ball_due) draw_ball();
  return canvas.yuyv();
}

}  // namespace robot::lab::synthetic
