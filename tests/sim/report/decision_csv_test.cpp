#include "sim/report/decision_csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/core/text.h"
#include "sim/debug/setup.h"
#include "tests/sim/support/games.h"

namespace sim::report {
namespace {

/// Splits a line at the commas outside of quotes.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"')
      is_quoted = !is_quoted;
    else if (c == ',' && !is_quoted)
      fields.emplace_back();
    else if (c != '\n')
      fields.back() += c;
  }
  return fields;
}

TEST(DecisionCsv, EachLineHoldsTheSkillAndEveryComparedValue) {
  const debug::SharedSetup setup = debug::prepare({}).value();
  const agent::TreeBehaviour& behaviour = *debug::tree_of(setup->params, 2);
  const agent::Tree& tree = behaviour.tree();
  const std::vector<std::string> head = fields_of(csv_head(tree));
  const auto column_of = [&](const std::string& name) {
    const auto found = std::ranges::find_if(
        head, [&](const std::string& column) { return column == name || column.starts_with(name + " ["); });
    EXPECT_NE(found, head.end()) << name;
    return static_cast<std::size_t>(found - head.begin());
  };
  int in_play = 0, outside = 0;
  debug::for_each_decision(
      setup->params, test::begun(setup->params, 5), 2, behaviour, ticks(90),
      [&](const debug::LoggedDecision& logged, const State& state) {
        const std::vector<std::string> fields = fields_of(csv_row(tree, logged));
        ASSERT_EQ(fields.size(), head.size());
        EXPECT_NEAR(std::stod(fields[0]), static_cast<double>(state.world.tick) / 30, 1e-4);
        EXPECT_EQ(fields[column_of("skill")], logged.skill);
        if (!logged.evaluation) {
          ++outside;
          EXPECT_EQ(std::count(fields.begin() + 3, fields.end(), ""), static_cast<long>(fields.size() - 3));
          return;
        }
        ++in_play;
        EXPECT_EQ(fields[column_of("leaf")], tree.leaf_words[logged.evaluation->leaf].path);
        const float distance = logged.values[debug::index_of(agent::find_feature("ball_distance"))];
        const std::string& told = fields[column_of("ball_distance")];
        if (std::isnan(distance))
          EXPECT_EQ(told, "");
        else
          EXPECT_EQ(std::stof(told), distance) << "nine digits give a float back";
      });
  EXPECT_GT(in_play, 100);
  EXPECT_GT(outside, 50);
}

}  // namespace
}  // namespace sim::report
