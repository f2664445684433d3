// CMA-ES: evolution with an adapted covariance (Hansen, arXiv 1604.00772). It asks for points and is told their costs.
//
// libpagmo's plays one point at a time and cannot be stopped; here a whole generation is asked for at once, so that its
// games spread over threads or machines. Its numbers have addresses (sim/math/random.h): a run that goes on asks for the
// same points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sim::learn {

using Vector = std::vector<double>;

/// One search in n dimensions. Costs are compared only with each other, so any monotone cost does.
class Cma {
 public:
  /// Begins at `start` with one deviation `step` along each axis. `population` is at least 4.
  Cma(Vector start, double step, int population, std::uint64_t seed);

  /// Returns the points of the next generation. A second call returns the same points.
  std::vector<Vector> ask() const;

  /// Takes the costs of the points that ask() returned, in their order: lower is better. NaN counts as the worst.
  void tell(std::span<const double> costs);

  const Vector& mean() const { return mean_; }
  /// Returns the largest standard deviation along any direction.
  double deviation() const;
  int generation() const { return generation_; }

  /// Returns the usual population: 4 + 3 ln n.
  static int usual_population(std::size_t dimensions);

 private:
  Vector normals_of(int point) const;

  std::size_t size_;
  int population_;
  std::uint64_t seed_;
  int generation_ = 0;
  Vector mean_;
  double step_;
  std::vector<Vector> covariance_;
  std::vector<Vector> axes_;  // columns: directions, of length 1
  Vector lengths_;            // standard deviations along them
  Vector path_covariance_, path_step_;
  Vector weights_;  // of the better half
  double effective_;
};

/// A symmetric matrix as directions and values: the k-th column of `directions` belongs to `values[k]`.
struct Directions {
  std::vector<Vector> directions;
  Vector values;
};

/// Returns the eigenvectors and eigenvalues of a symmetric matrix, by Jacobi's rotations.
Directions directions_of(std::vector<Vector> matrix);

}  // namespace sim::learn
