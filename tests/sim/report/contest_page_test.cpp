#include "sim/report/contest_page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string_view>

#include "robot/core/json_library.h"
#include "sim/report/contest_report.h"
#include "sim/report/page.h"
#include "sim/report/plot.h"

namespace sim::report {
namespace {

/// The report of a short contest, as `compare --json` prints it.
const Json& short_report() {
  static const Json made = [] {
    const auto comparison = contest::Comparison::prepare(
        {.a = "baseline", .b = "kick_now", .players = 2, .seconds = 20, .metric = contest::Metric::ball_advance});
    EXPECT_TRUE(comparison) << comparison.error();
    const contest::ContestOptions options{.question = {}, .pairs = contest::RunFolder::kPairsPerBlock};
    const auto outcome = contest::play_contest(*comparison, options, nullptr, {});
    EXPECT_TRUE(outcome) << outcome.error();
    return to_whole_json({*comparison, options, *outcome});
  }();
  return made;
}

/// Returns the first fault of a page's tags, or an empty string: each opened tag is closed, in order.
std::string fault_of(std::string_view page) {
  static const std::set<std::string_view> kVoid = {"!doctype", "meta", "br"};
  std::vector<std::string_view> open;
  for (std::size_t at = page.find('<'); at != page.npos; at = page.find('<', at + 1)) {
    const std::size_t end = page.find('>', at);
    if (end == page.npos) return "a tag without an end at " + std::to_string(at);
    const std::string_view tag = page.substr(at + 1, end - at - 1);
    if (tag.find('<') != tag.npos) return "a tag within the tag " + std::string(tag);
    if (tag.ends_with('/')) continue;
    const bool closes = tag.starts_with('/');
    const std::string_view name = tag.substr(closes ? 1 : 0, tag.find_first_of(" \n") - (closes ? 1 : 0));
    if (kVoid.contains(name)) continue;
    if (!closes) {
      open.push_back(name);
    } else if (open.empty() || open.back() != tag.substr(1)) {
      return "closes " + std::string(tag) + " within " + std::string(open.empty() ? "nothing" : open.back());
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "never closes " + std::string(open.back());
}

TEST(ContestPage, IsWellFormed) { EXPECT_EQ(fault_of(page_of(short_report())), ""); }

TEST(ContestPage, LinksToTheGamesThatLieBesideIt) {
  Json report = short_report();
  report["decisive"] = Json::array();
  for (int i = 1; i <= 7; ++i)
    report["decisive"].push_back({{"pair", i}, {"gain", i % 2 ? i : -i}, {"replay", "foresight-sim match --seed 7"}});
  EXPECT_EQ(page_of(report).find("<a "), std::string::npos);
  const std::vector<Json*> pairs = shown_pairs(report);
  ASSERT_EQ(pairs.size(), 5u);
  for (std::size_t i = 1; i < pairs.size(); ++i)
    EXPECT_GE(std::abs(pairs[i - 1]->at("gain").get<double>()), std::abs(pairs[i]->at("gain").get<double>()));
  for (Json* pair : pairs) (*pair)["game"] = "seed-<" + pair->at("pair").dump() + ">.mcap";
  const std::string page = page_of(report);
  EXPECT_EQ(fault_of(page), "");
  for (const Json* pair : pairs) {
    const std::string name = "seed-&lt;" + pair->at("pair").dump() + "&gt;.mcap";
    EXPECT_NE(page.find("<a href=\"" + name + "\">" + name + "</a>"), std::string::npos) << name;
    EXPECT_NE(page.find("foresight-lab play " + name), std::string::npos) << name;
  }
}

TEST(ContestPage, EscapesTheNamesOfBehaviours) {
  Json report = short_report();
  const std::string name = "<script>alert(\"&\")</script>";
  report["run"]["a"] = report["run"]["vs"] = report["run"]["situation"] = name;
  report["sentence"] = name + " is better: by far";
  for (Json& pair : report["decisive"]) pair["replay"] = "foresight-sim match --away '" + name + "'";
  const std::string page = page_of(report);
  EXPECT_EQ(fault_of(page), "");
  EXPECT_EQ(page.find("<script"), page.npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(&quot;&amp;&quot;)&lt;/script&gt;"), page.npos);
}

TEST(ContestPage, SaysThatAWorseBehaviourIsWorse) {
  Json report = short_report();
  report["verdict"] = "not better";
  report["worse"] = true;
  EXPECT_NE(page_of(report).find("<span class=\"chip not-better\">worse</span>"), std::string::npos);
  report["worse"] = false;
  EXPECT_NE(page_of(report).find("<span class=\"chip not-better\">not better</span>"), std::string::npos);
}

// the curve of a run of fixed length once ended at -8.6 while the text said -15.1
TEST(ContestPage, CurveOfTheTestReachesItsFigure) {
  Json report = short_report();
  report["marks"] = {{25, -0.5, -12.0, -0.6, -0.4}, {50, -0.5, -15.1, -0.6, -0.4}};
  const std::string page = page_of(report);
  const std::size_t from = page.find("<polyline class=\"path\" points=\"");
  ASSERT_NE(from, page.npos);
  const std::string points = page.substr(from, page.find("\"/>", from) - from);
  const std::size_t last = points.rfind(','), before = points.rfind(',', last - 1);
  EXPECT_GT(std::stod(points.substr(last + 1)), std::stod(points.substr(before + 1)) + 1) << points;
}

TEST(ContestPage, SaysHowManyGamesPairsSave) {
  Json report = short_report();
  report["pairing_gain"] = 0.93;
  EXPECT_NE(page_of(report).find("7 % fewer games without pairs"), std::string::npos);
  report["pairing_gain"] = 1.4;
  EXPECT_NE(page_of(report).find("40 % more games without pairs"), std::string::npos);
}

TEST(ContestPage, NeedsNothingFromElsewhere) {
  const std::string page = page_of(short_report());
  for (const char* word : {"http:", "https:", "src=", "<link", "@import", "url("})
    EXPECT_EQ(page.find(word), page.npos) << word;
}

TEST(ContestReport, SumsAddUp) {
  const Json& report = short_report();
  EXPECT_EQ(report["pairs"], contest::RunFolder::kPairsPerBlock);
  EXPECT_EQ(report["games"], 2 * contest::RunFolder::kPairsPerBlock);
  std::int64_t games = 0, pairs = 0, columns = 0;
  for (const Json& count : report["b_won_drawn_lost"]) games += count.get<std::int64_t>();
  for (const Json& count : report["b_points_of_pairs"]) pairs += count.get<std::int64_t>();
  for (const Json& count : report["histogram"]["pairs"]) columns += count.get<std::int64_t>();
  EXPECT_EQ(games, report["games"]);
  EXPECT_EQ(pairs, report["pairs"]);
  EXPECT_EQ(columns, report["pairs"]);
  EXPECT_EQ(report["a"]["goals"], report["b"]["conceded"]) << "they play against each other";
}

TEST(Plot, EscapesText) { EXPECT_EQ(escaped("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;"); }

TEST(Plot, IsWellFormedForAnyRange) {
  for (const double top : {0., 1., 1e6, 1e-6}) {
    Plot plot(0, top, 0, top);
    plot.line("path", {{0, 0}, {top, top}});
    plot.level("zero", 0, "<none>");
    plot.bar("for-b", 0, top, top, "<title>");
    EXPECT_EQ(fault_of(plot.svg("a <picture>", "x > 0")), "") << top;
  }
}

}  // namespace
}  // namespace sim::report
