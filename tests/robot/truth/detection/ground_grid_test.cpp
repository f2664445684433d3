#include "robot/truth/detection/ground_grid.h"

#include <gtest/gtest.h>

namespace robot::truth {
namespace {

using Eigen::Vector2f;

TEST(GroundGrid, SumsTheSurfaceWithinARadius) {
  GroundGrid grid({3, 2});
  grid.add(Layer::head, 1, 1, 0.002F, 0.5F);
  grid.add(Layer::head, 1.05F, 1, 0.002F, 0.6F);
  grid.add(Layer::head, 1.5F, 1, 0.002F, 0.7F);
  grid.add(Layer::low, 1, 1, 0.002F, 0.1F);
  const Surface near = grid.within(Layer::head, {1, 1}, 0.2F);
  EXPECT_FLOAT_EQ(near.area, 0.004F);
  EXPECT_FLOAT_EQ(near.top, 0.6F);
  EXPECT_LT((near.mean() - Vector2f(1.025F, 1)).norm(), 1e-5F);
}

TEST(GroundGrid, TheDensestPlaceHasMostSurfaceAroundIt) {
  GroundGrid grid({3, 2});
  grid.add(Layer::low, -2, -1, 0.01F, 0.1F);
  for (const float x : {1.F, 1.08F, 1.16F}) grid.add(Layer::low, x, 0.5F, 0.005F, 0.1F);
  EXPECT_LT((grid.densest(Layer::low, 0.12F) - Vector2f(1.08F, 0.5F)).norm(), 0.03F);
  EXPECT_LT((grid.densest(Layer::low, 0.03F) - Vector2f(-2, -1)).norm(), 0.03F);
}

TEST(GroundGrid, RemovedAndClearedSurfaceIsGone) {
  GroundGrid grid({3, 2});
  grid.add(Layer::body, 1, 1, 0.002F, 0.3F);
  grid.add(Layer::body, -1, 1, 0.002F, 0.3F);
  grid.remove(Layer::body, {1, 1}, 0.1F);
  EXPECT_EQ(grid.within(Layer::body, {1, 1}, 0.1F).area, 0);
  EXPECT_GT(grid.within(Layer::body, {-1, 1}, 0.1F).area, 0);
  grid.clear();
  EXPECT_EQ(grid.within(Layer::body, {0, 0}, 5).area, 0);
}

TEST(GroundGrid, PlacesOutsideCountForTheNearestCell) {
  GroundGrid grid({3, 2});
  grid.add(Layer::tall, 50, -50, 0.002F, 1);
  EXPECT_GT(grid.within(Layer::tall, {2.98F, -1.98F}, 0.05F).area, 0);
  EXPECT_EQ(grid.within(Layer::tall, {50, -50}, 1).area, 0);
}

}  // namespace
}  // namespace robot::truth
