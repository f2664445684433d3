#include "robot/lab/import/orange_ball.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace robot::lab {
namespace {

// of the recording of 2009: an orange ball under white light, white lines, a red jersey and skin
constexpr int kLeastRed = 155, kMostBlue = 112;  // Cr, Cb
constexpr int kFewestPairs = 18;                 // pairs of pixels
constexpr double kRound = 1.25;                  // most ratio of the box's sides and of the circle's diameter

/// The pairs of pixels that share their colour: a mask of orange ones.
class OrangeMask {
 public:
  OrangeMask(const Picture& picture, int rows)
      : width_(picture.width / 2),
        rows_(rows),
        orange_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows)) {
    for (std::size_t i = 0; i < orange_.size(); ++i) {
      const auto blue = static_cast<unsigned char>(picture.yuyv[4 * i + 1]);
      const auto red = static_cast<unsigned char>(picture.yuyv[4 * i + 3]);
      orange_[i] = red >= kLeastRed && blue <= kMostBlue;
    }
  }

  /// Removes the next connected patch and returns its pairs (column, row), or nothing at the end.
  std::vector<std::pair<int, int>> take_patch() {
    while (next_ < orange_.size() && !orange_[next_]) ++next_;
    std::vector<std::pair<int, int>> patch;
    if (next_ == orange_.size()) return patch;
    const auto start = static_cast<int>(next_);
    add(start % width_, start / width_, patch);
    for (std::size_t i = 0; i < patch.size(); ++i) {
      const auto [column, row] = patch[i];
      add(column - 1, row, patch), add(column + 1, row, patch);
      add(column, row - 1, patch), add(column, row + 1, patch);
    }
    return patch;
  }

 private:
  void add(int column, int row, std::vector<std::pair<int, int>>& patch) {
    if (column < 0 || row < 0 || column >= width_ || row >= rows_) return;
    const auto index =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
    if (!orange_[index]) return;
    orange_[index] = false;
    patch.emplace_back(column, row);
  }

  int width_, rows_;
  std::vector<bool> orange_;
  std::size_t next_ = 0;
};

/// Returns the circle of a patch. A shine in the middle of the ball belongs to it, so each row counts from its first to its
/// last pair.
FoundBall circle_of(const std::vector<std::pair<int, int>>& patch, int rows) {
  std::vector<std::pair<int, int>> extents(static_cast<std::size_t>(rows), {1 << 20, -1});
  for (const auto& [column, row] : patch) {
    auto& [first, last] = extents[static_cast<std::size_t>(row)];
    first = std::min(first, column), last = std::max(last, column);
  }
  double area = 0, x = 0, y = 0, left = 1 << 20, right = 0, top = rows, bottom = 0;
  for (int row = 0; row < rows; ++row) {
    const auto [first, last] = extents[static_cast<std::size_t>(row)];
    if (last < 0) continue;
    const double begin = 2. * first, end = 2. * last + 2, width = end - begin;
    area += width, x += width * (begin + end) / 2, y += width * (row + 0.5);
    left = std::min(left, begin), right = std::max(right, end);
    top = std::min<double>(top, row), bottom = std::max(bottom, row + 1.);
  }
  return {.x = x / area,
          .y = y / area,
          .radius = std::sqrt(area / std::numbers::pi),
          .left = left,
          .top = top,
          .width = right - left,
          .height = bottom - top};
}

bool is_round(const FoundBall& ball) {
  const auto alike = [](double one, double other) { return one < kRound * other && other < kRound * one; };
  // a side of a small ball is exact to a pair of pixels only
  const double diameter = 2 * ball.radius;
  return (alike(ball.width, diameter) || std::abs(ball.width - diameter) <= 2) &&
         (alike(ball.height, diameter) || std::abs(ball.height - diameter) <= 1);
}

}  // namespace

std::optional<FoundBall> find_orange_ball(const Picture& picture, int last_row) {
  const int rows = std::clamp(last_row, 0, picture.height);
  if (picture.width < 2 || picture.width % 2 != 0 ||
      picture.yuyv.size() < 2 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height))
    return std::nullopt;
  OrangeMask mask(picture, rows);
  std::optional<FoundBall> best;
  for (auto patch = mask.take_patch(); !patch.empty(); patch = mask.take_patch()) {
    if (patch.size() < kFewestPairs) continue;
    const FoundBall ball = circle_of(patch, rows);
    const bool cut =
        ball.left <= 0 || ball.top <= 0 || ball.left + ball.width >= picture.width || ball.top + ball.height >= rows;
    if (cut || !is_round(ball) || (best && ball.radius <= best->radius)) continue;
    best = ball;
  }
  return best;
}

}  // namespace robot::lab
