#include "sim/contest/conditions.h"

#include <gtest/gtest.h>

#include <set>

#include "sim/io/matchup.h"

namespace sim::contest {
namespace {

/// The figures that conditions may scale, of one side.
struct Figures {
  std::vector<float> walk, kick, noise;

  explicit Figures(const Params& params, Side side) {
    const Models& models = params.teams[static_cast<int>(side)].models;
    const auto& speeds = models.motion.walk;
    walk = {speeds.forward, speeds.backward, speeds.sideward, speeds.turn_rate};
    for (int i = 0; i < models.motion.kick_count; ++i) kick.push_back(models.motion.kicks[i].range);
    const perception::Noise& errors = models.perception.noise;
    noise = {errors.pixels, errors.tilt, errors.tilt_walking, errors.roll};
  }
};

void expect_scaled(const std::vector<float>& before, const std::vector<float>& after, float factor) {
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_FLOAT_EQ(after[i], factor * before[i]);
}

TEST(Conditions, ScaleTheFiguresThatTheyName) {
  const io::PreparedGame game = io::prepare({}).value();
  std::vector<Conditions> all = robust_conditions(true);
  all.push_back({});
  for (const Side opponent : {Side::home, Side::away})
    for (const Conditions& conditions : all) {
      Params params = game.params;
      put_upon(conditions, &opponent, params);
      for (const Side side : {Side::home, Side::away}) {
        SCOPED_TRACE(conditions.name);
        const float pace = side == opponent ? conditions.opponent_pace : 1;
        const Figures before(game.params, side), after(params, side);
        expect_scaled(before.walk, after.walk, conditions.walk * pace);
        expect_scaled(before.kick, after.kick, conditions.kick * pace);
        expect_scaled(before.noise, after.noise, conditions.ball_noise);
      }
    }
}

TEST(Conditions, OfAThirdBehaviourNeedAThirdBehaviour) {
  std::set<std::string> names;
  for (const Conditions& conditions : robust_conditions(false)) {
    EXPECT_EQ(conditions.opponent_pace, 1) << conditions.name;
    names.insert(conditions.name);
  }
  EXPECT_EQ(names.size(), robust_conditions(false).size()) << "each has its own name";
  EXPECT_EQ(robust_conditions(true).size(), names.size() + 2);
}

}  // namespace
}  // namespace sim::contest
