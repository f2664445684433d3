#include "robot/game/control_packet.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/control_packets.h"

namespace robot::game {
namespace {

using tests::ControlPacketText;

constexpr int kOldest = 7, kNewest = 20;

// sizeof(RoboCupGameControlData) of each release, formats 7 .. 20
constexpr std::size_t kSizes[] = {116, 158, 244, 588, 58, 54, 54, 62, 118, 118, 118, 118, 198, 158};

struct EveryFormat : ::testing::TestWithParam<int> {
  int version = GetParam();

  pb::GameState parsed(const ControlPacketText& text, std::uint32_t own_team = 14) const {
    const Result<ControlPacket> packet = parse_control_packet(text.bytes(version));
    EXPECT_TRUE(packet) << packet.error();
    const auto game = packet ? seen_by(*packet, own_team, 3) : std::nullopt;
    EXPECT_TRUE(game);
    return game.value_or(pb::GameState());
  }
};

INSTANTIATE_TEST_SUITE_P(ControlPacket, EveryFormat, ::testing::Range(kOldest, kNewest + 1),
                         [](const auto& format) { return std::to_string(format.param); });

TEST_P(EveryFormat, HasTheSizeOfItsYear) {
  EXPECT_EQ(ControlPacketText().bytes(version).size(), kSizes[version - kOldest]);
}

TEST_P(EveryFormat, ContainsItsVersion) {
  const pb::GameState game = parsed({});
  EXPECT_EQ(game.packet_version(), static_cast<std::uint32_t>(version));
  EXPECT_EQ(game.source(), pb::GameState::SOURCE_GAME_CONTROLLER);
  EXPECT_EQ(game.own_team(), 14u);
  EXPECT_EQ(game.own_player(), 3u);
}

TEST_P(EveryFormat, ContainsStateHalfAndTimes) {
  const pb::GameState game = parsed({.packet_number = 250,
                                     .players_per_team = 6,
                                     .state = 3,
                                     .phase = 2,
                                     .first_half = 0,
                                     .seconds_remaining = 321,
                                     .secondary_seconds = 12});
  EXPECT_EQ(game.state(), pb::GameState::STATE_PLAYING);
  EXPECT_EQ(game.phase(), pb::GameState::PHASE_OVERTIME);
  EXPECT_EQ(game.half(), 2u);
  EXPECT_EQ(game.players_per_team(), 6u);
  EXPECT_EQ(game.seconds_remaining(), 321);
  EXPECT_EQ(game.secondary_seconds(), version >= 8 ? 12 : 0);
  EXPECT_EQ(game.packet_number(), version >= 8 ? 250u : 0u);
}

TEST_P(EveryFormat, ReadsOverrunTimeAsNegative) {
  EXPECT_EQ(parsed({.seconds_remaining = -5}).seconds_remaining(), -5);
}

TEST_P(EveryFormat, ShowsTheTeamsFromEitherSide) {
  const ControlPacketText text{
      .phase = 1,
      .first = {.score = 2, .penalty_shot = 3, .single_shots = 0x105, .message_budget = 1033},
      .second = {.number = 5, .field_colour = 1, .goalkeeper_colour = 9, .goalkeeper = 7, .score = 4}};
  const pb::GameState home = parsed(text, 14), away = parsed(text, 5);
  EXPECT_EQ(home.own().SerializeAsString(), away.opponent().SerializeAsString());
  EXPECT_EQ(home.opponent().SerializeAsString(), away.own().SerializeAsString());
  EXPECT_EQ(home.own().number(), 14u);
  EXPECT_EQ(home.own().score(), 2u);
  EXPECT_EQ(home.own().field_colour(), pb::TeamState::COLOUR_BLUE);
  EXPECT_EQ(home.opponent().number(), 5u);
  EXPECT_EQ(home.opponent().score(), 4u);
  EXPECT_EQ(home.opponent().field_colour(), pb::TeamState::COLOUR_RED);
  EXPECT_EQ(home.own().penalty_shot(), version >= 8 ? 3u : 0u);
  EXPECT_EQ(home.own().single_shots(), version >= 8 ? 0x105u : 0u);
  EXPECT_EQ(home.own().has_message_budget(), version >= 14);
  EXPECT_EQ(home.own().message_budget(), version >= 14 ? 1033u : 0u);
  EXPECT_EQ(home.opponent().goalkeeper(), version >= 15 ? 7u : 0u);
  EXPECT_EQ(home.opponent().goalkeeper_colour(),
            version >= 15 ? pb::TeamState::COLOUR_GRAY : pb::TeamState::COLOUR_UNSPECIFIED);
}

TEST_P(EveryFormat, ContainsThePenalisedPlayers) {
  const int pushing = version == 20 ? 10 : version == 19 ? 9 : 2;
  const int substitute = version == 20 ? 13 : version == 19 ? 11 : 14;
  const pb::GameState game =
      parsed({.first = {.penalised_player = 3, .penalty = pushing, .seconds_till_unpenalised = 44},
              .second = {.number = 5,
                         .field_colour = 1,
                         .penalised_player = 6,
                         .penalty = substitute,
                         .seconds_till_unpenalised = 0}});
  for (int i = 0; i < game.own().players_size(); ++i) EXPECT_EQ(game.own().players(i).penalised(), i == 2) << i;
  EXPECT_EQ(game.own().players(2).penalty(), pb::PlayerState::PENALTY_PLAYER_PUSHING);
  EXPECT_EQ(game.own().players(2).code(), static_cast<std::uint32_t>(pushing));
  EXPECT_EQ(game.own().players(2).seconds_till_unpenalised(), 44);
  EXPECT_EQ(game.opponent().players(5).penalty(), pb::PlayerState::PENALTY_SUBSTITUTE);
  EXPECT_EQ(game.opponent().players(5).seconds_till_unpenalised(), 0);
}

TEST_P(EveryFormat, KeepsAPenaltyCodeWithoutAName) {
  const pb::GameState game = parsed({.first = {.penalised_player = 1, .penalty = 77, .seconds_till_unpenalised = 9}});
  EXPECT_TRUE(game.own().players(0).penalised());
  EXPECT_EQ(game.own().players(0).penalty(), pb::PlayerState::PENALTY_UNSPECIFIED);
  EXPECT_EQ(game.own().players(0).code(), 77u);
}

TEST_P(EveryFormat, ContainsTheKickingTeam) {
  const bool by_colour = version <= 8;
  EXPECT_EQ(parsed({.kicking = by_colour ? 1 : 5}).kicking_team(), 5u);
  EXPECT_EQ(parsed({.kicking = by_colour ? 0 : 14}).kicking_team(), 14u);
  EXPECT_FALSE(parsed({.kicking = by_colour ? 2 : 255}).has_kicking_team()) << "nobody";
}

TEST_P(EveryFormat, RefusesEveryTruncationAndLongerPackets) {
  const std::string bytes = ControlPacketText().bytes(version);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(parse_control_packet(bytes.substr(0, size))) << size;
  EXPECT_EQ(parse_control_packet(bytes + "x").error(),
            "GameController packet: expected " + std::to_string(bytes.size()) + " bytes of format " +
                std::to_string(version) + ", got " + std::to_string(bytes.size() + 1));
}

TEST_P(EveryFormat, RefusesValuesOutsideTheFormat) {
  const auto error = [&](const ControlPacketText& text) { return parse_control_packet(text.bytes(version)).error(); };
  const std::string format = " in format " + std::to_string(version) + ", got 9";
  EXPECT_EQ(error({.state = 9}), "GameController packet: expected a state 0 .. " +
                                     std::string(version >= 16 && version <= 18 ? "5" : "4") + format);
  EXPECT_EQ(error({.phase = 9}), "GameController packet: expected a phase 0 .. 3" + format);
  EXPECT_EQ(error({.first_half = 9}), "GameController packet: expected first half 0 .. 1" + format);
  EXPECT_FALSE(parse_control_packet(ControlPacketText{.players_per_team = 21}.bytes(version)));
  if (version >= 11) {
    EXPECT_EQ(error({.set_play = 9}),
              "GameController packet: expected a set play 0 .. " + std::string(version >= 19 ? "6" : "5") + format);
  }
}

// the letters, the version and the length are right, and the rest is random
TEST_P(EveryFormat, RandomBytesAfterAValidHeadDoNoHarm) {
  std::mt19937 random(1);
  std::string bytes = ControlPacketText().bytes(version);
  const std::size_t head = bytes.find(static_cast<char>(version)) + (version == 7 ? 4 : 2);
  for (int i = 0; i < 2'000; ++i) {
    for (std::size_t at = head; at < bytes.size(); ++at) bytes[at] = static_cast<char>(random());
    const Result<ControlPacket> packet = parse_control_packet(bytes);
    if (!packet) continue;
    EXPECT_NE(packet->game.state(), pb::GameState::STATE_UNSPECIFIED);
    EXPECT_LE(packet->game.players_per_team(), static_cast<std::uint32_t>(packet->teams[0].players_size()));
  }
}

TEST(ControlPacket, RefusesRandomBytes) {
  std::mt19937 random(1);
  for (int i = 0; i < 20'000; ++i) {
    std::string bytes(random() % 700, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    EXPECT_FALSE(parse_control_packet(bytes));
  }
}

TEST(ControlPacket, RefusesFormatsItDoesNotKnow) {
  for (int version = 0; version < 256; ++version) {
    if (version >= kOldest && version <= kNewest) continue;
    const std::string bytes = "RGme" + std::string(1, static_cast<char>(version)) + std::string(113, '\0');
    EXPECT_EQ(parse_control_packet(bytes).error(),
              "GameController packet: expected format 7 .. 20, got " + std::to_string(version));
  }
  EXPECT_EQ(parse_control_packet("RGme").error(), "GameController packet: it ends before its version");
}

// the Humanoid League's format 12 of 2019 has the same letters and a longer version number
TEST(ControlPacket, RefusesAVersionWithMoreBytes) {
  std::string bytes = ControlPacketText().bytes(9);
  bytes[5] = 1;
  EXPECT_EQ(parse_control_packet(bytes).error(), "GameController packet: expected format 9, got 265");
}

TEST(ControlPacket, RefusesPacketsForMonitorsAndFromRobots) {
  std::string bytes = ControlPacketText().bytes(18);
  for (const char* letters : {"RGTD", "RGrt", "RGTr"})
    EXPECT_EQ(parse_control_packet(bytes.replace(0, 4, letters)).error(),
              "GameController packet: expected it to begin with RGme, got 118 bytes that do not");
}

TEST(ControlPacket, AGameOfOtherTeamsIsNotOurs) {
  const Result<ControlPacket> packet = parse_control_packet(ControlPacketText().bytes(18));
  ASSERT_TRUE(packet);
  EXPECT_FALSE(seen_by(*packet, 15, 1));
}

// the comments give the names of each year's header
TEST(ControlPacket, TranslatesPenaltiesOfOtherYears) {
  const auto penalty = [](int version, int code) {
    const auto packet =
        parse_control_packet(ControlPacketText{.first = {.penalised_player = 1, .penalty = code}}.bytes(version));
    return packet->teams[0].players(0).penalty();
  };
  using pb::PlayerState;
  EXPECT_EQ(penalty(7, 1), PlayerState::PENALTY_ILLEGAL_BALL_CONTACT);  // ball holding
  EXPECT_EQ(penalty(7, 3), PlayerState::PENALTY_UNSPECIFIED);           // obstruction
  EXPECT_EQ(penalty(8, 7), PlayerState::PENALTY_ILLEGAL_BALL_CONTACT);  // playing with hands
  EXPECT_EQ(penalty(8, 8), PlayerState::PENALTY_REQUEST_FOR_PICKUP);
  EXPECT_EQ(penalty(9, 3), PlayerState::PENALTY_ILLEGAL_MOTION_IN_SET);
  EXPECT_EQ(penalty(11, 7), PlayerState::PENALTY_UNSPECIFIED);  // kick-off goal
  EXPECT_EQ(penalty(12, 8), PlayerState::PENALTY_REQUEST_FOR_PICKUP);
  EXPECT_EQ(penalty(12, 9), PlayerState::PENALTY_LOCAL_GAME_STUCK);
  EXPECT_EQ(penalty(12, 10), PlayerState::PENALTY_ILLEGAL_POSITION);  // illegal positioning
  EXPECT_EQ(penalty(13, 8), PlayerState::PENALTY_UNSPECIFIED);
  EXPECT_EQ(penalty(14, 7), PlayerState::PENALTY_REQUEST_FOR_PICKUP);
  EXPECT_EQ(penalty(14, 9), PlayerState::PENALTY_ILLEGAL_POSITION_IN_SET);
  EXPECT_EQ(penalty(15, 10), PlayerState::PENALTY_PLAYER_STANCE);
  EXPECT_EQ(penalty(18, 11), PlayerState::PENALTY_ILLEGAL_MOTION_IN_STANDBY);
  for (int version = kOldest; version <= 18; ++version) EXPECT_EQ(penalty(version, 15), PlayerState::PENALTY_MANUAL);
  EXPECT_EQ(penalty(19, 1), PlayerState::PENALTY_ILLEGAL_POSITION);
  EXPECT_EQ(penalty(19, 3), PlayerState::PENALTY_LOCAL_GAME_STUCK);
  EXPECT_EQ(penalty(19, 10), PlayerState::PENALTY_SENT_OFF);
  EXPECT_EQ(penalty(19, 11), PlayerState::PENALTY_SUBSTITUTE);
  EXPECT_EQ(penalty(19, 15), PlayerState::PENALTY_UNSPECIFIED);
  EXPECT_EQ(penalty(20, 3), PlayerState::PENALTY_ILLEGAL_MOTION_IN_STOP);
  EXPECT_EQ(penalty(20, 6), PlayerState::PENALTY_REQUEST_FOR_PICKUP);
  EXPECT_EQ(penalty(20, 11), PlayerState::PENALTY_CAUTIONED);
  EXPECT_EQ(penalty(20, 12), PlayerState::PENALTY_SENT_OFF);
  EXPECT_EQ(penalty(20, 14), PlayerState::PENALTY_UNSPECIFIED);
}

TEST(ControlPacket, Format18CountsShotsInTheShootOutOnly) {
  const auto shots = [](int phase) {
    return parse_control_packet(ControlPacketText{.phase = phase, .first = {.penalty_shot = 1}}.bytes(18))
        ->teams[0]
        .penalty_shot();
  };
  EXPECT_EQ(shots(1), 1u);
  EXPECT_EQ(shots(0), 0u) << "outside the shoot-out the field is the fallback mode flag";
}

TEST(ControlPacket, ReadsStandbyAndEverySetPlay) {
  EXPECT_EQ(parse_control_packet(ControlPacketText{.state = 5}.bytes(18))->game.state(), pb::GameState::STATE_STANDBY);
  for (int set_play = 0; set_play <= 5; ++set_play)
    EXPECT_EQ(parse_control_packet(ControlPacketText{.set_play = set_play}.bytes(18))->game.set_play(), set_play);
}

TEST(ControlPacket, ReadsStoppedCardsAndSetPlaysOf2026) {
  for (const int version : {19, 20}) {
    const ControlPacketText text{.state = 3,
                                 .set_play = 4,
                                 .stopped = 1,
                                 .first = {.penalised_player = 20, .penalty = 1, .warnings = 3, .cautions = 2}};
    const auto packet = parse_control_packet(text.bytes(version));
    ASSERT_TRUE(packet) << packet.error();
    EXPECT_TRUE(packet->game.stopped());
    EXPECT_EQ(packet->game.set_play(), pb::GameState::SET_PLAY_THROW_IN);
    const pb::PlayerState& last = packet->teams[0].players(19);
    EXPECT_EQ(last.warnings(), version == 19 ? 3u : 0u);
    EXPECT_EQ(last.cautions(), 2u);
    EXPECT_EQ(parse_control_packet(ControlPacketText{.set_play = 1}.bytes(version))->game.set_play(),
              pb::GameState::SET_PLAY_DIRECT_FREE_KICK);
    EXPECT_EQ(parse_control_packet(ControlPacketText{.set_play = 6}.bytes(version))->game.set_play(),
              pb::GameState::SET_PLAY_CORNER_KICK);
    EXPECT_FALSE(parse_control_packet(ControlPacketText{.stopped = 2}.bytes(version)));
  }
}

// every newer format, whatever its length and its places are
TEST(UnreadableGame, IsAnyNewerPacketThatNamesOurTeam) {
  std::mt19937 random(1);
  for (int version = kNewest + 1; version < 256; ++version) {
    std::string bytes = "RGme" + std::string(1, static_cast<char>(version)) + std::string(27 + random() % 500, '\0');
    EXPECT_FALSE(unreadable_game(bytes, 14, 3)) << "our number is nowhere";
    bytes[5 + random() % (bytes.size() - 5)] = 14;
    const auto game = unreadable_game(bytes, 14, 3);
    ASSERT_TRUE(game) << version;
    EXPECT_TRUE(game->unreadable());
    EXPECT_EQ(game->packet_version(), static_cast<std::uint32_t>(version));
    EXPECT_EQ(game->source(), pb::GameState::SOURCE_GAME_CONTROLLER);
    EXPECT_EQ(game->own_team(), 14u);
    EXPECT_EQ(game->own_player(), 3u);
    EXPECT_EQ(game->state(), pb::GameState::STATE_UNSPECIFIED);
  }
}

TEST(UnreadableGame, IsAKnownFormatOfAnotherLength) {
  for (int version = kOldest; version <= kNewest; ++version) {
    const std::string bytes = ControlPacketText().bytes(version);
    EXPECT_FALSE(unreadable_game(bytes, 14, 3)) << "this one can be read";
    EXPECT_TRUE(unreadable_game(bytes + "x", 14, 3)) << version;
    EXPECT_FALSE(unreadable_game(bytes + "x", 77, 3)) << "of two other teams";
  }
}

TEST(UnreadableGame, IsNoPacketOfAnotherProgram) {
  std::mt19937 random(1);
  for (int i = 0; i < 20'000; ++i) {
    std::string bytes(random() % 700, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    EXPECT_FALSE(unreadable_game(bytes, 14, 3));
  }
  EXPECT_FALSE(unreadable_game("RGme\x15\x0e", 14, 3)) << "too short for two teams";
}

}  // namespace
}  // namespace robot::game
