// The position of each value in a packet of the GameController: one table per format of the years 2012 to 2026.
//
// Sources: `RoboCupGameControlData.h` of RoboCup-SPL/GameController (formats 7, 8, 9, 11, 12, 14 and 17), of
// RoboCup-SPL/GameController3 (15 and 18) and of RoboCup-HumanoidSoccerLeague/GameController (19 and 20). For formats 10, 13 and 16 only the packet length was known. They have the
// fields of the format before; the length of the coach's message follows from the packet length. Tests read packets of
// the real programs of 2013 (7), 2019 (12) and 2022 (14). All numbers are little endian, without padding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "proto/foresight/game.pb.h"

namespace robot::game {

namespace pb = foresight;

/// The meaning of a field. The reader skips `none`: values that no robot needs, such as the coach's message.
enum class Value {
  none,
  version,
  packet_number,
  players_per_team,
  state,
  set_play,
  phase,
  first_half,
  kicking_colour,  // colour of the team; up to format 8
  kicking_team,    // team number; since format 9
  stopped,
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
  warnings,
  cautions,
};

/// One value of a packet.
struct Field {
  Value value;
  std::size_t bytes;
};

/// One format: the four letters "RGme", then `head`, then twice `team` followed by `players` times `player`.
struct ControlLayout {
  std::uint32_t version;
  std::span<const Field> head, team, player;
  std::uint32_t players;                                // of each team, substitutes included
  std::uint32_t greatest_state;                         // 4 finished; 5 standby
  std::span<const pb::GameState::SetPlay> set_plays;    // meaning of the codes from 0 on
  std::span<const pb::PlayerState::Penalty> penalties;  // meaning of the codes from 1 on; UNSPECIFIED: no name of ours
  bool penalty_shot_elsewhere = false;                  // outside the shoot-out the field has another meaning

  /// Returns the length of a whole packet.
  std::size_t size_bytes() const;
};

inline constexpr std::uint32_t kOldestVersion = 7, kNewestVersion = 20;

/// Returns the layout of format `version`, or null if it is not in 7 .. 20.
const ControlLayout* control_layout(std::uint32_t version);

}  // namespace robot::game
