#include "sim/io/real_games.h"

#include <gtest/gtest.h>

#include "robot/core/json_library.h"
#include "sim/io/embedded.h"
#include "sim/io/json.h"
#include "sim/io/source.h"

namespace sim::io {
namespace {

Json described() { return Json::parse(find_source("games", "real games", kNewestRealGames).value().text); }

std::string error_of(const Json& json) {
  const auto games = parse_real_games(json.dump(), "real games 'mine'");
  return games ? "" : games.error();
}

TEST(RealGames, HasAllFiguresInTheirOrder) {
  const auto games = load_real_games(kNewestRealGames);
  ASSERT_TRUE(games) << games.error();
  std::size_t at = 0;
  const statistics::Figures none;
  statistics::Figures::visit(none, [&](const char* key, double, const char* unit, const char* about) {
    ASSERT_LT(at, games->figures.size());
    EXPECT_EQ(games->figures[at].key, key);
    EXPECT_EQ(games->figures[at].unit, unit);
    EXPECT_EQ(games->figures[at].about, about);
    ++at;
  });
  EXPECT_EQ(at, games->figures.size());
}

TEST(RealGames, EachFigureHasASource) {
  const RealGames games = load_real_games(kNewestRealGames).value();
  for (const RealFigure& figure : games.figures) EXPECT_FALSE(figure.source.empty()) << figure.key;
}

TEST(RealGames, HoldsTheMeasuredInterval) {
  const RealGames games = load_real_games(kNewestRealGames).value();
  EXPECT_EQ(games.figures.front().mean, 5.1);
  ASSERT_TRUE(games.figures.front().interval);
  EXPECT_EQ(games.figures.front().interval->low, 3.3);
  EXPECT_EQ(games.figures.front().interval->high, 6.8);
}

TEST(RealGames, ATruncationIsAnError) {
  const std::string text = described().dump();
  for (std::size_t size = 0; size < text.size(); size += 41)
    EXPECT_FALSE(parse_real_games(std::string_view(text).substr(0, size), "real games 'mine'"));
}

TEST(RealGames, NamesTheError) {
  EXPECT_EQ(load_real_games("robocup1066").error(), "no real games 'robocup1066'; did you mean 'robocup2019'?");
  Json json = described();
  json["figures"].erase("kicks");
  EXPECT_EQ(error_of(json), "real games 'mine': kicks is missing");

  json = described();
  json["figures"]["headers"] = {{"mean", 1}};
  EXPECT_TRUE(
      error_of(json).starts_with("real games 'mine': figures.headers is unknown; there are: kicks, fast_kicks,"));

  json = described();
  json["figures"]["kicks"]["unit"] = "1/s";
  EXPECT_EQ(error_of(json), R"(real games 'mine': figures.kicks.unit must be "1/min", got "1/s")");

  json = described();
  json["figures"]["kicks"]["mean"] = "many";
  EXPECT_EQ(error_of(json), R"(real games 'mine': figures.kicks.mean must be a number, got "many")");

  json = described();
  json["figures"]["kicks"].erase("high");
  EXPECT_EQ(error_of(json), "real games 'mine': figures.kicks must have both low and high, or neither");

  json = described();
  json["figures"]["kicks"] = {{"mean", 9}, {"low", 1}, {"high", 2}, {"unit", "1/min"}};
  EXPECT_EQ(
      error_of(json),
      R"(real games 'mine': figures.kicks: expected low <= mean <= high, got {"mean":9,"low":1,"high":2,"unit":"1/min…)");
}

}  // namespace
}  // namespace sim::io
