#include "sim/learn/knobs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/core/json_library.h"
#include "sim/io/marks.h"
#include "sim/io/source.h"
#include "sim/io/strategy.h"

namespace sim::learn {
namespace {

using io::Json;

constexpr const char* kSmall = R"({
  "name": "small",
  "parameters": {"near": {"value": "0.5 m", "learn": [0.2, 1.5]}, "turn": "20 deg", "aim": "goal"},
  "tree": [
    {"if": "not ball_known", "do": "search_ball"},
    {"name": "close", "if": "ball_distance < $near and not ball_age > 2 s or line_error < 10 deg",
     "do": "kick", "with": {"aim": "$aim", "tolerance": "$turn", "range": "3 m", "frames": "2 decisions"}},
    {"name": "far", "if": "ball_x < -1 and field_length < 8", "do": "walk_to_ball"},
    {"do": "walk_to_ball", "with": {"gain": 0.9}}
  ]
})";

Json small() { return *io::flattened(kSmall, "strategy 'small'"); }

const Knob& knob(const std::vector<Knob>& knobs, const std::string& name) {
  for (const Knob& each : knobs)
    if (each.name == name) return each;
  ADD_FAILURE() << "no knob " << name;
  return knobs.front();
}

TEST(Knobs, AreTheNumbersOfParametersArgumentsAndConditions) {
  const auto knobs = *knobs_of(small());
  std::vector<std::string> names;
  for (const Knob& each : knobs) names.push_back(each.name);
  // no names, no counts, no feature that is the same in the whole game
  EXPECT_EQ(names, (std::vector<std::string>{"near", "turn", "close: ball_age", "close: line_error", "close: range",
                                             "far: ball_x", "walk_to_ball: gain"}));
}

TEST(Knobs, AMarkGivesTheRange) {
  const auto knobs = *knobs_of(small());
  const Knob& near = knob(knobs, "near");
  EXPECT_FLOAT_EQ(near.value, 0.5f);
  EXPECT_FLOAT_EQ(near.least, 0.2f);
  EXPECT_FLOAT_EQ(near.most, 1.5f);
}

TEST(Knobs, WithoutAMarkTheRangeIsAThirdToThreeTimesTheValue) {
  const auto knobs = *knobs_of(small());
  const Knob& range = knob(knobs, "close: range");
  EXPECT_FLOAT_EQ(range.least, 1);
  EXPECT_FLOAT_EQ(range.most, 9);
  // within what the skill allows: the gain is at most 1
  for (const Knob& each : knobs) {
    if (each.place.ends_with("/with/gain")) {
      EXPECT_FLOAT_EQ(each.most, 1);
    }
    EXPECT_LE(each.least, each.value) << each.name;
    EXPECT_GE(each.most, each.value) << each.name;
  }
}

TEST(Knobs, ADistanceWithoutAMarkEndsAtTheField) {
  const auto knobs = *knobs_of(small(), 6);
  EXPECT_FLOAT_EQ(knob(knobs, "close: range").most, 6);
  EXPECT_GE(knob(knobs, "far: ball_x").least, -6);
  EXPECT_LE(knob(knobs, "far: ball_x").most, 6);
  // a mark is the user's word, and a value that lies beyond stays
  EXPECT_FLOAT_EQ(knob(knobs, "near").most, 1.5f);
  EXPECT_FLOAT_EQ(knob(*knobs_of(small(), 2), "close: range").most, 3);
  // other units have no field
  EXPECT_FLOAT_EQ(knob(*knobs_of(small(), 1), "close: ball_age").most, 6);
}

TEST(Knobs, OtherValuesAreReadBackAsTheyWereWritten) {
  const Json strategy = small();
  const auto knobs = *knobs_of(strategy);
  std::vector<float> values;
  for (const Knob& each : knobs) values.push_back(rounded(each, 0.3f * each.least + 0.7f * each.most));
  const Json changed = with_values(strategy, knobs, values);
  ASSERT_TRUE(io::parse_strategy(changed.dump(), "changed"));
  const auto again = *knobs_of(changed);
  ASSERT_EQ(again.size(), knobs.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_NEAR(again[i].value, values[i], 1e-4f * (1 + std::abs(values[i]))) << again[i].name;
    EXPECT_EQ(again[i].place, knobs[i].place);
  }
  EXPECT_EQ(changes(knobs, values).size(), knobs.size());
}

TEST(Knobs, TheSameValuesChangeNothing) {
  const Json strategy = small();
  const auto knobs = *knobs_of(strategy);
  std::vector<float> values;
  for (const Knob& each : knobs) values.push_back(each.value);
  EXPECT_EQ(with_values(strategy, knobs, values), strategy);
  EXPECT_TRUE(changes(knobs, values).empty());
}

TEST(Knobs, AnglesAreWrittenInDegrees) {
  const auto knobs = *knobs_of(small());
  EXPECT_EQ(text_of(knob(knobs, "turn"), 0.5235988f), "30 deg");
  EXPECT_EQ(text_of(knob(knobs, "near"), 0.25f), "0.25 m");
}

TEST(Knobs, AnAngleInAConditionIsWrittenInDegrees) {
  const auto knobs = *knobs_of(small());
  std::vector<float> values;
  for (const Knob& each : knobs) values.push_back(each.value);
  const std::vector<float> before = values;
  for (std::size_t i = 0; i < knobs.size(); ++i)
    if (knobs[i].name == "close: line_error") values[i] = 0.46251225f;
  ASSERT_NE(values, before);
  EXPECT_EQ(with_values(small(), knobs, values)["tree"][1]["if"],
            "ball_distance < $near and not ball_age > 2 s or line_error < 26.5 deg");
}

TEST(Knobs, RoundedValuesHaveFewDigits) {
  const auto knobs = *knobs_of(small());
  // a hundredth of 1.3 m is 0.013 m: steps of 0.01 m
  EXPECT_FLOAT_EQ(rounded(knob(knobs, "near"), 0.4567f), 0.46f);
  EXPECT_FLOAT_EQ(rounded(knob(knobs, "near"), 7), 1.5f);
}

TEST(Knobs, EachEmbeddedStrategyHasKnobsThatCanBeTurned) {
  for (const char* name : {"baseline", "high_line", "passing", "align_first", "all_kicks"}) {
    const auto source = io::find_source("strategies", "strategy", name);
    const auto strategy = io::flattened(source->text, source->called);
    ASSERT_TRUE(strategy) << strategy.error();
    const auto knobs = *knobs_of(*strategy);
    EXPECT_GT(knobs.size(), 20u) << name;
    for (const bool up : {false, true}) {
      std::vector<float> values;
      for (const Knob& each : knobs) values.push_back(rounded(each, up ? each.most : each.least));
      const auto read = io::parse_strategy(with_values(*strategy, knobs, values).dump(), name);
      EXPECT_TRUE(read) << read.error();
    }
  }
}

}  // namespace
}  // namespace sim::learn
