#include "robot/game/send_guard.h"

#include <algorithm>

#include "robot/game/match.h"

namespace robot::game {
namespace {

constexpr float kHalfSeconds = 600;

/// Returns the time until the end of the game [s], without extra time.
float seconds_left(const pb::GameState& game) {
  return std::max(0.f, game.seconds_remaining()) + (game.half() == 1 ? kHalfSeconds : 0);
}

}  // namespace

void SendGuard::hear(const pb::GameState& game) {
  const bool known = game_.own().has_message_budget() && game.own().has_message_budget();
  const std::uint32_t before = game_.own().message_budget(), now = game.own().message_budget();
  const bool another = game.opponent().number() != game_.opponent().number() || now > before + kReserve;
  game_ = game;
  if (!known || another) {
    // extra time adds some messages and another game resets the budget: earlier counts are void
    counted_ = spent_ = 0;
    return;
  }
  spent_ += before - std::min(before, now);
  if (stopped_.empty() && spent_ > counted_ + slack(counted_))
    stopped_ = "sending has stopped: the GameController's message budget fell by " + std::to_string(spent_) +
               ", but only " + std::to_string(counted_) + " messages of the team were sent or heard";
}

void SendGuard::hear_double(const std::string& who) {
  if (stopped_.empty()) stopped_ = "sending has stopped: " + who + " also sends as our player; only one of us may";
}

std::uint64_t SendGuard::interval_ns() const {
  if (!game_.own().has_message_budget()) return kLeastIntervalNs;
  const auto left = static_cast<float>(game_.own().message_budget() - kReserve);
  const auto players = static_cast<float>(std::max(1u, game_.players_per_team()));
  const auto share_ns = static_cast<std::uint64_t>(seconds_left(game_) * players / left * 1e9f);
  return std::max(kLeastIntervalNs, share_ns);
}

bool SendGuard::may_send(std::uint64_t now_ns, std::uint64_t last_ns) const {
  if (!stopped_.empty() || !under_way(game_.state())) return false;
  if (game_.own().has_message_budget() && game_.own().message_budget() <= kReserve) return false;
  return last_ns == 0 || now_ns >= last_ns + interval_ns();
}

}  // namespace robot::game
