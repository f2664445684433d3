#include "sim/learn/cma.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "sim/math/random.h"

namespace sim::learn {
namespace {

constexpr int kMostSweeps = 60;

std::vector<Vector> identity(std::size_t size) {
  std::vector<Vector> matrix(size, Vector(size));
  for (std::size_t i = 0; i < size; ++i) matrix[i][i] = 1;
  return matrix;
}

double squared(const Vector& vector) { return std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.); }

/// Turns the plane of axes p and q so that matrix[p][q] becomes 0.
void rotate(std::vector<Vector>& matrix, std::vector<Vector>& directions, std::size_t p, std::size_t q) {
  const double theta = (matrix[q][q] - matrix[p][p]) / (2 * matrix[p][q]);
  const double t = std::copysign(1., theta) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  const std::size_t size = matrix.size();
  const auto turn = [&](double& a, double& b) {
    const double old = a;
    a = c * old - s * b, b = s * old + c * b;
  };
  for (std::size_t i = 0; i < size; ++i) turn(matrix[i][p], matrix[i][q]);
  for (std::size_t i = 0; i < size; ++i) turn(matrix[p][i], matrix[q][i]);
  for (std::size_t i = 0; i < size; ++i) turn(directions[i][p], directions[i][q]);
}

}  // namespace

Directions directions_of(std::vector<Vector> matrix) {
  const std::size_t size = matrix.size();
  Directions result{.directions = identity(size), .values = Vector(size)};
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double off = 0, on = 0;
    for (std::size_t p = 0; p < size; ++p)
      for (std::size_t q = 0; q < size; ++q) (p == q ? on : off) += matrix[p][q] * matrix[p][q];
    if (off <= 1e-30 * on) break;
    for (std::size_t p = 0; p < size; ++p)
      for (std::size_t q = p + 1; q < size; ++q)
        if (matrix[p][q] != 0) rotate(matrix, result.directions, p, q);
  }
  for (std::size_t i = 0; i < size; ++i) result.values[i] = matrix[i][i];
  return result;
}

Cma::Cma(Vector start, double step, int population, std::uint64_t seed)
    : size_(start.size()),
      population_(std::max(4, population)),
      seed_(seed),
      mean_(std::move(start)),
      step_(step),
      covariance_(identity(size_)),
      axes_(identity(size_)),
      lengths_(size_, 1),
      path_covariance_(size_),
      path_step_(size_) {
  // weights fall as the logarithm of the rank; log of sim/math is the same on all machines
  const int better = population_ / 2;
  const auto half = static_cast<float>(population_ + 1) / 2;
  for (int i = 1; i <= better; ++i)
    weights_.push_back(static_cast<double>(sim::log(half) - sim::log(static_cast<float>(i))));
  const double sum = std::accumulate(weights_.begin(), weights_.end(), 0.);
  for (double& weight : weights_) weight /= sum;
  effective_ = 1 / squared(weights_);
}

int Cma::usual_population(std::size_t dimensions) {
  return 4 + static_cast<int>(3 * sim::log(static_cast<float>(std::max<std::size_t>(1, dimensions))));
}

Vector Cma::normals_of(int point) const {
  Vector normals;
  for (std::uint32_t block = 0; normals.size() < size_; ++block) {
    const auto drawn = sim::normals(draw({seed_ + static_cast<std::uint64_t>(generation_)},
                                         static_cast<std::uint32_t>(point), Draw::learning, block));
    for (const float each : drawn) normals.push_back(static_cast<double>(each));
  }
  normals.resize(size_);
  return normals;
}

std::vector<Vector> Cma::ask() const {
  std::vector<Vector> points;
  for (int k = 0; k < population_; ++k) {
    const Vector normals = normals_of(k);
    Vector point = mean_;
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = 0; j < size_; ++j) point[i] += step_ * axes_[i][j] * lengths_[j] * normals[j];
    points.push_back(std::move(point));
  }
  return points;
}

void Cma::tell(std::span<const double> costs) {
  const std::vector<Vector> points = ask();
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto cost_of = [&](std::size_t i) { return std::isnan(costs[i]) ? INFINITY : costs[i]; };
  std::ranges::stable_sort(order, {}, cost_of);

  const auto n = static_cast<double>(size_);
  const double pull_step = (effective_ + 2) / (n + effective_ + 5);
  const double damping = 1 + pull_step + 2 * std::max(0., std::sqrt((effective_ - 1) / (n + 1)) - 1);
  const double pull_path = (4 + effective_ / n) / (n + 4 + 2 * effective_ / n);
  const double learn_one = 2 / ((n + 1.3) * (n + 1.3) + effective_);
  const double learn_many =
      std::min(1 - learn_one, 2 * (effective_ - 2 + 1 / effective_) / ((n + 2) * (n + 2) + effective_));
  const double expected = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));  // length of n normals

  // the mean moves to the better half
  const Vector before = mean_;
  for (std::size_t i = 0; i < size_; ++i) {
    mean_[i] = 0;
    for (std::size_t k = 0; k < weights_.size(); ++k) mean_[i] += weights_[k] * points[order[k]][i];
  }
  Vector moved(size_);  // in steps
  for (std::size_t i = 0; i < size_; ++i) moved[i] = (mean_[i] - before[i]) / step_;

  // the path of the step is in units of the covariance
  Vector along(size_), plain(size_);
  for (std::size_t j = 0; j < size_; ++j) {
    for (std::size_t i = 0; i < size_; ++i) along[j] += axes_[i][j] * moved[i];
    along[j] /= lengths_[j];
  }
  for (std::size_t i = 0; i < size_; ++i)
    for (std::size_t j = 0; j < size_; ++j) plain[i] += axes_[i][j] * along[j];
  for (std::size_t i = 0; i < size_; ++i)
    path_step_[i] = (1 - pull_step) * path_step_[i] + std::sqrt(pull_step * (2 - pull_step) * effective_) * plain[i];
  const double length = std::sqrt(squared(path_step_));
  const double settled = 1 - std::pow(1 - pull_step, 2. * (generation_ + 1));
  const bool steady = length / std::sqrt(settled) < (1.4 + 2 / (n + 1)) * expected;
  for (std::size_t i = 0; i < size_; ++i)
    path_covariance_[i] = (1 - pull_path) * path_covariance_[i] +
                          (steady ? std::sqrt(pull_path * (2 - pull_path) * effective_) : 0) * moved[i];

  const double lost = steady ? 0 : learn_one * pull_path * (2 - pull_path);
  for (std::size_t i = 0; i < size_; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double many = 0;
      for (std::size_t k = 0; k < weights_.size(); ++k)
        many += weights_[k] * (points[order[k]][i] - before[i]) * (points[order[k]][j] - before[j]) / (step_ * step_);
      const double next = (1 - learn_one - learn_many + lost) * covariance_[i][j] +
                          learn_one * path_covariance_[i] * path_covariance_[j] + learn_many * many;
      covariance_[i][j] = covariance_[j][i] = next;
    }
  step_ *= static_cast<double>(sim::exp(static_cast<float>(pull_step / damping * (length / expected - 1))));

  Directions directions = directions_of(covariance_);
  axes_ = std::move(directions.directions);
  for (std::size_t i = 0; i < size_; ++i) lengths_[i] = std::sqrt(std::max(1e-20, directions.values[i]));
  ++generation_;
}

double Cma::deviation() const { return step_ * *std::ranges::max_element(lengths_); }

}  // namespace sim::learn
