#include "robot/core/json.h"
#include "robot/core/json_library.h"

#include <gtest/gtest.h>

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

TEST(Json, ManyListsBesideEachOtherAreNotDeep) {
  std::string text = "[";
  for (int i = 0; i < 1000; ++i) text += "[{}],";
  EXPECT_TRUE(parse_json(text + "[]]"));
}

}  // namespace
}  // namespace robot
