#include "sim/match/play.h"

#include <gtest/gtest.h>

#include <numeric>
#include <utility>
#include <vector>

#include "sim/match/fields.h"
#include "sim/match/hash.h"
#include "tests/sim/support/games.h"

namespace sim {
namespace {

using Kind = referee::Event::Kind;
using test::begun;
using test::choice_of;
using test::setup_of;

std::uint32_t of(const Result& result, Kind kind, Side side) {
  return result.events[static_cast<int>(kind)][static_cast<int>(side)];
}
std::uint32_t of(const Result& result, Kind kind) {
  return of(result, kind, Side::home) + of(result, kind, Side::away);
}

TEST(Play, GoesToTheEndOfTheGame) {
  for (const char* rules : {"spl2012", "spl2025"}) {
    for (const Pace pace : {Pace::every_tick, Pace::thinned}) {
      const auto setup = setup_of(choice_of(rules, "baseline", "match", pace), 60);
      const Result result = play_game(setup.params, {1});
      EXPECT_TRUE(result.over);
      EXPECT_EQ(of(result, Kind::end), 1u);
      EXPECT_EQ(of(result, Kind::half_time), static_cast<unsigned>(setup.params.rules.halves) - 1);
      EXPECT_GE(result.ticks, 2 * ticks(60));
    }
  }
}

/// Returns the number of set plays of a kind that both sides took, and of those whose time was up.
std::pair<std::uint32_t, std::uint32_t> set_plays(const Result& result, agent::Game::SetPlay kind) {
  const auto& taken = result.taken[static_cast<int>(kind)];
  const auto& expired = result.expired[static_cast<int>(kind)];
  return {taken[0] + taken[1], expired[0] + expired[1]};
}

TEST(Play, CountsTheSetPlaysThatAreTakenAndThoseThatExpire) {
  using SetPlay = agent::Game::SetPlay;
  for (const char* rules : {"spl2012", "spl2025", "hsl2026"}) {
    const Result result = play_game(setup_of(choice_of(rules, "baseline", "match")).params, {3});
    std::uint32_t all = 0;
    for (const SetPlay kind : {SetPlay::kick_off, SetPlay::kick_in, SetPlay::goal_kick, SetPlay::corner_kick}) {
      const auto [taken, expired] = set_plays(result, kind);
      all += taken + expired;
    }
    EXPECT_EQ(all, of(result, Kind::ball_free)) << rules << ": each one ends once";
    EXPECT_GT(set_plays(result, SetPlay::kick_off).first, 0u) << rules;
  }
  // nobody takes a kick-off
  const Result idle = play_game(setup_of(choice_of("spl2025", "idle", "match")).params, {3});
  EXPECT_EQ(set_plays(idle, SetPlay::kick_off).first, 0u);
  EXPECT_GT(set_plays(idle, SetPlay::kick_off).second, 1u);
}

TEST(Play, TheRulesOfEachYearLetEverySetPlayBeTaken) {
  using SetPlay = agent::Game::SetPlay;
  for (const char* rules : {"spl2012", "spl2025:5", "spl2025:7", "hsl2026"}) {
    const auto setup = setup_of(choice_of(rules, "baseline", "match", Pace::thinned));
    const bool with_set_plays = setup.params.rules.ball_out == field::BallOut::set_play;
    Result all{};
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const Result result = play_game(setup.params, {seed});
      for (std::size_t kind = 0; kind < std::size(all.taken); ++kind)
        for (const int side : {0, 1}) {
          all.taken[kind][side] += result.taken[kind][side];
          all.expired[kind][side] += result.expired[kind][side];
        }
    }
    for (const SetPlay kind : {SetPlay::kick_off, SetPlay::kick_in, SetPlay::goal_kick, SetPlay::corner_kick}) {
      const auto [taken, expired] = set_plays(all, kind);
      // from far away 30 s hardly suffice for a corner kick
      const double least = kind == SetPlay::corner_kick ? 0.7 : 0.85;
      EXPECT_GE(static_cast<double>(taken), least * static_cast<double>(taken + expired))
          << rules << ", kind " << static_cast<int>(kind);
      EXPECT_EQ(taken > 0, with_set_plays || kind == SetPlay::kick_off) << rules;
    }
  }
}

TEST(Play, KeepsTheBudgetOfPackets) {
  const auto setup = setup_of(choice_of("spl2025", "baseline", "match", Pace::thinned));
  const Result result = play_game(setup.params, {6});
  const int budget = setup.params.rules.message_budget;
  for (const int packets : result.packets) {
    EXPECT_LE(packets, budget);
    EXPECT_GT(packets, budget * 9 / 10);
  }
}

TEST(Play, CountsThePacketsOfRobotsThatSendInEveryTick) {
  const auto setup =
      setup_of(choice_of("spl2012", "idle", "match,packet_limit=off,packet_delay=off", Pace::every_tick));
  const Result result = play_game(setup.params, {7});
  for (const int packets : result.packets)
    EXPECT_EQ(packets, static_cast<int>(result.ticks) * setup.params.rules.players);
}

TEST(Play, AddsUp) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match"));
  const Result result = play_game(setup.params, {2});
  for (const Side side : {Side::home, Side::away}) {
    const int i = static_cast<int>(side);
    EXPECT_EQ(of(result, Kind::goal, side), result.score[i]);
    EXPECT_GT(result.packets[i], 0);
    EXPECT_GT(result.walked[i], 10.f);
    EXPECT_GT(result.counts.kicks[i], 0);
  }
  EXPECT_LE(result.counts.possession[0] + result.counts.possession[1], result.counts.in_play);
  EXPECT_LE(result.counts.in_play, result.ticks);
  EXPECT_NEAR(result.possession(Side::home) + result.possession(Side::away), 1, 1e-6);
}

TEST(Play, InPartsEqualsTheWholeGame) {
  const auto setup = setup_of(choice_of("spl2025", "baseline", "match"), 60);
  State whole = begun(setup.params, 3), parts = whole;
  const Result at_once = play_on(setup.params, whole);
  Result sum{};
  while (!finished(parts)) {
    const Result part = play_on(setup.params, parts, 1234);
    for (int kind = 0; kind < kEventKinds; ++kind)
      for (int side = 0; side < 2; ++side) sum.events[kind][side] += part.events[kind][side];
  }
  EXPECT_EQ(difference(whole, parts), "");
  for (int kind = 0; kind < kEventKinds; ++kind)
    for (int side = 0; side < 2; ++side) EXPECT_EQ(sum.events[kind][side], at_once.events[kind][side]);
  EXPECT_EQ(play_on(setup.params, parts).ticks, at_once.ticks) << "a game that is over stays over";
}

TEST(Play, StopsOnRequest) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match"));
  State state = begun(setup.params, 4);
  std::vector<referee::Event> heard;
  const Tick played = play(
      setup.params, state, [](const State& now) { return now.book.phase == agent::Game::Phase::playing; },
      [&](const referee::Event& event) { heard.push_back(event); });
  EXPECT_EQ(state.world.tick, played);
  ASSERT_EQ(heard.size(), 2u);
  EXPECT_EQ(heard[0].kind, Kind::set);
  EXPECT_EQ(heard[1].kind, Kind::playing);
  EXPECT_EQ(heard[1].tick + 1, played);
}

TEST(HashOfGame, IgnoresTheSeedAndTheAgentsMemoryOnly) {
  const auto setup = setup_of(choice_of("spl2012", "baseline", "match"));
  const State state = test::after(setup.params, begun(setup.params, 4), 2000);
  State other = state;
  ++other.world.key.seed;
  ++other.robots[2].mind.leaf;
  EXPECT_EQ(hash_of_game(other), hash_of_game(state));
  other.world.bodies[2].walked += 1;
  EXPECT_NE(hash_of_game(other), hash_of_game(state));
  EXPECT_NE(hash_of_game(test::after(setup.params, begun(setup.params, 5), 2000)), hash_of_game(state));
}

TEST(Possession, IsZeroInAGameWithoutPlay) {
  const Result nothing{};
  EXPECT_EQ(nothing.possession(Side::home), 0);
}

}  // namespace
}  // namespace sim
