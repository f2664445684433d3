#include "sim/io/reader.h"
#include "robot/core/json_library.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

namespace sim::io {
namespace {

struct Wheels {
  float speed = 1;
  int count = 4;
  bool spinning = false;

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("speed", self.speed, "m/s", 0.01f, 3.f);
    see("count", self.count, "", 1, 7);
    see("spinning", self.spinning, "", false, true);
  }
};

/// Returns the error in `text` as wheels, or an empty text.
std::string wrong_with(std::string_view text, Fields fields = Fields::some) {
  const auto json = parse_object(text, "car 'red'");
  if (!json) return json.error();
  Reader reader("car 'red'");
  Wheels wheels;
  reader.read(*json, "wheels", fields, wheels);
  return reader.good() ? "" : reader.error().sentence;
}

Wheels read(std::string_view text) {
  Reader reader("car");
  Wheels wheels;
  reader.read(parse_object(text, "car").value(), "", Fields::some, wheels);
  EXPECT_TRUE(reader.good());
  return wheels;
}

TEST(Reader, TakesPlainValuesAndThoseWithUnitAndSource) {
  const Wheels plain = read(R"({"speed": 2.5, "count": 3, "spinning": true})");
  const Wheels told = read(R"({"speed": {"value": 2.5, "unit": "m/s", "source": "us"}, "count": {"value": 3},
                               "spinning": {"value": true, "unit": ""}})");
  for (const Wheels& wheels : {plain, told}) {
    EXPECT_EQ(wheels.speed, 2.5f);
    EXPECT_EQ(wheels.count, 3);
    EXPECT_TRUE(wheels.spinning);
  }
}

TEST(Reader, WrittenLimitsBelongToTheRange) {
  EXPECT_EQ(wrong_with(R"({"speed": 0.01})"), "");
  EXPECT_EQ(wrong_with(R"({"speed": 3})"), "");
  EXPECT_EQ(wrong_with(R"({"count": 7})"), "");
}

TEST(Reader, NamesTheErrorInAValue) {
  EXPECT_EQ(wrong_with(R"({"speed": 9})"), "car 'red': wheels.speed must be 0.01 .. 3 [m/s], got 9");
  EXPECT_EQ(wrong_with(R"({"speed": 1e300})"), "car 'red': wheels.speed must be 0.01 .. 3 [m/s], got 1e+300");
  EXPECT_EQ(wrong_with(R"({"speed": -1e300})"), "car 'red': wheels.speed must be 0.01 .. 3 [m/s], got -1e+300");
  EXPECT_EQ(wrong_with(R"({"speed": "fast"})"), "car 'red': wheels.speed must be 0.01 .. 3 [m/s], got \"fast\"");
  EXPECT_EQ(wrong_with(R"({"count": 8})"), "car 'red': wheels.count must be a whole number, 1 .. 7, got 8");
  EXPECT_EQ(wrong_with(R"({"count": 2.5})"), "car 'red': wheels.count must be a whole number, 1 .. 7, got 2.5");
  EXPECT_EQ(wrong_with(R"({"count": 18446744073709551615})"),
            "car 'red': wheels.count must be a whole number, 1 .. 7, got 18446744073709551615");
  EXPECT_EQ(wrong_with(R"({"spinning": 1})"), "car 'red': wheels.spinning must be true or false, got 1");
  EXPECT_EQ(wrong_with(R"({"speed": {"value": 0}})", Fields::some).substr(0, 30), "car 'red': wheels.speed must h");
}

TEST(Reader, NamesTheErrorInAnEntry) {
  EXPECT_EQ(wrong_with(R"({"speed": {"value": 1, "unit": "km/h"}})"),
            "car 'red': wheels.speed must have the unit 'm/s', got \"km/h\"");
  EXPECT_EQ(wrong_with(R"({"speed": {"value": 1}})"), "car 'red': wheels.speed must have the unit 'm/s', got none");
  EXPECT_EQ(wrong_with(R"({"speed": {"unit": "m/s"}})"), "car 'red': wheels.speed has no value");
  EXPECT_EQ(wrong_with(R"({"speed": {"value": 1, "unit": "m/s", "sauce": 1}})"),
            "car 'red': wheels.speed.sauce is unknown; did you mean 'source'?");
  EXPECT_EQ(wrong_with(R"({"speed": {"value": 1, "unit": "m/s", "source": 1}})"),
            "car 'red': wheels.speed.source must be a text, got 1");
}

TEST(Reader, NamesMissingAndUnknownEntries) {
  EXPECT_EQ(wrong_with(R"({"speed": 1, "spinning": false})", Fields::all),
            "car 'red': wheels.count is missing, expected 1 .. 7");
  EXPECT_EQ(wrong_with(R"({"speeds": 1})"), "car 'red': wheels.speeds is unknown; did you mean 'speed'?");
  EXPECT_EQ(wrong_with(R"({"wide": 1})"), "car 'red': wheels.wide is unknown; there are: speed, count, spinning");
}

TEST(Reader, RefusesTextThatIsNoDescription) {
  EXPECT_EQ(wrong_with("[1]"), "car 'red': expected a JSON object, got [1]");
  EXPECT_EQ(wrong_with(R"({"speed": 1, "speed": 2})"), "car 'red': 'speed' stands twice in one object");
  EXPECT_EQ(wrong_with("").substr(0, 21), "car 'red': not JSON: ");
  EXPECT_EQ(wrong_with(R"({"a": 1e999})").substr(0, 21), "car 'red': not JSON: ");
  std::string deep = R"({"a": )";
  deep.append(100, '[').append(100, ']').append("}");
  EXPECT_EQ(wrong_with(deep), "car 'red': nested deeper than 64");
}

TEST(Json, ShortNumbersReadBackAsTheSameFloat) {
  std::mt19937 random(1);
  for (int i = 0; i < 100000; ++i) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(value)) continue;
    const Json back = Json::parse(Json(short_number(value)).dump());
    EXPECT_EQ(static_cast<float>(back.get<double>()), value);
  }
  EXPECT_EQ(Json(short_number(0.1f)).dump(), "0.1");
}

}  // namespace
}  // namespace sim::io
