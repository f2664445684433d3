#include "tests/support/label_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tests {

using robot::lab::labels::Box;
using robot::lab::labels::Camera;
using robot::lab::labels::Ground;

namespace {

constexpr double kBeside = 4.5;  // [m] of the camera from the middle of the field
constexpr double kHead = 0.54;   // [m]

struct Pixel {
  double x = 960, y = 540;
};

/// Finds the pixel that shows a point by Newton's method.
Pixel pixel_of(const Camera& camera, Ground place, double above) {
  Pixel pixel{.x = 960 - 300 * place.y / place.x, .y = 540};
  for (int round = 0; round < 50; ++round) {
    const Ground now = camera.at(pixel.x, pixel.y, above);
    const Ground right = camera.at(pixel.x + 0.01, pixel.y, above), down = camera.at(pixel.x, pixel.y + 0.01, above);
    const double a = (right.x - now.x) / 0.01, b = (down.x - now.x) / 0.01;
    const double c = (right.y - now.y) / 0.01, d = (down.y - now.y) / 0.01;
    const double x = place.x - now.x, y = place.y - now.y, area = a * d - b * c;
    pixel.x += (d * x - b * y) / area, pixel.y += std::clamp((a * y - c * x) / area, -80., 80.);
  }
  return pixel;
}

/// Returns the upper edge of a box whose head is above its feet.
double top_of(const Camera& camera, const Pixel& feet) {
  const double distance = camera.distance_at(feet.x, feet.y);
  double low = feet.y - 600, high = feet.y;  // the distance of the head falls from low to high
  for (int round = 0; round < 60; ++round) {
    const double middle = (low + high) / 2;
    (camera.distance_at(feet.x, middle, kHead) > distance ? low : high) = middle;
  }
  return low;
}

Box box_of(const Camera& camera, const Labelled& one) {
  // before the camera: ahead is +y of the field, left is -x
  const Ground place{.x = one.y + kBeside, .y = -one.x};
  if (one.number == 0) {
    const Pixel middle = pixel_of(camera, place, 0.05);
    return {.left = middle.x - 7, .top = middle.y - 7, .right = middle.x + 7, .bottom = middle.y + 7};
  }
  const Pixel feet = pixel_of(camera, place, 0);
  const double standing = feet.y - top_of(camera, feet);
  const double height = one.down ? 0.5 * standing : standing, width = one.down ? 0.9 * standing : 0.55 * standing;
  return {.left = feet.x - width / 2, .top = feet.y - height, .right = feet.x + width / 2, .bottom = feet.y};
}

}  // namespace

Camera label_camera() {
  return {.focal_px = 900, .height = 2.6, .pitch = 0.45, .roll = 0.004, .lens = 1, .super_view = false};
}

std::vector<Labelled> labelled_game(double seconds) {
  std::vector<Labelled> game{
      {.colour = -1, .number = 0, .x = 2 * std::sin(0.2 * seconds), .y = std::cos(0.3 * seconds)}};
  for (const int side : {0, 1}) {
    const double sign = side == 0 ? -1 : 1;
    const int colour = side == 0 ? 2 : 5;
    game.push_back({.colour = colour, .number = 1, .x = sign * 4.25, .y = 0.1 * std::sin(seconds)});
    for (const int number : {2, 3, 4, 5}) {
      const double angle = 0.15 * seconds + 1.5 * number;
      game.push_back({.colour = colour,
                      .number = number,
                      .x = sign * (number - 2) + std::cos(angle),
                      .y = (number - 3.5) + std::sin(angle),
                      .down = side == 0 && number == 2 && seconds >= 10 && seconds < 14});
    }
  }
  return game;
}

std::string label_file(const Camera& camera, double seconds) {
  std::string file = "filename,label,x_min,y_min,x_max,y_max,color,number\n";
  for (int frame = 0; frame < seconds * 30; ++frame)
    for (const Labelled& one : labelled_game(frame / 30.)) {
      const Box box = box_of(camera, one);
      char row[200];
      std::snprintf(row, sizeof row, "%06d.jpg,%d,%.3f,%.3f,%.3f,%.3f,%d,%d\n", 1000 + frame * 1000 / 30,
                    one.number == 0 ? 1 : 0, box.left, box.top, box.right, box.bottom, one.colour,
                    one.number == 0 ? -1 : one.number);
      file += row;
    }
  return file;
}

}  // namespace tests
