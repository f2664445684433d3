#include "robot/game/control_layout.h"

#include <algorithm>
#include <array>

namespace robot::game {
namespace {

using enum Value;
using pb::PlayerState;

constexpr std::size_t kLettersSize = 4;  // "RGme"

// ---------------------------------------------------------------------------------------------------------------------
// heads

constexpr Field kHead7[] = {{version, 4},
                            {players_per_team, 1},
                            {state, 1},
                            {first_half, 1},
                            {kicking_colour, 1},
                            {phase, 1},
                            {none, 3},  // team and time of the last drop-in
                            {seconds_remaining, 4}};

constexpr Field kHead8[] = {{version, 1},
                            {packet_number, 1},
                            {players_per_team, 1},
                            {state, 1},
                            {first_half, 1},
                            {kicking_colour, 1},
                            {phase, 1},
                            {none, 3},  // drop-in
                            {seconds_remaining, 2},
                            {secondary_seconds, 2}};

constexpr Field kHead9[] = {{version, 2},
                            {packet_number, 1},
                            {players_per_team, 1},
                            {none, 1},  // kind of game
                            {state, 1},
                            {first_half, 1},
                            {kicking_team, 1},
                            {phase, 1},
                            {none, 3},  // drop-in
                            {seconds_remaining, 2},
                            {secondary_seconds, 2}};

constexpr Field kHead11[] = {{version, 2},
                             {packet_number, 1},
                             {players_per_team, 1},
                             {none, 2},  // phase and kind of the competition
                             {phase, 1},
                             {state, 1},
                             {set_play, 1},
                             {first_half, 1},
                             {kicking_team, 1},
                             {none, 3},  // drop-in
                             {seconds_remaining, 2},
                             {secondary_seconds, 2}};

constexpr Field kHead12[] = {{version, 1},
                             {packet_number, 1},
                             {players_per_team, 1},
                             {none, 2},  // phase and kind of the competition
                             {phase, 1},
                             {state, 1},
                             {set_play, 1},
                             {first_half, 1},
                             {kicking_team, 1},
                             {seconds_remaining, 2},
                             {secondary_seconds, 2}};

constexpr Field kHead19[] = {{version, 1},
                             {packet_number, 1},
                             {players_per_team, 1},
                             {none, 1},  // kind of the competition
                             {stopped, 1},
                             {phase, 1},
                             {state, 1},
                             {set_play, 1},
                             {first_half, 1},
                             {kicking_team, 1},
                             {seconds_remaining, 2},
                             {secondary_seconds, 2}};

// ---------------------------------------------------------------------------------------------------------------------
// teams, without their players

constexpr Field kTeam7[] = {{number, 1},
                            {field_colour, 1},
                            {none, 1},  // colour of the goal
                            {score, 1}};

/// Between the shots and the players is the coach: its message, then its own penalty and seconds.
constexpr Field kTeam8[] = {{number, 1},       {field_colour, 1}, {score, 1},
                            {penalty_shot, 1}, {single_shots, 2}, {none, 40 + 2}};
constexpr Field kTeam9[] = {{number, 1},       {field_colour, 1}, {score, 1},
                            {penalty_shot, 1}, {single_shots, 2}, {none, 82 + 2}};
constexpr Field kTeam10[] = {{number, 1},       {field_colour, 1}, {score, 1},
                             {penalty_shot, 1}, {single_shots, 2}, {none, 254 + 2}};

constexpr Field kTeam11[] = {{number, 1}, {field_colour, 1}, {score, 1}, {penalty_shot, 1}, {single_shots, 2}};

constexpr Field kTeam14[] = {{number, 1},       {field_colour, 1}, {score, 1},
                             {penalty_shot, 1}, {single_shots, 2}, {message_budget, 2}};

constexpr Field kTeam15[] = {{number, 1}, {field_colour, 1}, {goalkeeper_colour, 1}, {goalkeeper, 1},
                             {score, 1},  {penalty_shot, 1}, {single_shots, 2},      {message_budget, 2}};

// ---------------------------------------------------------------------------------------------------------------------
// players. In 2013 the last two players of the second team carried values for the GameController's own display, for
// which format 7 had no field; they are read as players too

constexpr Field kPlayer7[] = {{penalty, 2}, {seconds_till_unpenalised, 2}};
constexpr Field kPlayer8[] = {{penalty, 1}, {seconds_till_unpenalised, 1}};
constexpr Field kPlayer19[] = {{penalty, 1}, {seconds_till_unpenalised, 1}, {warnings, 1}, {cautions, 1}};
constexpr Field kPlayer20[] = {{penalty, 1}, {seconds_till_unpenalised, 1}, {cautions, 1}};

// ---------------------------------------------------------------------------------------------------------------------
// meaning of the set play codes 0, 1, 2 …

using pb::GameState;

constexpr GameState::SetPlay kSetPlays11[] = {
    GameState::SET_PLAY_UNSPECIFIED, GameState::SET_PLAY_GOAL_KICK, GameState::SET_PLAY_PUSHING_FREE_KICK,
    GameState::SET_PLAY_CORNER_KICK, GameState::SET_PLAY_KICK_IN,   GameState::SET_PLAY_PENALTY_KICK,
};

constexpr GameState::SetPlay kSetPlays19[] = {
    GameState::SET_PLAY_UNSPECIFIED,  GameState::SET_PLAY_DIRECT_FREE_KICK, GameState::SET_PLAY_INDIRECT_FREE_KICK,
    GameState::SET_PLAY_PENALTY_KICK, GameState::SET_PLAY_THROW_IN,         GameState::SET_PLAY_GOAL_KICK,
    GameState::SET_PLAY_CORNER_KICK,
};

// ---------------------------------------------------------------------------------------------------------------------
// meaning of the penalty codes 1, 2, 3 …

using Penalty = PlayerState::Penalty;
constexpr Penalty kNone = PlayerState::PENALTY_UNSPECIFIED;

constexpr Penalty kPenalties7[] = {
    PlayerState::PENALTY_ILLEGAL_BALL_CONTACT,  // ball holding
    PlayerState::PENALTY_PLAYER_PUSHING,
    kNone,  // obstruction
    PlayerState::PENALTY_INACTIVE_PLAYER,
    PlayerState::PENALTY_ILLEGAL_POSITION,  // illegal defender
    PlayerState::PENALTY_LEAVING_THE_FIELD,
    PlayerState::PENALTY_ILLEGAL_BALL_CONTACT,  // playing with hands
    PlayerState::PENALTY_REQUEST_FOR_PICKUP,
};

// the formats before 2019 use the first eight, that of 2021 the first six
constexpr Penalty kPenalties12[] = {
    PlayerState::PENALTY_ILLEGAL_BALL_CONTACT,
    PlayerState::PENALTY_PLAYER_PUSHING,
    PlayerState::PENALTY_ILLEGAL_MOTION_IN_SET,
    PlayerState::PENALTY_INACTIVE_PLAYER,
    PlayerState::PENALTY_ILLEGAL_POSITION,  // illegal defender
    PlayerState::PENALTY_LEAVING_THE_FIELD,
    kNone,  // kick-off goal
    PlayerState::PENALTY_REQUEST_FOR_PICKUP,
    PlayerState::PENALTY_LOCAL_GAME_STUCK,
    PlayerState::PENALTY_ILLEGAL_POSITION,  // illegal positioning
};

/// Codes 7 to 10 changed between formats 12 and 14. No source gives their meaning in format 13, so they stay codes.
constexpr std::span kPenalties9 = std::span(kPenalties12).first(8);
constexpr std::span kPenalties13 = std::span(kPenalties12).first(6);
constexpr Penalty kPenalties14[] = {
    PlayerState::PENALTY_ILLEGAL_BALL_CONTACT,      PlayerState::PENALTY_PLAYER_PUSHING,
    PlayerState::PENALTY_ILLEGAL_MOTION_IN_SET,     PlayerState::PENALTY_INACTIVE_PLAYER,
    PlayerState::PENALTY_ILLEGAL_POSITION,          PlayerState::PENALTY_LEAVING_THE_FIELD,
    PlayerState::PENALTY_REQUEST_FOR_PICKUP,        PlayerState::PENALTY_LOCAL_GAME_STUCK,
    PlayerState::PENALTY_ILLEGAL_POSITION_IN_SET,   PlayerState::PENALTY_PLAYER_STANCE,
    PlayerState::PENALTY_ILLEGAL_MOTION_IN_STANDBY,
};

constexpr Penalty kPenalties19[] = {
    PlayerState::PENALTY_ILLEGAL_POSITION,   PlayerState::PENALTY_ILLEGAL_MOTION_IN_SET,
    PlayerState::PENALTY_LOCAL_GAME_STUCK,   PlayerState::PENALTY_INACTIVE_PLAYER,       // incapable robot
    PlayerState::PENALTY_REQUEST_FOR_PICKUP, PlayerState::PENALTY_ILLEGAL_BALL_CONTACT,  // ball holding
    PlayerState::PENALTY_LEAVING_THE_FIELD,  PlayerState::PENALTY_ILLEGAL_BALL_CONTACT,  // arms or hands
    PlayerState::PENALTY_PLAYER_PUSHING,     PlayerState::PENALTY_SENT_OFF,
    PlayerState::PENALTY_SUBSTITUTE,
};

constexpr Penalty kPenalties20[] = {
    PlayerState::PENALTY_ILLEGAL_POSITION,
    PlayerState::PENALTY_ILLEGAL_MOTION_IN_SET,
    PlayerState::PENALTY_ILLEGAL_MOTION_IN_STOP,
    PlayerState::PENALTY_LOCAL_GAME_STUCK,
    PlayerState::PENALTY_INACTIVE_PLAYER,
    PlayerState::PENALTY_REQUEST_FOR_PICKUP,
    PlayerState::PENALTY_ILLEGAL_BALL_CONTACT,
    PlayerState::PENALTY_LEAVING_THE_FIELD,
    PlayerState::PENALTY_ILLEGAL_BALL_CONTACT,
    PlayerState::PENALTY_PLAYER_PUSHING,
    PlayerState::PENALTY_CAUTIONED,
    PlayerState::PENALTY_SENT_OFF,
    PlayerState::PENALTY_SUBSTITUTE,
};

// ---------------------------------------------------------------------------------------------------------------------

constexpr std::uint32_t kFinished = 4, kStandby = 5;

/// The formats 7 to 10 have no set plays.
constexpr std::span<const GameState::SetPlay> kNoSetPlays;

constexpr ControlLayout kLayouts[] = {
    {7, kHead7, kTeam7, kPlayer7, 11, kFinished, kNoSetPlays, kPenalties7},      // 2012, 2013
    {8, kHead8, kTeam8, kPlayer8, 11, kFinished, kNoSetPlays, kPenalties7},      // 2014
    {9, kHead9, kTeam9, kPlayer8, 11, kFinished, kNoSetPlays, kPenalties9},      // 2015, 2016
    {10, kHead9, kTeam10, kPlayer8, 11, kFinished, kNoSetPlays, kPenalties9},    // 2017
    {11, kHead11, kTeam11, kPlayer8, 6, kFinished, kSetPlays11, kPenalties9},    // 2018
    {12, kHead12, kTeam11, kPlayer8, 6, kFinished, kSetPlays11, kPenalties12},   // 2019
    {13, kHead12, kTeam11, kPlayer8, 6, kFinished, kSetPlays11, kPenalties13},   // 2021
    {14, kHead12, kTeam14, kPlayer8, 7, kFinished, kSetPlays11, kPenalties14},   // 2022
    {15, kHead12, kTeam15, kPlayer8, 20, kFinished, kSetPlays11, kPenalties14},  // 2023
    {16, kHead12, kTeam15, kPlayer8, 20, kStandby, kSetPlays11, kPenalties14},   // 2024, German Open
    {17, kHead12, kTeam15, kPlayer8, 20, kStandby, kSetPlays11, kPenalties14},   // 2024, never used in a competition
    // the header of format 18 on penaltyShot: "or fallback mode flag (if not in GAME_PHASE_PENALTYSHOOT)"
    {18, kHead12, kTeam15, kPlayer8, 20, kStandby, kSetPlays11, kPenalties14, true},  // 2024, 2025
    {19, kHead19, kTeam15, kPlayer19, 20, kFinished, kSetPlays19, kPenalties19},      // 2026, release 6
    {20, kHead19, kTeam15, kPlayer20, 20, kFinished, kSetPlays19, kPenalties20},      // 2026, after release 6
};

constexpr std::size_t sum(std::span<const Field> fields) {
  std::size_t bytes = 0;
  for (const Field& field : fields) bytes += field.bytes;
  return bytes;
}

constexpr std::size_t size_of(const ControlLayout& layout) {
  return kLettersSize + sum(layout.head) + 2 * (sum(layout.team) + layout.players * sum(layout.player));
}

// sizeof(RoboCupGameControlData) of each release's header, by a compiler
constexpr std::array<std::size_t, 14> kSizes{116, 158, 244, 588, 58, 54, 54, 62, 118, 118, 118, 118, 198, 158};

constexpr bool sizes_are_right() {
  for (std::size_t i = 0; i < kSizes.size(); ++i)
    if (kLayouts[i].version != kOldestVersion + i || size_of(kLayouts[i]) != kSizes[i]) return false;
  return std::size(kLayouts) == kSizes.size();
}
static_assert(sizes_are_right());

}  // namespace

std::size_t ControlLayout::size_bytes() const { return size_of(*this); }

const ControlLayout* control_layout(std::uint32_t version) {
  const auto* const found = std::ranges::find(kLayouts, version, &ControlLayout::version);
  return found == std::end(kLayouts) ? nullptr : found;
}

}  // namespace robot::game
