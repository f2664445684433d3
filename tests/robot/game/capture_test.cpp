// Captures of the real GameControllers of 2013, 2019 and 2022, compared with the script that the operator followed.
#include <gtest/gtest.h>

#include <algorithm>

#include "robot/game/control_packet.h"
#include "tests/support/control_packets.h"
#include "tests/support/real_data.h"

namespace robot::game {
namespace {

/// The script of all three captures: the time [s] of each click.
constexpr double kReady = 2.0, kSet = 4.5, kPlaying = 6.5, kPushing = 9.5, kOut = 12.0, kGoal = 14.5, kFinished = 17.0;

struct Year {
  const char* file;
  std::uint32_t version;
  std::uint32_t players_per_team;
  int players;            // with substitutes
  float penalty_seconds;  // for pushing, by that year's rules
};

const Year k2013{"gamecontroller/gc_v7_RoboCup2013.cap", 7, 5, 11, 30};
const Year k2019{"gamecontroller/gc_v12_RoboCup2019.cap", 12, 6, 6, 45};
const Year k2022{"gamecontroller/gc_v14_RoboCup2022.cap", 14, 6, 7, 45};

pb::GameState::State state_at(double seconds) {
  if (seconds < kReady) return pb::GameState::STATE_INITIAL;
  if (seconds < kSet) return pb::GameState::STATE_READY;
  if (seconds < kPlaying) return pb::GameState::STATE_SET;
  if (seconds < kGoal) return pb::GameState::STATE_PLAYING;
  return seconds < kFinished ? pb::GameState::STATE_READY : pb::GameState::STATE_FINISHED;
}

void expect_team_14(const pb::TeamState& team, const Year& year, double seconds) {
  EXPECT_EQ(team.number(), 14u);
  EXPECT_EQ(team.field_colour(), pb::TeamState::COLOUR_BLUE);
  EXPECT_EQ(team.score(), seconds < kGoal ? 0u : 1u);
  ASSERT_EQ(team.players_size(), year.players);
  const pb::PlayerState& pusher = team.players(2);
  EXPECT_EQ(pusher.penalised(), seconds >= kPushing);
  EXPECT_EQ(pusher.penalty(),
            seconds < kPushing ? pb::PlayerState::PENALTY_UNSPECIFIED : pb::PlayerState::PENALTY_PLAYER_PUSHING);
  // in 2013 a goal ended all penalties; in later years the end of the half does
  const bool over = seconds >= (year.version == 7 ? kGoal : kFinished);
  const double left = seconds < kPushing || over ? 0 : year.penalty_seconds - (seconds - kPushing);
  EXPECT_NEAR(pusher.seconds_till_unpenalised(), left, 1);
}

void expect_team_5(const pb::TeamState& team, const Year& year) {
  EXPECT_EQ(team.number(), 5u);
  EXPECT_EQ(team.field_colour(), pb::TeamState::COLOUR_RED);
  EXPECT_EQ(team.score(), 0u);
  ASSERT_EQ(team.players_size(), year.players);
}

/// Checks all other players: on the field, and substitutes from number 6 on.
void expect_others(const pb::TeamState& team, const Year& year) {
  // in 2013 the last two players of the second team carry values for the GameController's own display
  const int players = year.version == 7 ? 9 : team.players_size();
  for (int i = 0; i < players; ++i) {
    if (team.number() == 14 && i == 2) continue;
    EXPECT_EQ(team.players(i).penalised(), i >= 5) << "player " << i + 1;
    EXPECT_EQ(team.players(i).penalty(),
              i >= 5 ? pb::PlayerState::PENALTY_SUBSTITUTE : pb::PlayerState::PENALTY_UNSPECIFIED);
  }
}

void expect_known_answers(const std::filesystem::path& path, const Year& year) {
  const std::vector<tests::CapturedPacket> packets = tests::read_capture(path);
  ASSERT_EQ(packets.size(), 37u);
  std::uint32_t number = 0;
  for (const auto& [seconds, payload] : packets) {
    SCOPED_TRACE(seconds);
    const Result<ControlPacket> packet = parse_control_packet(payload);
    ASSERT_TRUE(packet) << packet.error();
    const auto game = seen_by(*packet, 14, 3);
    ASSERT_TRUE(game);
    EXPECT_EQ(game->packet_version(), year.version);
    EXPECT_EQ(game->packet_number(), year.version == 7 ? 0 : ++number);
    EXPECT_EQ(game->state(), state_at(seconds));
    EXPECT_EQ(game->phase(), pb::GameState::PHASE_NORMAL);
    EXPECT_EQ(game->half(), 1u);
    EXPECT_EQ(game->players_per_team(), year.players_per_team);
    EXPECT_NEAR(game->seconds_remaining(), 600 - std::clamp(seconds - kPlaying, 0.0, kFinished - kPlaying), 1);

    const bool kick_in = year.version != 7 && seconds >= kOut && seconds < kGoal;
    EXPECT_EQ(game->set_play(), kick_in ? pb::GameState::SET_PLAY_KICK_IN : pb::GameState::SET_PLAY_UNSPECIFIED);
    EXPECT_EQ(game->kicking_team(), kick_in || seconds >= kGoal ? 5u : 14u);

    expect_team_14(game->own(), year, seconds);
    expect_team_5(game->opponent(), year);
    expect_others(game->own(), year);
    expect_others(game->opponent(), year);
    EXPECT_EQ(game->own().has_message_budget(), year.version == 14);
    EXPECT_EQ(game->own().message_budget(), year.version == 14 ? 1200u : 0u);

    const auto other = seen_by(*packet, 5, 1);
    ASSERT_TRUE(other);
    EXPECT_EQ(other->own().SerializeAsString(), game->opponent().SerializeAsString());
    for (std::size_t size = 0; size < payload.size(); ++size)
      EXPECT_FALSE(parse_control_packet(payload.substr(0, size)));
  }
}

TEST(Capture, Of2013GivesTheKnownAnswers) {
  REAL_DATA_OR_SKIP(path, k2013.file);
  expect_known_answers(path, k2013);
}

TEST(Capture, Of2019GivesTheKnownAnswers) {
  REAL_DATA_OR_SKIP(path, k2019.file);
  expect_known_answers(path, k2019);
}

TEST(Capture, Of2022GivesTheKnownAnswers) {
  REAL_DATA_OR_SKIP(path, k2022.file);
  expect_known_answers(path, k2022);
}

}  // namespace
}  // namespace robot::game
