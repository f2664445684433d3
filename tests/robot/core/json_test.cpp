#include "robot/core/json.h"
#include "robot/core/json_library.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace robot {
namespace {

std::string nested(int depth, const std::string& opening, const std::string& closing) {
  std::string text;
  for (int i = 0; i < depth; ++i) text += opening;
  text += "1";
  for (int i = 0; i < depth; ++i) text += closing;
  return text;
}

TEST(Json, IsTheValueThatTheTextDescribes) {
  EXPECT_EQ(*parse_json(R"({"a": [1, "x"], "b": null})"),
            (nlohmann::json{{"a", nlohmann::json::array({1, "x"})}, {"b", nullptr}}));
  for (const char* none : {"", "[", "nonsense", "{\"a\":}", "[1] 2", "\"", "\"\\"})
    EXPECT_EQ(parse_json(none).error(), "expected JSON, got something else") << none;
}

TEST(Json, IsNestedAtMostAsDeepAsTheLimit) {
  EXPECT_TRUE(parse_json(nested(kDeepestJson, "[", "]")));
  EXPECT_TRUE(parse_json(nested(kDeepestJson, "{\"a\":", "}")));
  const std::string sentence = "expected JSON nested at most 64 deep, got deeper nesting";
  EXPECT_EQ(parse_json(nested(kDeepestJson + 1, "[", "]")).error(), sentence);
  EXPECT_EQ(parse_json(nested(kDeepestJson + 1, "{\"a\":", "}")).error(), sentence);
  EXPECT_EQ(parse_json(nested(1'000'000, "[", "]")).error(), sentence);
  EXPECT_EQ(parse_json(std::string(1'000'000, '[')).error(), sentence);
}

TEST(Json, BracketsInsideTextsDoNotCount) {
  EXPECT_TRUE(parse_json('"' + std::string(1000, '[') + '"'));
  EXPECT_TRUE(parse_json(R"({"\"[": "\\", "x": ")" + std::string(1000, '{') + "\"}"));
  EXPECT_FALSE(parse_json(R"(["\\", )" + nested(kDeepestJson, "[", "]") + "]"));
}

TEST(Json, AWholeNumberMayBeSpelledInAnyWay) {
  for (const char* one : {"1", "1.0", "1e0", "10e-1", "0.1e1"}) EXPECT_EQ(whole_number(*parse_json(one)), 1) << one;
  EXPECT_EQ(whole_number(*parse_json("-2.0")), -2);
  EXPECT_EQ(whole_number(*parse_json("9223372036854775807")), INT64_MAX);
  EXPECT_EQ(whole_number(*parse_json("9007199254740992.0")), 9007199254740992);
  for (const char* none : {"1.5", "\"1\"", "true", "null", "[1]", "{}", "9223372036854775808", "1e17", "-1e300"})
    EXPECT_EQ(whole_number(*parse_json(none)), std::nullopt) << none;
  EXPECT_EQ(whole_number(nlohmann::json(std::nan(""))), std::nullopt);
  EXPECT_EQ(whole_number(nlohmann::json(INFINITY)), std::nullopt);
  EXPECT_FALSE(parse_json("NaN"));
}

TEST(Json, ANumberInATextKeeps64Bits) {
  const nlohmann::json object = {{"most", "18446744073709551615"},
                                 {"least", "-9223372036854775808"},
                                 {"bare", 1},
                                 {"empty", ""},
                                 {"rest", "1 "},
                                 {"real", "1.0"}};
  EXPECT_EQ(number_in_text<std::uint64_t>(object, "most"), UINT64_MAX);
  EXPECT_EQ(number_in_text<std::int64_t>(object, "least"), INT64_MIN);
  EXPECT_EQ(number_in_text<std::int64_t>(object, "most"), std::nullopt);
  for (const char* none : {"least", "bare", "empty", "rest", "real", "absent"})
    EXPECT_EQ(number_in_text<std::uint64_t>(object, none), std::nullopt) << none;
}

TEST(Json, AValueInASentenceIsShortAscii) {
  EXPECT_EQ(shown({{"x", 1.5}}), R"({"x":1.5})");
  EXPECT_EQ(shown("ü"), R"("\u00fc")");
  EXPECT_EQ(shown("\xff"), R"("\ufffd")");
  EXPECT_EQ(shown(std::string(58, 'a')), '"' + std::string(58, 'a') + '"');
  EXPECT_EQ(shown(std::string(59, 'a')), '"' + std::string(59, 'a') + "…");
  EXPECT_EQ(shown("abcdef", 4), "\"abc…");
}

TEST(Json, ManyListsBesideEachOtherAreNotDeep) {
  std::string text = "[";
  for (int i = 0; i < 1000; ++i) text += "[{}],";
  EXPECT_TRUE(parse_json(text + "[]]"));
}

}  // namespace
}  // namespace robot
