#include "tests/support/rendered_pictures.h"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <random>

namespace tests {
namespace {

using robot::truth::DepthFrame;
using robot::truth::tags::Camera;

constexpr int kGrid = 8;     // [px] between exact rays
constexpr int kSamples = 3;  // along each side of a pixel
const Light kCarpet{0.05f, 0.22f, 0.06f}, kWhite{0.8f, 0.8f, 0.8f}, kBlack{0.03f, 0.03f, 0.03f};

std::size_t index_of(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

class PrintedTag final : public Thing {
 public:
  PrintedTag(int id, const Eigen::Isometry3d& field_from_tag, double edge)
      : tag_from_field_(field_from_tag.inverse()), cell_(edge / 8) {
    apriltag_family_t* family = tag36h11_create();
    image_u8_t* image = apriltag_to_image(family, id);
    for (std::size_t y = 0; y < kCells; ++y)
      for (std::size_t x = 0; x < kCells; ++x)
        black_[y * kCells + x] = image->buf[y * static_cast<std::size_t>(image->stride) + x] == 0;
    // Debian does not export image_u8_destroy()
    std::free(image->buf);
    std::free(image);
    tag36h11_destroy(family);
    middle = field_from_tag.translation();
    extent = edge;
  }

  std::optional<Hit> hit(const Eigen::Vector3d& from, const Eigen::Vector3d& way) const override {
    const Eigen::Vector3d start = tag_from_field_ * from, turned = tag_from_field_.linear() * way;
    const double distance = -start.z() / turned.z();
    if (!(distance > 0) || start.z() < 0) return std::nullopt;
    const Eigen::Vector3d at = start + distance * turned;
    const double column = at.x() / cell_ + kCells / 2.0, row = kCells / 2.0 - at.y() / cell_;
    if (column < 0 || row < 0 || column >= kCells || row >= kCells) return std::nullopt;
    return Hit{distance,
               black_[static_cast<std::size_t>(row) * kCells + static_cast<std::size_t>(column)] ? kBlack : kWhite};
  }

 private:
  static constexpr std::size_t kCells = 10;  // with the white margin
  Eigen::Isometry3d tag_from_field_;
  double cell_;
  std::array<bool, kCells * kCells> black_{};
};

class Sphere final : public Thing {
 public:
  Sphere(const Eigen::Vector3d& at, double radius, const Light& light) : light_(light) {
    middle = at;
    extent = radius;
  }

  std::optional<Hit> hit(const Eigen::Vector3d& from, const Eigen::Vector3d& way) const override {
    const Eigen::Vector3d to = middle - from;
    const double along = to.dot(way) / way.squaredNorm();
    const double inside = extent * extent - (to - along * way).squaredNorm();
    if (inside < 0) return std::nullopt;
    const double distance = along - std::sqrt(inside) / way.norm();
    const Eigen::Vector3d normal = (from + distance * way - middle) / extent;
    return Hit{distance, light_ * static_cast<float>(0.65 + 0.35 * normal.z())};  // darker below
  }

 private:
  Light light_;
};

class Cylinder final : public Thing {
 public:
  Cylinder(const Eigen::Vector2d& place, double radius, double height, const Light& light)
      : radius_(radius), height_(height), light_(light) {
    middle << place, height / 2;
    extent = std::hypot(radius, height / 2);
  }

  std::optional<Hit> hit(const Eigen::Vector3d& from, const Eigen::Vector3d& way) const override {
    const double to_top = (height_ - from.z()) / way.z();
    if (to_top > 0 && ((from + to_top * way).head<2>() - middle.head<2>()).norm() < radius_) return Hit{to_top, light_};
    const Eigen::Vector2d start = from.head<2>() - middle.head<2>(), flat = way.head<2>();
    const double a = flat.squaredNorm(), b = start.dot(flat), c = start.squaredNorm() - radius_ * radius_;
    if (a == 0 || b * b < a * c) return std::nullopt;
    const double distance = (-b - std::sqrt(b * b - a * c)) / a, z = from.z() + distance * way.z();
    if (distance <= 0 || z < 0 || z > height_) return std::nullopt;
    return Hit{distance, light_ * 0.7f};
  }

 private:
  double radius_, height_;
  Light light_;
};

Eigen::Vector3d between(const Eigen::Vector3d& first, const Eigen::Vector3d& next, int step) {
  return first + static_cast<double>(step) / kGrid * (next - first);
}

/// Returns the light of the carpet at a point [m].
Light carpet_light(double x, double y) {
  const auto near_line = [](double at, double spacing) {
    return std::abs(at - spacing * std::round(at / spacing)) < 0.025;
  };
  if (near_line(x, 1.0) || near_line(y, 1.5)) return kWhite;
  // tufts of 1 cm, brighter and darker
  const auto cell = [](double at) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(at * 100)));
  };
  const std::uint32_t tuft = cell(x) * 73856093u ^ cell(y) * 19349663u;
  return kCarpet * (0.8f + 0.4f * static_cast<float>(tuft * 2654435761u >> 24) / 255);
}

/// Blurs along the rows and returns the picture with rows and columns exchanged, so that two calls blur both ways.
std::vector<Light> blurred_turned(const std::vector<Light>& from, int width, int height,
                                  const std::vector<float>& kernel) {
  std::vector<Light> to(from.size());
  const int reach = static_cast<int>(kernel.size() / 2);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Light sum = Light::Zero();
      int at = x - reach;
      for (const float weight : kernel) sum += weight * from[index_of(std::clamp(at++, 0, width - 1), y, width)];
      to[index_of(y, x, height)] = sum;
    }
  return to;
}

std::vector<float> gauss_kernel(double deviation) {
  const int reach = std::max(1, static_cast<int>(std::ceil(2.5 * deviation)));
  std::vector<float> kernel;
  float sum = 0;
  for (int i = -reach; i <= reach; ++i) {
    kernel.push_back(static_cast<float>(std::exp(-i * i / (2 * deviation * deviation))));
    sum += kernel.back();
  }
  for (float& weight : kernel) weight /= sum;
  return kernel;
}

/// Returns normal random numbers of deviation 1, by Box and Muller.
std::vector<float> normal_numbers(std::uint32_t seed, std::size_t count) {
  std::mt19937 random(seed);
  std::vector<float> numbers;
  while (numbers.size() < count) {
    const double u = (static_cast<double>(random()) + 1) / 4294967296.0;
    const double angle = 2 * std::numbers::pi * static_cast<double>(random()) / 4294967296.0;
    numbers.push_back(static_cast<float>(std::sqrt(-2 * std::log(u)) * std::cos(angle)));
  }
  return numbers;
}

/// The bytes of linear light [0..4095 of 4096]: a camera's gamma.
std::array<float, 4096> gamma_table() {
  std::array<float, 4096> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = 255 * std::pow(static_cast<float>(i) / 4095, 1 / 2.2f);
  return table;
}

}  // namespace

std::unique_ptr<Thing> printed_tag(int id, const Eigen::Isometry3d& field_from_tag, double edge) {
  return std::make_unique<PrintedTag>(id, field_from_tag, edge);
}
std::unique_ptr<Thing> sphere(const Eigen::Vector3d& middle, double radius, const Light& light) {
  return std::make_unique<Sphere>(middle, radius, light);
}
std::unique_ptr<Thing> cylinder(const Eigen::Vector2d& place, double radius, double height, const Light& light) {
  return std::make_unique<Cylinder>(place, radius, height, light);
}

Renderer::Renderer(const Camera& camera)
    : camera_(camera), width_(camera.projection.intrinsics.width), height_(camera.projection.intrinsics.height) {
  ways_.resize(index_of(0, height_ + 1, width_ + 1));
  const auto at = [this](int x, int y) -> Eigen::Vector3d& { return ways_[index_of(x, y, width_ + 1)]; };
  // the lens is slow: each eighth ray is exact, and the others between them are within 0.01 px
  for (int y = 0; y <= height_; y += kGrid)
    for (int x = 0; x <= width_; x += kGrid)
      at(x, y) = camera.field_from_camera.linear() * camera.projection.ray({x, y}).value();
  for (int y = 0; y <= height_; y += kGrid)
    for (int x = 0; x < width_; ++x)
      at(x, y) = between(at(x / kGrid * kGrid, y), at(x / kGrid * kGrid + kGrid, y), x % kGrid);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x <= width_; ++x)
      at(x, y) = between(at(x, y / kGrid * kGrid), at(x, y / kGrid * kGrid + kGrid), y % kGrid);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) empty_.push_back(pixel({}, 0, x, y));
}

const Eigen::Vector3d& Renderer::way(int x, int y) const { return ways_[index_of(x, y, width_ + 1)]; }

Light Renderer::trace(const Things& things, std::uint64_t which, const Eigen::Vector3d& way) const {
  const Eigen::Vector3d from = camera_.field_from_camera.translation();
  double nearest = way.z() < 0 ? -from.z() / way.z() : 1e9;
  std::optional<Light> light;
  for (std::size_t i = 0; i < things.size(); ++i) {
    if ((which >> i & 1) == 0) continue;
    const auto hit = things[i]->hit(from, way);
    if (!hit || hit->distance >= nearest) continue;
    nearest = hit->distance;
    light = hit->light;
  }
  if (light) return *light;
  if (way.z() >= 0) return Light::Constant(0.4f);  // the wall
  const Eigen::Vector3d at = from + nearest * way;
  return carpet_light(at.x(), at.y());
}

Light Renderer::pixel(const Things& things, std::uint64_t which, int x, int y) const {
  Light sum = Light::Zero();
  for (int row = 0; row < kSamples; ++row)
    for (int column = 0; column < kSamples; ++column) {
      const double right = (column + 0.5) / kSamples, down = (row + 0.5) / kSamples;
      const Eigen::Vector3d upper = (1 - right) * way(x, y) + right * way(x + 1, y);
      const Eigen::Vector3d lower = (1 - right) * way(x, y + 1) + right * way(x + 1, y + 1);
      sum += trace(things, which, (1 - down) * upper + down * lower);
    }
  return sum / (kSamples * kSamples);
}

/// Returns the set of things that each pixel may show, as bits.
std::vector<std::uint64_t> Renderer::things_of_pixels(const Things& things) const {
  std::vector<std::uint64_t> which(empty_.size(), 0);
  for (std::size_t i = 0; i < things.size(); ++i) {
    const auto middle = camera_.pixel(things[i]->middle);
    if (!middle) continue;
    const double distance = (things[i]->middle - camera_.field_from_camera.translation()).norm();
    const double reach =
        2 + 1.6 * camera_.projection.intrinsics.focal_x * things[i]->extent / (distance - things[i]->extent);
    const auto from = [&](double at) { return std::max(0, static_cast<int>(at - reach)); };
    const auto to = [&](double at, int end) { return std::min(end, static_cast<int>(at + reach) + 1); };
    for (int y = from(middle->y()); y < to(middle->y(), height_); ++y)
      for (int x = from(middle->x()); x < to(middle->x(), width_); ++x)
        which[index_of(x, y, width_)] |= std::uint64_t{1} << i;
  }
  return which;
}

DepthFrame Renderer::render(const Things& things, const Conditions& conditions) const {
  std::vector<Light> light = empty_;
  const auto which = things_of_pixels(things);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const auto i = index_of(x, y, width_);
      if (which[i] != 0) light[i] = pixel(things, which[i], x, y);
    }
  const std::vector<float> kernel = gauss_kernel(conditions.blur);
  light = blurred_turned(blurred_turned(light, width_, height_, kernel), height_, width_, kernel);

  static const std::array<float, 4096> gamma = gamma_table();
  static const std::vector<float> noise = normal_numbers(1, 65537);
  DepthFrame picture = black_picture({width_, height_});
  std::mt19937 random(conditions.seed);
  for (std::size_t i = 0; i < light.size(); ++i) {
    const double across = static_cast<double>(i % static_cast<std::size_t>(width_)) / width_ - 0.5;
    const auto shade = static_cast<float>(conditions.brightness * (1 - conditions.slope * across));
    const auto draw = static_cast<std::uint32_t>(random());
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const float linear = std::clamp(shade * light[i][static_cast<Eigen::Index>(channel)], 0.f, 1.f);
      const float byte = gamma[static_cast<std::size_t>(linear * 4095)] +
                         static_cast<float>(conditions.noise) * noise[(draw >> (8 * channel)) % noise.size()];
      picture.rgb[3 * i + channel] = static_cast<std::uint8_t>(std::clamp(byte + 0.5f, 0.f, 255.f));
    }
  }
  return picture;
}

}  // namespace tests
