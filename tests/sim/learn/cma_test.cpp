#include "sim/learn/cma.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace sim::learn {
namespace {

using Cost = std::function<double(const Vector&)>;

/// Returns the number of evaluations until the cost is below `enough`, or the limit.
int evaluations(Cma& search, const Cost& cost, double enough, int limit) {
  int used = 0;
  while (used < limit) {
    Vector costs;
    double best = INFINITY;
    for (const Vector& point : search.ask()) costs.push_back(cost(point)), best = std::min(best, costs.back());
    used += static_cast<int>(costs.size());
    search.tell(costs);
    if (best < enough) return used;
  }
  return limit;
}

double ellipsoid(const Vector& x) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += std::pow(1e3, static_cast<double>(i) / static_cast<double>(x.size() - 1)) * x[i] * x[i];
  return sum;
}

double rosenbrock(const Vector& x) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double off = x[i + 1] - x[i] * x[i];
    sum += 100 * off * off + (1 - x[i]) * (1 - x[i]);
  }
  return sum;
}

TEST(Cma, FindsTheMinimumOfAnEllipsoidOf16Dimensions) {
  // libpagmo needs 3200 evaluations for 8e-7
  Cma search(Vector(16, 1), 0.5, Cma::usual_population(16), 1);
  EXPECT_LT(evaluations(search, ellipsoid, 1e-6, 10'000), 6000);
}

TEST(Cma, FollowsTheBentValleyOfRosenbrock) {
  Cma search(Vector(6, 0), 0.3, 12, 2);
  EXPECT_LT(evaluations(search, rosenbrock, 1e-6, 40'000), 20'000);
  for (const double x : search.mean()) EXPECT_NEAR(x, 1, 0.01);
}

TEST(Cma, OnlyTheOrderOfCostsCounts) {
  Cma plain(Vector(5, 1), 0.5, 10, 3), other(Vector(5, 1), 0.5, 10, 3);
  for (int i = 0; i < 20; ++i) {
    Vector costs, cubes;
    for (const Vector& point : plain.ask()) {
      costs.push_back(ellipsoid(point));
      cubes.push_back(std::pow(costs.back(), 3) - 7);
    }
    plain.tell(costs);
    other.tell(cubes);
  }
  EXPECT_EQ(plain.mean(), other.mean());
}

TEST(Cma, AsksTheSamePointsAgain) {
  const Cma one(Vector(4, 0), 1, 8, 5), other(Vector(4, 0), 1, 8, 5), third(Vector(4, 0), 1, 8, 6);
  EXPECT_EQ(one.ask(), one.ask());
  EXPECT_EQ(one.ask(), other.ask());
  EXPECT_NE(one.ask(), third.ask());
}

TEST(Cma, ACostThatIsNoNumberIsTheWorst) {
  Cma search(Vector(3, 1), 0.3, 8, 7);
  const Cost cost = [](const Vector& x) { return x[0] < 0 ? NAN : ellipsoid(x); };
  EXPECT_LT(evaluations(search, cost, 1e-4, 20'000), 20'000);
}

TEST(Cma, DirectionsRebuildTheirMatrix) {
  const std::vector<Vector> matrix{{4, 1, -2}, {1, 3, 0.5}, {-2, 0.5, 6}};
  const Directions found = directions_of(matrix);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      double rebuilt = 0, along = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        rebuilt += found.directions[i][k] * found.values[k] * found.directions[j][k];
        along += found.directions[k][i] * found.directions[k][j];
      }
      EXPECT_NEAR(rebuilt, matrix[i][j], 1e-12);
      EXPECT_NEAR(along, i == j ? 1 : 0, 1e-12);
    }
}

TEST(Cma, GrowsItsStepWhereTheGroundFallsEvenly) {
  Cma search(Vector(4, 0), 0.1, 10, 8);
  const double before = search.deviation();
  for (int i = 0; i < 30; ++i) {
    Vector costs;
    for (const Vector& point : search.ask()) costs.push_back(-point[0]);
    search.tell(costs);
  }
  EXPECT_GT(search.deviation(), 10 * before);
  EXPECT_GT(search.mean()[0], 1);
}

}  // namespace
}  // namespace sim::learn
