#include "sim/agent/columns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim/agent/mirror.h"
#include "tests/sim/agent/scene.h"

namespace sim::agent {
namespace {

using Form = Column::Form;

std::vector<float> observed(const Columns& columns, const Scene& scene) {
  std::vector<float> row(columns.list().size());
  columns.observe(scene.view(), row.data());
  return row;
}

TEST(Columns, EachIsFromMinusOneToOneInAnySituation) {
  const Columns columns(built_in_features());
  std::mt19937 random(3);
  for (int i = 0; i < 5000; ++i) {
    const std::vector<float> row = observed(columns, random_scene(random));
    for (std::size_t c = 0; c < row.size(); ++c) {
      ASSERT_GE(row[c], -1) << name_of(columns.list()[c]);
      ASSERT_LE(row[c], 1) << name_of(columns.list()[c]);
    }
  }
}

TEST(Columns, HaveDifferentNamesAndAFormula) {
  const Columns columns(built_in_features());
  EXPECT_LE(columns.count(), kMaxColumns);
  std::set<std::string> names;
  for (const Column& column : columns.list()) {
    EXPECT_TRUE(names.insert(name_of(column)).second) << name_of(column);
    EXPECT_NE(formula_of(column), "");
  }
  EXPECT_TRUE(names.contains("ball_distance"));
  EXPECT_TRUE(names.contains("role=keeper"));
  EXPECT_TRUE(names.contains("pass_gain known"));
}

TEST(Columns, FormulasAreThoseOfTheHeader) {
  const auto formula = [](const char* feature) {
    const Feature features[] = {find_feature(feature)};
    return formula_of(Columns(features).list().front());
  };
  EXPECT_EQ(formula("ball_distance"), "value / (1 m + |value|)");
  EXPECT_EQ(formula("ball_age"), "value / (5 s + |value|)");
  EXPECT_EQ(formula("ball_bearing"), "(value - 0) / 3.15 rad");
  EXPECT_EQ(formula("player"), "(value - 1) / 6");
  EXPECT_EQ(formula("role"), "1 for keeper, otherwise 0");
}

TEST(Columns, AreTheFormulaOfTheFeaturesValue) {
  const Feature features[] = {find_feature("ball_ahead"), find_feature("ball_bearing"), find_feature("player")};
  Scene scene;
  scene.see_ball({3, -3});
  const std::vector<float> row = observed(Columns(features), scene);
  EXPECT_NEAR(row[0], 0.75f, 1e-5f);
  EXPECT_NEAR(row[1], -0.25f * kPi / 3.15f, 1e-5f);
  EXPECT_NEAR(row[2], 1.f / 6, 1e-6f);
}

TEST(Columns, AWordIsOneInOneColumnOnly) {
  const Feature features[] = {find_feature("role")};
  const Columns columns(features);
  ASSERT_EQ(columns.count(), 4);
  Scene scene;
  scene.mind.role = Role::defender;
  EXPECT_EQ(observed(columns, scene), (std::vector<float>{0, 0, 0, 1}));
}

TEST(Columns, AnUnknownValueIsZeroAndSaysSo) {
  const Feature features[] = {find_feature("opponent_distance")};
  const Columns columns(features);
  Scene scene;
  EXPECT_EQ(observed(columns, scene), (std::vector<float>{0, 0}));
  scene.see_opponent(3, {1, 0});
  EXPECT_EQ(observed(columns, scene), (std::vector<float>{0.5f, 1}));
}

TEST(Columns, LateralOnesChangeTheirSignInTheMirror) {
  const Columns columns(built_in_features());
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i) {
    const Scene scene = random_scene(random);
    Scene image = scene;
    image.beliefs = mirrored(scene.beliefs), image.mind = mirrored(scene.mind);
    const auto row = observed(columns, scene), other = observed(columns, image);
    for (std::size_t c = 0; c < row.size(); ++c) {
      const bool turns = info_of(columns.list()[c].feature).lateral && columns.list()[c].form != Form::known;
      ASSERT_EQ(turns ? -row[c] : row[c], other[c]) << name_of(columns.list()[c]) << " in situation " << i;
    }
  }
}

}  // namespace
}  // namespace sim::agent
