#include "sim/report/game_report.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robot/core/json_library.h"
#include "sim/report/game_line.h"

namespace sim::report {
namespace {

/// A game of two short halves and its events.
GameReport short_game(const Params& params, std::uint64_t seed) {
  GameReport report{.seed = seed};
  referee::Events opening;
  State state = begin(params, {.seed = seed}, opening);
  play(
      params, state, [](const State&) { return false; },
      [&](const referee::Event& event) {
        report.decisions.push_back({.event = event,
                                    .half = state.book.half,
                                    .clock = static_cast<float>(state.book.clock) * kTickDuration,
                                    .score = {state.book.score[0], state.book.score[1]}});
      });
  report.result = result_of(state);
  return report;
}

const io::PreparedGame& game() {
  static const io::PreparedGame made = [] {
    io::PreparedGame prepared = io::prepare({}).value();
    prepared.params.rules.half_duration = 240;
    return prepared;
  }();
  return made;
}

TEST(GameReport, TheScoreIsTheNumberOfEventsOfKindGoal) {
  int goals_of_all = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Json json = to_json(short_game(game().params, seed), game().params.rules.players);
    for (const int side : {0, 1}) {
      const std::string name = side == 0 ? "home" : "away";
      const auto goals = std::ranges::count_if(json["events"], [&](const Json& event) {
        return event["kind"] == "goal" && event["who"].get<std::string>().starts_with(name);
      });
      EXPECT_EQ(json["score"][static_cast<std::size_t>(side)], goals) << "seed " << seed << ", " << name;
      EXPECT_EQ(json[name]["goals"], goals);
      goals_of_all += static_cast<int>(goals);
    }
    EXPECT_EQ(json["finished"], true);
    EXPECT_LE(json["home"]["possession"].get<double>() + json["away"]["possession"].get<double>(), 1.0001);
    EXPECT_LE(json["in_play_seconds"], json["seconds"]);
    EXPECT_TRUE(
        std::ranges::is_sorted(json["events"], {}, [](const Json& event) { return event["tick"].get<Tick>(); }));
  }
  EXPECT_GT(goals_of_all, 0) << "these games are to have goals";
}

TEST(GameReport, TellsThePenaltyShootOut) {
  GameReport report{.seed = 1};
  report.shoot_out = ShootOut{.tally = {.first = Side::away, .shots = {1, 1}, .goals = {1, 0}},
                              .shots = {{.side = Side::away, .end = PenaltyShot::End::out, .ticks = ticks(6)},
                                        {.side = Side::home, .end = PenaltyShot::End::goal, .ticks = ticks(9)}}};
  const Json json = to_json(report, game().params.rules.players)["shoot_out"];
  EXPECT_EQ(json["score"], Json({1, 0}));
  EXPECT_EQ(json["winner"], "home");
  EXPECT_EQ(json["shots"][0], Json({{"side", "away"}, {"end", "out"}, {"seconds", 6}}));
  const std::string text = to_text(report, {}, game().params);
  EXPECT_NE(text.find("penalty shoot-out 1:0, home wins\n  away  out       6.0 s\n  home  goal      9.0 s\n"),
            std::string::npos)
      << text;
  EXPECT_NE(to_text(std::vector{report, GameReport{}}, {}, game().params).find("1 penalty shoot-outs: home won 1,"),
            std::string::npos);
  EXPECT_FALSE(to_json(GameReport{}, game().params.rules.players).contains("shoot_out"));
}

TEST(GameReport, MeansOfManyGamesAreTheMeansOfTheirReports) {
  std::vector<GameReport> reports;
  double goals = 0, kicks = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    reports.push_back(short_game(game().params, seed));
    const Json json = to_json(reports.back(), game().params.rules.players);
    goals += json["home"]["goals"].get<double>() / 3;
    kicks += json["away"]["kicks"].get<double>() / 3;
  }
  const Json json = to_json(reports, game().params.rules.players);
  EXPECT_EQ(json["games"], 3);
  EXPECT_DOUBLE_EQ(json["means"]["home"]["goals"]["mean"].get<double>(), goals);
  EXPECT_DOUBLE_EQ(json["means"]["away"]["kicks"]["mean"].get<double>(), kicks);
}

TEST(GameReport, CountsDifferentGamesByTheirHashes) {
  const std::vector<GameReport> reports = {{.seed = 1, .hash = 5}, {.seed = 2, .hash = 6}, {.seed = 3, .hash = 5}};
  EXPECT_EQ(different_games(reports), 2);
  EXPECT_EQ(to_json(reports, 4)["different_games"], 2);
}

TEST(GameReport, ShowsTheClockInMinutesAndSeconds) {
  EXPECT_EQ(clock_text(0), "00:00");
  EXPECT_EQ(clock_text(451), "07:31");
  EXPECT_EQ(clock_text(599.9f), "09:59");
}

TEST(GameLine, IsOneLineWithTheFiguresOfTheReport) {
  LineGame measured(game().params, 2);
  referee::Events events;
  while (!finished(measured.state) && measured.goes_on()) {
    step(game().params, measured.state, events);
    measured.see(events);
  }
  const std::string line = measured.line(game().params, false).text;
  EXPECT_EQ(std::ranges::count(line, '\n'), 1);
  EXPECT_TRUE(line.ends_with('\n'));
  const Json json = Json::parse(line), report = to_json(short_game(game().params, 2), game().params.rules.players);
  for (const char* key : {"seed", "score", "seconds"}) EXPECT_EQ(json[key], report[key]) << key;
  for (const char* key : {"goals", "shots", "kicks", "walked", "packets"})
    EXPECT_EQ(json["home"][key], report["home"][key]) << key;
}

}  // namespace
}  // namespace sim::report
