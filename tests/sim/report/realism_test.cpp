#include "sim/report/realism.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robot/core/json_library.h"

namespace sim::report {
namespace {

io::RealGames real() { return io::load_real_games(io::kNewestRealGames).value(); }

const RealismRow& row_of(const Realism& realism, const std::string& key) {
  return *std::ranges::find(realism.rows, key, [](const RealismRow& row) { return row.real.key; });
}

/// Two windows, and one in which nobody kicked.
Realism three_windows() {
  statistics::Figures first, second, quiet;
  first.kicks = 5, second.kicks = 7;
  first.close = second.close = 0.3;
  first.nearest = 0.4, quiet.standing = 0.5;
  return realism_of({first, second, quiet}, real(), "simulated");
}

TEST(Realism, MeansAreThoseOfTheWindowsThatHaveTheFigure) {
  const Realism realism = three_windows();
  EXPECT_EQ(realism.windows, 3u);
  const RealismRow& kicks = row_of(realism, "kicks");
  EXPECT_EQ(kicks.windows, 2u);
  EXPECT_DOUBLE_EQ(kicks.measured.mean, 6);
  EXPECT_DOUBLE_EQ(kicks.measured.error, 1);
  EXPECT_EQ(row_of(realism, "falls").windows, 0u);
}

TEST(Realism, AFigureIsInsideIfItsMeanLiesInTheRealInterval) {
  const Realism realism = three_windows();
  EXPECT_EQ(row_of(realism, "kicks").inside, true);
  EXPECT_EQ(row_of(realism, "close").inside, false);
  EXPECT_EQ(row_of(realism, "standing").inside, true);
  EXPECT_EQ(row_of(realism, "falls").inside, std::nullopt);
  EXPECT_EQ(realism.inside(), 2u);
  EXPECT_EQ(realism.judged(), 3u);
}

TEST(Realism, RealMeansThemselvesAreInside) {
  const io::RealGames games = real();
  statistics::Figures means;
  std::size_t next = 0;
  statistics::Figures::visit(
      means, [&](const char*, double& value, const char*, const char*) { value = games.figures[next++].mean; });
  const Realism realism = realism_of({means}, games, "recorded");
  EXPECT_EQ(realism.inside(), realism.judged());
  EXPECT_GT(realism.judged(), 15u);
}

TEST(Realism, TheTableHasALineForEachFigure) {
  const std::string text = to_text(three_windows());
  EXPECT_EQ(std::ranges::count(text, '\n'), static_cast<std::ptrdiff_t>(real().figures.size()) + 3);
  EXPECT_NE(text.find("kicks above 0.5 m/s [1/min]"), text.npos);
  EXPECT_NE(text.find("6.00 ± 1.00"), text.npos);
  EXPECT_NE(text.find("2 of 3 figures lie inside the interval of real games (robocup2019); 3 windows"), text.npos);
}

TEST(Realism, TheJsonHasTheFiguresOfTheTable) {
  const Json json = to_json(three_windows());
  EXPECT_EQ(json["windows"], 3);
  EXPECT_EQ(json["inside"], 2);
  EXPECT_EQ(json["judged"], 3);
  EXPECT_EQ(json["figures"]["kicks"]["measured"]["mean"], 6);
  EXPECT_EQ(json["figures"]["kicks"]["real"]["low"], 3.3);
  EXPECT_EQ(json["figures"]["kicks"]["inside"], true);
  EXPECT_TRUE(json["figures"]["falls"]["measured"]["mean"].is_null());
  EXPECT_TRUE(json["figures"]["falls"]["inside"].is_null());
}

TEST(Realism, ThePageHasARowForEachFigureAndEscapesItsTexts) {
  const std::string page = page_of(three_windows(), "games of <b>mine</b>");
  std::size_t rows = 0;
  for (std::size_t at = page.find("<svg"); at != page.npos; at = page.find("<svg", at + 1)) ++rows;
  EXPECT_EQ(rows, real().figures.size());
  EXPECT_NE(page.find("2 of 3 figures lie inside"), page.npos);
  EXPECT_NE(page.find("data-of=\"kicks\">6 ± 1<"), page.npos);
  EXPECT_NE(page.find("games of &lt;b&gt;mine"), page.npos);
  EXPECT_EQ(page.find("<b>"), page.npos);
  EXPECT_EQ(page.find("<script"), page.npos);
}

}  // namespace
}  // namespace sim::report
