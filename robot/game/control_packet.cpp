#include "robot/game/control_packet.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "robot/core/little_endian.h"
#include "robot/game/control_layout.h"

namespace robot::game {
namespace {

constexpr std::string_view kControlLetters = "RGme";

/// Returns a time, negative when it is overrun: two's complement of `bytes` bytes.
float seconds_of(std::uint32_t number, std::size_t bytes) {
  return bytes == 2 ? static_cast<float>(static_cast<std::int16_t>(number))
                    : static_cast<float>(static_cast<std::int32_t>(number));
}

pb::TeamState::Colour colour_of(std::uint32_t code) {
  // our enumeration begins with "not known"
  return pb::TeamState::Colour_IsValid(static_cast<int>(code) + 1) ? static_cast<pb::TeamState::Colour>(code + 1)
                                                                   : pb::TeamState::COLOUR_UNSPECIFIED;
}

pb::GameState::State state_of(std::uint32_t code) {
  constexpr std::array kStates{pb::GameState::STATE_INITIAL,  pb::GameState::STATE_READY,
                               pb::GameState::STATE_SET,      pb::GameState::STATE_PLAYING,
                               pb::GameState::STATE_FINISHED, pb::GameState::STATE_STANDBY};
  return kStates.at(code);
}

pb::GameState::Phase phase_of(std::uint32_t code) {
  constexpr std::array kPhases{pb::GameState::PHASE_NORMAL, pb::GameState::PHASE_PENALTY_SHOOT_OUT,
                               pb::GameState::PHASE_OVERTIME, pb::GameState::PHASE_TIMEOUT};
  return kPhases.at(code);
}

class Parser {
 public:
  Parser(std::string_view bytes, const ControlLayout& layout) : bytes_(bytes), layout_(layout) {}

  Result<ControlPacket> parse() {
    for (const Field& field : layout_.head) read_head(field);
    for (pb::TeamState& team : packet_.teams) {
      for (const Field& field : layout_.team) read_team(field, team);
      for (std::uint32_t i = 0; i < layout_.players; ++i) read_player(*team.add_players());
    }
    if (!wrong_.empty()) return Error{wrong_};
    set_kicking_team();
    return std::move(packet_);
  }

 private:
  std::uint32_t take(const Field& field) { return static_cast<std::uint32_t>(bytes_.number(field.bytes)); }

  /// Reads a number as take() does. A number above `greatest` makes the packet wrong and counts as 0.
  std::uint32_t take_up_to(const Field& field, std::uint32_t greatest, const char* name) {
    const std::uint32_t number = take(field);
    if (number <= greatest) return number;
    if (wrong_.empty())
      wrong_ = "GameController packet: expected " + std::string(name) + " 0 .. " + std::to_string(greatest) +
               " in format " + std::to_string(layout_.version) + ", got " + std::to_string(number);
    return 0;
  }

  void read_head(const Field& field) {
    pb::GameState& game = packet_.game;
    switch (field.value) {
      case Value::version: game.set_packet_version(take(field)); break;
      case Value::packet_number: game.set_packet_number(take(field)); break;
      case Value::players_per_team:
        game.set_players_per_team(take_up_to(field, layout_.players, "players per team"));
        break;
      case Value::state: game.set_state(state_of(take_up_to(field, layout_.greatest_state, "a state"))); break;
      case Value::set_play:
        game.set_set_play(layout_.set_plays[take_up_to(field, static_cast<std::uint32_t>(layout_.set_plays.size() - 1),
                                                       "a set play")]);
        break;
      case Value::phase: game.set_phase(phase_of(take_up_to(field, 3, "a phase"))); break;
      case Value::first_half: game.set_half(take_up_to(field, 1, "first half") == 1 ? 1 : 2); break;
      case Value::stopped: game.set_stopped(take_up_to(field, 1, "stopped") == 1); break;
      case Value::kicking_colour: kicking_colour_ = take(field); break;
      case Value::kicking_team: kicking_team_ = take(field); break;
      case Value::seconds_remaining: game.set_seconds_remaining(seconds_of(take(field), field.bytes)); break;
      case Value::secondary_seconds: game.set_secondary_seconds(seconds_of(take(field), field.bytes)); break;
      default: take(field);
    }
  }

  void read_team(const Field& field, pb::TeamState& team) {
    switch (field.value) {
      case Value::number: team.set_number(take(field)); break;
      case Value::field_colour: team.set_field_colour(colour_of(take(field))); break;
      case Value::goalkeeper_colour: team.set_goalkeeper_colour(colour_of(take(field))); break;
      case Value::goalkeeper: team.set_goalkeeper(take(field)); break;
      case Value::score: team.set_score(take(field)); break;
      case Value::penalty_shot: {
        const std::uint32_t shots = take(field);
        const bool meant = packet_.game.phase() == pb::GameState::PHASE_PENALTY_SHOOT_OUT;
        if (meant || !layout_.penalty_shot_elsewhere) team.set_penalty_shot(shots);
        break;
      }
      case Value::single_shots: team.set_single_shots(take(field)); break;
      case Value::message_budget: team.set_message_budget(take(field)); break;
      default: take(field);
    }
  }

  void read_player(pb::PlayerState& player) {
    for (const Field& field : layout_.player) {
      const std::uint32_t number = take(field);
      switch (field.value) {
        case Value::penalty:
          player.set_penalised(number != 0);
          player.set_code(number);
          player.set_penalty(penalty_of(number));
          break;
        case Value::seconds_till_unpenalised:
          if (player.penalised()) player.set_seconds_till_unpenalised(static_cast<float>(number));
          break;
        case Value::warnings: player.set_warnings(number); break;
        case Value::cautions: player.set_cautions(number); break;
        default: break;
      }
    }
  }

  pb::PlayerState::Penalty penalty_of(std::uint32_t code) const {
    // these two codes are the same in all formats up to 18
    const bool same = code == pb::PlayerState::PENALTY_SUBSTITUTE || code == pb::PlayerState::PENALTY_MANUAL;
    if (same && layout_.version <= 18) return static_cast<pb::PlayerState::Penalty>(code);
    const bool named = code >= 1 && code <= layout_.penalties.size();
    return named ? layout_.penalties[code - 1] : pb::PlayerState::PENALTY_UNSPECIFIED;
  }

  void set_kicking_team() {
    for (const pb::TeamState& team : packet_.teams) {
      // 0: blue, 1: red, 2: a ball dropped by the referee
      const bool by_colour =
          kicking_colour_ && *kicking_colour_ <= 1 && colour_of(*kicking_colour_) == team.field_colour();
      if (by_colour || kicking_team_ == team.number()) packet_.game.set_kicking_team(team.number());
    }
  }

  ByteReader bytes_;
  const ControlLayout& layout_;
  ControlPacket packet_;
  std::optional<std::uint32_t> kicking_team_, kicking_colour_;
  std::string wrong_;
};

}  // namespace

Result<ControlPacket> parse_control_packet(std::string_view bytes) {
  if (!bytes.starts_with(kControlLetters))
    return Error{"GameController packet: expected it to begin with RGme, got " + std::to_string(bytes.size()) +
                 " bytes that do not"};
  if (bytes.size() == kControlLetters.size()) return Error{"GameController packet: it ends before its version"};
  // the version has one, two or four bytes; the first byte selects the format
  const auto version = static_cast<std::uint8_t>(bytes[kControlLetters.size()]);
  const ControlLayout* const layout = control_layout(version);
  if (layout == nullptr)
    return Error{"GameController packet: expected format " + std::to_string(kOldestVersion) + " .. " +
                 std::to_string(kNewestVersion) + ", got " + std::to_string(version)};
  if (bytes.size() != layout->size_bytes())
    return Error{"GameController packet: expected " + std::to_string(layout->size_bytes()) + " bytes of format " +
                 std::to_string(layout->version) + ", got " + std::to_string(bytes.size())};
  Result<ControlPacket> packet = Parser(bytes.substr(kControlLetters.size()), *layout).parse();
  if (packet && packet->game.packet_version() != layout->version)
    return Error{"GameController packet: expected format " + std::to_string(layout->version) + ", got " +
                 std::to_string(packet->game.packet_version())};
  return packet;
}

std::optional<pb::GameState> unreadable_game(std::string_view bytes, std::uint32_t own_team, std::uint32_t own_player) {
  // the shortest format is longer than this; below it there is no room for two teams
  constexpr std::size_t kShortest = 32;
  if (!bytes.starts_with(kControlLetters) || bytes.size() < kShortest) return std::nullopt;
  const auto version = static_cast<std::uint8_t>(bytes[kControlLetters.size()]);
  const ControlLayout* const layout = control_layout(version);
  const bool newer = version > kNewestVersion;
  if (!newer && (layout == nullptr || bytes.size() == layout->size_bytes())) return std::nullopt;
  if (bytes.find(static_cast<char>(own_team), kControlLetters.size() + 1) == std::string_view::npos)
    return std::nullopt;

  pb::GameState game;
  game.set_source(pb::GameState::SOURCE_GAME_CONTROLLER);
  game.set_packet_version(version);
  game.set_unreadable(true);
  game.set_own_team(own_team);
  game.set_own_player(own_player);
  return game;
}

std::optional<pb::GameState> seen_by(const ControlPacket& packet, std::uint32_t own_team, std::uint32_t own_player) {
  const auto* const own = std::ranges::find(packet.teams, own_team, &pb::TeamState::number);
  if (own == packet.teams.end()) return std::nullopt;
  pb::GameState game = packet.game;
  game.set_source(pb::GameState::SOURCE_GAME_CONTROLLER);
  game.set_own_team(own_team);
  game.set_own_player(own_player);
  *game.mutable_own() = *own;
  *game.mutable_opponent() = packet.teams[own == packet.teams.begin() ? 1 : 0];
  return game;
}

}  // namespace robot::game
