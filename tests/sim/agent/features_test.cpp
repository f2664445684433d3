#include "sim/agent/features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "tests/sim/agent/scene.h"

namespace sim::agent {
namespace {

constexpr float kPostToMiddle = 0.6f;  // [m] from the end of the gap, 0.1 m inside the post, to the goal's middle

/// Equal, or both unknown.
void expect_same(float a, float b, const char* name) {
  if (std::isnan(a) || std::isnan(b))
    EXPECT_TRUE(std::isnan(a) && std::isnan(b)) << name;
  else
    EXPECT_EQ(a, b) << name;
}

TEST(View, TheBallOfASetPlayIsSupposedWhereTheRulesPutItUntilItIsSeenFromNear) {
  const field::Field& field = surroundings().rules->field;
  const float end = 0.5f * field.length, line = 0.5f * field.width;
  Scene scene;
  scene.game.since_phase = 2;
  for (const float y : {0.4f, -0.4f})
    for (const bool own : {true, false}) {
      const float side = y > 0 ? 1.f : -1.f, attacked = own ? 1.f : -1.f;
      scene.game.own_kick = own;
      scene.see_ball({1, y});
      scene.mind.ball = {1, y};
      scene.beliefs.ball.seen = scene.now - ticks(3);
      const auto supposed = [&](Game::SetPlay kind) {
        scene.game.set_play = kind;
        EXPECT_TRUE(scene.view().ball_known);
        return scene.view().ball_in_team;
      };
      const Vec2 corner{attacked * end, side * line};
      EXPECT_EQ(supposed(Game::SetPlay::corner_kick), corner);
      const Vec2 goal_kick{-attacked * (end - field.goal_area_length), 0.5f * side * field.goal_area_width};
      EXPECT_EQ(supposed(Game::SetPlay::goal_kick), goal_kick);
      EXPECT_EQ(supposed(Game::SetPlay::kick_in).y, side * line);
      EXPECT_EQ(supposed(Game::SetPlay::kick_off), Vec2{});
      EXPECT_NEAR(supposed(Game::SetPlay::none).y, y, 0.01f) << "no set play: where it was seen";
      scene.beliefs.ball.seen = scene.now - ticks(1);
      EXPECT_NEAR(supposed(Game::SetPlay::corner_kick).y, y, 0.01f) << "seen since the set play began";
      scene.see_ball({3, -y});
      EXPECT_EQ(supposed(Game::SetPlay::corner_kick).y, -side * line) << "from afar, a sight tells only the side";
    }
}

TEST(Features, AreFoundByTheirUniqueNames) {
  std::set<std::string> names;
  for (int i = 0; i < feature_count(); ++i) {
    const auto feature = static_cast<Feature>(i);
    EXPECT_EQ(find_feature(info_of(feature).name), feature);
    EXPECT_TRUE(names.insert(info_of(feature).name).second) << info_of(feature).name;
    EXPECT_LT(info_of(feature).least, info_of(feature).most);
    EXPECT_NE(std::string(info_of(feature).about), "");
  }
  EXPECT_EQ(find_feature("ball"), kNoFeature);
}

TEST(Features, ValuesDoNotDependOnTheOrderOfQuestions) {
  std::mt19937 random(1);
  for (int n = 0; n < 1000; ++n) {
    const Scene scene = random_scene(random);
    const View forwards = scene.view(), backwards = scene.view();
    for (int i = 0; i < feature_count(); ++i) value_of(static_cast<Feature>(i), forwards);
    for (int i = feature_count(); i-- > 0;) value_of(static_cast<Feature>(i), backwards);
    for (int i = 0; i < feature_count(); ++i) {
      const auto feature = static_cast<Feature>(i);
      const View alone = scene.view();
      expect_same(value_of(feature, forwards), value_of(feature, alone), info_of(feature).name);
      expect_same(value_of(feature, backwards), value_of(feature, alone), info_of(feature).name);
    }
  }
}

TEST(Features, YesOrNoIsOneOrZeroAndNamesAreNumbers) {
  std::mt19937 random(2);
  for (int n = 0; n < 1000; ++n) {
    const Scene scene = random_scene(random);
    const View view = scene.view();
    for (int i = 0; i < feature_count(); ++i) {
      const FeatureInfo& info = info_of(static_cast<Feature>(i));
      const float value = value_of(static_cast<Feature>(i), view);
      if (info.kind == FeatureInfo::Kind::number || std::isnan(value)) continue;
      EXPECT_TRUE(value == std::floor(value) && value >= info.least && value <= info.most) << info.name << " " << value;
    }
  }
}

TEST(Features, OfTheBallAreUnknownWhileTheBallIs) {
  Scene scene;
  scene.beliefs.ball.seen = kNever;
  const View view = scene.view();
  EXPECT_EQ(value_of(find_feature("ball_known"), view), 0);
  for (const Feature feature : {find_feature("ball_distance"), find_feature("ball_x"),
                                find_feature("ball_in_goal_soon"), find_feature("pass_gain"),
                                find_feature("shot_clearance"), find_feature("time_to_ball"), find_feature("aligned")})
    EXPECT_TRUE(std::isnan(value_of(feature, view))) << info_of(feature).name;
}

TEST(Features, OfAKnownBallAreKnownUnlessTheirRowSaysOtherwise) {
  std::mt19937 random(3);
  for (int n = 0; n < 3000; ++n) {
    const Scene scene = random_scene(random);
    const View view = scene.view();
    for (int i = 0; i < feature_count(); ++i) {
      const FeatureInfo& info = info_of(static_cast<Feature>(i));
      if (info.at_times_unknown || (info.needs_ball && !view.ball_known)) continue;
      EXPECT_FALSE(std::isnan(value_of(static_cast<Feature>(i), view))) << info.name;
    }
  }
}

TEST(Features, TheNewestReportGivesTheBallWhenTheOwnSightIsOld) {
  Scene scene;
  scene.hear(3, {2, 1}, 3, Role::chaser, 1).ball = {1.5f, 0.5f};
  scene.beliefs.mates[1].ball_age = 0;
  scene.hear(4, {2, 1}, 3, Role::supporter, 0.5f).ball = {-1, -1};
  scene.beliefs.mates[2].ball_age = 60;
  EXPECT_EQ(scene.view().ball_in_team, (Vec2{1, 0}));
  scene.beliefs.ball.seen = scene.now - ticks(6);
  EXPECT_EQ(scene.view().ball_in_team, (Vec2{1.5f, 0.5f}));
  EXPECT_NEAR(value_of(find_feature("team_ball_age"), scene.view()), 1, 1e-4);
  EXPECT_NEAR(value_of(find_feature("ball_age"), scene.view()), 6, 1e-4);
  scene.beliefs.mates[1].sent = scene.beliefs.mates[2].sent = kNever;
  EXPECT_EQ(scene.view().ball_in_team, (Vec2{1, 0}));
  scene.beliefs.ball.seen = scene.now - ticks(60);
  EXPECT_FALSE(scene.view().ball_known);
}

TEST(Features, AnOpponentInTheMiddleHidesTheMiddleOfTheGoal) {
  Scene scene;
  scene.beliefs.pose.pose.position = {1, 0};
  const float free = value_of(find_feature("goal_opening"), scene.view());
  EXPECT_NEAR(free, 2 * std::atan(kPostToMiddle / 1), 1e-5);
  EXPECT_EQ(value_of(find_feature("shot_clearance"), scene.view()), 10);
  scene.see_opponent(1, {2.5f, 0.2f});
  EXPECT_NEAR(value_of(find_feature("shot_clearance"), scene.view()), 0.2f, 1e-5);
  EXPECT_LT(value_of(find_feature("goal_opening"), scene.view()), free);
  // the right part is the wider one
  const Gap gap = widest_gap(scene.view());
  EXPECT_NEAR(gap.right, -kPostToMiddle, 1e-5);
  EXPECT_LT(gap.left, 0);
}

TEST(Features, GapsAreFreeOfShadowsAndNoneIsWider) {
  std::mt19937 random(3);
  for (int n = 0; n < 2000; ++n) {
    Scene scene = random_scene(random);
    const View view = scene.view();
    if (!view.ball_known || view.ball_in_team.x > 2.5f) continue;
    const Gap gap = widest_gap(view);
    const auto hidden = [&](float y) {
      bool is = false;
      view.for_each_opponent([&](Vec2 opponent) {
        const float ahead = opponent.x - view.ball_in_team.x;
        if (ahead < 0.05f || opponent.x > view.half_length + 0.1f) return;
        const float scale = (view.half_length - view.ball_in_team.x) / ahead;
        is |= std::abs(view.ball_in_team.y + (opponent.y - view.ball_in_team.y) * scale - y) < 0.25f * scale - 1e-4f;
      });
      return is;
    };
    float run = 0, longest = 0;
    for (float y = -kPostToMiddle; y <= kPostToMiddle; y += 0.005f) {
      run = hidden(y) ? 0 : run + 0.005f;
      longest = run > longest ? run : longest;
    }
    EXPECT_NEAR(gap.left - gap.right, longest, 0.011f) << n;
    EXPECT_FALSE(gap.left - gap.right > 0.01f && hidden(0.5f * (gap.left + gap.right)));
  }
}

TEST(Features, ABallThatRollsIntoTheOwnGoalIsSeenComing) {
  Scene scene;
  scene.beliefs.pose.pose.position = {-2.5f, 0};
  scene.see_ball({1.5f, 0});
  EXPECT_EQ(value_of(find_feature("ball_in_goal_soon"), scene.view()), 0);
  scene.beliefs.ball.velocity = {-1.5f, 0.2f};
  EXPECT_EQ(value_of(find_feature("ball_in_goal_soon"), scene.view()), 1);
  EXPECT_NEAR(value_of(find_feature("crossing_left"), scene.view()), 0.2f, 1e-5);
  EXPECT_GT(value_of(find_feature("crossing_time"), scene.view()), 1);
  // a ball that seems a little too slow, or passes just beside the post, counts: beliefs lag behind a kick
  scene.beliefs.ball.velocity = {-1, 0.2f};
  EXPECT_EQ(value_of(find_feature("ball_in_goal_soon"), scene.view()), 1);
  // far too slow to get there, and far past the post
  scene.beliefs.ball.velocity = {-0.5f, 0};
  EXPECT_EQ(value_of(find_feature("ball_in_goal_soon"), scene.view()), 0);
  scene.beliefs.ball.velocity = {-1.5f, 1.2f};
  EXPECT_EQ(value_of(find_feature("ball_in_goal_soon"), scene.view()), 0);
}

TEST(Features, APassGoesToTheFreeMateNearestToTheGoal) {
  Scene scene;
  EXPECT_TRUE(std::isnan(value_of(find_feature("pass_gain"), scene.view())));
  scene.hear(3, {2, 1}, 5, Role::supporter);
  scene.hear(4, {2.2f, -1}, 5, Role::supporter);
  const float far = 2, near = length(Vec2{0.8f, 1});
  EXPECT_NEAR(value_of(find_feature("pass_gain"), scene.view()), far - near, 1e-5);
  scene.see_opponent(1, {1.5f, -0.5f});
  EXPECT_NEAR(value_of(find_feature("pass_gain"), scene.view()), far - length(Vec2{1, 1}), 1e-5);
}

}  // namespace
}  // namespace sim::agent
