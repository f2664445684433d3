#include "robot/lab/import/label_stance.h"

#include <array>

#include "robot/fit/math/least_squares.h"

namespace robot::lab::labels {
namespace {

using fit::Vector;

constexpr std::size_t kTerms = 6;
constexpr int kRounds = 6;
constexpr double kLowest = 0.82, kHighest = 1.3;  // of the height of a standing robot: its own box is between
constexpr double kLies = 0.68, kWide = 0.62;
constexpr double kCut = 1070;  // [px] a box that ends lower may be cut

std::array<double, kTerms> terms_of(const Box& box) {
  const double u = (box.middle() - kWidth / 2) / (kWidth / 2), v = box.bottom / (kHeight / 2);
  return {1, u, u * u, v, v * v, u * u * v};
}

double product(const std::array<double, kTerms>& terms, const std::vector<double>& factors) {
  double sum = 0;
  for (std::size_t i = 0; i < kTerms; ++i) sum += terms[i] * factors[i];
  return sum;
}

}  // namespace

Stance::Stance(const std::vector<Frame>& frames) {
  std::vector<Box> boxes;
  for (const Frame& frame : frames)
    for (const RobotBox& robot : frame.robots)
      if (robot.box.bottom < kCut) boxes.push_back(robot.box);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Vector> squares(kTerms, Vector(kTerms));
    Vector products(kTerms);
    for (const Box& box : boxes) {
      const double height = box.height();
      if (!factors_.empty()) {
        const double standing = standing_height(box);
        if (height < kLowest * standing || height > kHighest * standing) continue;
      }
      const auto terms = terms_of(box);
      for (std::size_t i = 0; i < kTerms; ++i) {
        products[i] += terms[i] * height;
        for (std::size_t j = 0; j < kTerms; ++j) squares[i][j] += terms[i] * terms[j];
      }
    }
    auto factors = fit::solve(std::move(squares), std::move(products));
    if (!factors) return;
    factors_ = *std::move(factors);
  }
}

double Stance::standing_height(const Box& box) const { return product(terms_of(box), factors_); }

bool Stance::lies(const Box& box) const {
  if (factors_.empty() || box.bottom >= kCut) return false;
  return box.height() < kLies * standing_height(box) && box.width() > kWide * box.height();
}

}  // namespace robot::lab::labels
