#include "robot/bridge/player_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace robot::bridge {
namespace {

/// As the GameController reports it: 20 numbers, of which these are no substitutes.
pb::TeamState team(const std::vector<std::uint32_t>& playing, std::uint32_t keeper = 0) {
  pb::TeamState team;
  team.set_goalkeeper(keeper);
  for (std::uint32_t number = 1; number <= 20; ++number) {
    pb::PlayerState& player = *team.add_players();
    if (std::find(playing.begin(), playing.end(), number) != playing.end()) continue;
    player.set_penalised(true);
    player.set_penalty(pb::PlayerState::PENALTY_SUBSTITUTE);
  }
  return team;
}

std::vector<std::uint32_t> players(const PlayerMap& lineup, int places) {
  std::vector<std::uint32_t> players;
  for (int place = 1; place <= places; ++place) players.push_back(lineup.player_at(place));
  return players;
}
using Numbers = std::vector<std::uint32_t>;

TEST(PlayerMap, TheKeeperIsTheFirstAndTheOthersFollowByTheirNumbers) {
  EXPECT_EQ(players(PlayerMap(team({1, 2, 3, 4, 5}, 1), 5), 5), (Numbers{1, 2, 3, 4, 5}));
  EXPECT_EQ(players(PlayerMap(team({2, 5, 7, 11, 20}, 7), 5), 5), (Numbers{7, 2, 5, 11, 20}));
  EXPECT_EQ(players(PlayerMap(team({1, 3, 4, 6, 8}), 5), 5), (Numbers{1, 3, 4, 6, 8}))
      << "number 1 if no goalkeeper is named";
}

TEST(PlayerMap, WithoutAKeeperTheGoalIsEmptyUnlessAPlayerIsLeftOver) {
  EXPECT_EQ(players(PlayerMap(team({2, 3, 4}), 5), 5), (Numbers{0, 2, 3, 4, 0}));
  EXPECT_EQ(players(PlayerMap(team({2, 3, 4, 5, 6}), 5), 5), (Numbers{2, 3, 4, 5, 6}));
  EXPECT_EQ(players(PlayerMap(team({2, 3, 4, 5}, 9), 4), 4), (Numbers{2, 3, 4, 5})) << "the one named is a substitute";
}

TEST(PlayerMap, AnExtraPlayerHasNoPlace) {
  const PlayerMap lineup(team({1, 2, 3, 4, 5, 6}), 4);
  EXPECT_EQ(players(lineup, 7), (Numbers{1, 2, 3, 4, 0, 0, 0}));
  EXPECT_EQ(lineup.place_of(5), 0);
}

TEST(PlayerMap, PlacesAndNumbersAreEachOthersInverse) {
  // every team of up to five out of twelve numbers, each of which may keep
  for (std::uint32_t set = 1; set < 1 << 12; ++set) {
    Numbers playing;
    for (std::uint32_t number = 1; number <= 12; ++number)
      if (set >> (number - 1) & 1) playing.push_back(number);
    if (playing.size() > 5) continue;
    for (const std::uint32_t keeper : {1u, 5u, 12u}) {
      const PlayerMap lineup(team(playing, keeper), 5);
      for (const std::uint32_t number : playing) {
        const int place = lineup.place_of(number);
        ASSERT_GE(place, 1) << lineup.text();
        ASSERT_EQ(lineup.player_at(place), number);
        ASSERT_EQ(place == 1 || number != keeper, true);
      }
      for (std::uint32_t number = 0; number <= 21; ++number)
        ASSERT_EQ(lineup.place_of(number) != 0, std::find(playing.begin(), playing.end(), number) != playing.end());
    }
  }
}

TEST(PlayerMap, InAnUnknownTeamAllHaveTheirNumbers) {
  EXPECT_EQ(players(PlayerMap({}, 5), 7), (Numbers{1, 2, 3, 4, 5, 0, 0}));
}

TEST(PlayerMap, APenalisedPlayerKeepsItsPlace) {
  pb::TeamState one = team({1, 2, 3, 4, 5});
  one.mutable_players(1)->set_penalised(true);
  one.mutable_players(1)->set_penalty(pb::PlayerState::PENALTY_MANUAL);
  EXPECT_EQ(PlayerMap(one, 5).place_of(2), 2);
  EXPECT_EQ(PlayerMap(one, 5).text(), "1, 2, 3, 4, 5");
}

}  // namespace
}  // namespace robot::bridge
