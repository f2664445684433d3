// Where in a packet of the GameController each value lies: one table per format of the years 2012 to 2025.
//
// Sources: `RoboCupGameControlData.h` of RoboCup-SPL/GameController (formats 7, 8, 9, 11, 12, 14 and 17) and of
// RoboCup-SPL/GameController3 (15 and 18). Of formats 10, 13 and 16 only the length of a packet was at hand: the fields
// are those of the format before with the coach's message as long as that length says. Packets of the real programs of
// 2013 (7), 2019 (12) and 2022 (14) are read in tests. All numbers are little endian, nothing is padded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "proto/foresight/game.pb.h"

namespace robot::game {

namespace pb = foresight;

/// What a field means. `none` is passed over: what no robot needs, such as the coach's message.
enum class Value {
  none,
  version,
  packet_number,
  players_per_team,
  state,
  set_play,
  phase,
  first_half,
  kicking_colour,  // colour of the team; a team number since format 9
  kicking_team,
  seconds_remaining,
  secondary_seconds,
  // of a team
  number,
  field_colour,
  goalkeeper_colour,
  goalkeeper,
  score,
  penalty_shot,
  single_shots,
  message_budget,
  // of a player
  penalty,
  seconds_till_unpenalised,
};

struct Field {
  Value value;
  std::size_t bytes;
};

/// One format: the four letters "RGme", then `head`, then two teams of `team` and `players` times `player` each.
struct ControlLayout {
  std::uint32_t version;
  std::span<const Field> head, team, player;
  std::uint32_t players;                                // of each team, substitutes included
  std::uint32_t greatest_state;                         // 4 finished; 5 standby
  std::span<const pb::PlayerState::Penalty> penalties;  // what codes from 1 on mean; UNSPECIFIED: no name of ours fits
  bool penalty_shot_elsewhere = false;                  // outside the shoot-out the field holds something else

  /// The length of a whole packet.
  std::size_t size_bytes() const;
};

inline constexpr std::uint32_t kOldestVersion = 7, kNewestVersion = 18;

/// The layout of format `version`, or null where it is none of 7 .. 18.
const ControlLayout* control_layout(std::uint32_t version);

}  // namespace robot::game
