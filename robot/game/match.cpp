#include "robot/game/match.h"

namespace robot::game {
namespace {

/// Returns true for a break, which neither begins nor ends a match.
bool pauses(const pb::GameState& game) {
  return game.state() == pb::GameState::STATE_STANDBY || game.state() == pb::GameState::STATE_UNSPECIFIED ||
         game.phase() == pb::GameState::PHASE_TIMEOUT;
}

}  // namespace

bool under_way(pb::GameState::State state) {
  return state == pb::GameState::STATE_READY || state == pb::GameState::STATE_SET ||
         state == pb::GameState::STATE_PLAYING;
}

Match::Change Match::move_to(bool in_progress) {
  const bool was = in_progress_.exchange(in_progress, std::memory_order_acq_rel);
  if (was == in_progress) return Change::none;
  return in_progress ? Change::began : Change::ended;
}

Match::Change Match::update(const pb::GameState& game, std::uint64_t now_ns) {
  if (game.source() == pb::GameState::SOURCE_SIMULATOR) return Change::none;
  if (game.received_ns() != 0 && now_ns >= game.received_ns() + kSilenceNs) return move_to(false);
  if (game.unreadable() && !in_progress()) identity_ = {};
  if (game.unreadable()) return move_to(true);
  if (pauses(game)) return Change::none;
  if (!under_way(game.state())) return move_to(false);

  const Identity identity{.opponent = game.opponent().number(),
                          .half = game.half(),
                          .shoot_out = game.phase() == pb::GameState::PHASE_PENALTY_SHOOT_OUT};
  const bool other = identity != identity_;
  identity_ = identity;
  if (move_to(true) == Change::began) return Change::began;
  return other ? Change::another : Change::none;
}

std::string session_name(const pb::GameState& game, std::string_view field, std::string_view build) {
  std::string name;
  const auto add = [&](const std::string& part) { name += (name.empty() ? "" : "_") + part; };
  if (!field.empty()) add(std::string(field));
  if (game.has_opponent()) add("vs-" + std::to_string(game.opponent().number()));
  const std::string half = std::to_string(game.half());
  if (game.unreadable()) {
    add("format-" + std::to_string(game.packet_version()));
  } else if (game.phase() == pb::GameState::PHASE_PENALTY_SHOOT_OUT) {
    add("shoot-out");
  } else {
    add((game.phase() == pb::GameState::PHASE_OVERTIME ? "overtime-" : "half-") + half);
  }
  add(std::to_string(game.own_team()) + "-" + std::to_string(game.own_player()));
  add(std::string(build));
  return name;
}

}  // namespace robot::game
