#include "robot/foresight/following.h"

#include <algorithm>

namespace robot::foreseeing {

using sim::agent::kNoStrategy;

void Following::hear(const pb::Team& team, int captain, int player, const bridge::Moment& now) {
  for (const pb::Teammate& mate : team.teammates()) {
    const int sender = static_cast<int>(mate.player());
    const bool stale = now.since(mate.received_ns()) >= kStaleNs || now.is_before(mate.received_ns());
    const bool known = mate.has_strategy() && static_cast<int>(mate.strategy()) < strategies_;
    if (sender == player || stale || !known) continue;
    const bool followed = choice_.strategy != kNoStrategy;
    const sim::agent::Choice heard{static_cast<std::uint8_t>(mate.strategy()), static_cast<std::uint8_t>(mate.epoch())};
    if (!follow(heard, sender == captain, choice_)) continue;
    told_ns_ = followed ? std::max(told_ns_, mate.received_ns()) : mate.received_ns();
  }
}

void Following::forget(const bridge::Moment& now, std::uint64_t period_ns) {
  if (now.is_before(told_ns_)) choice_ = {}, told_ns_ = 0;
  if (now.since(told_ns_) >= kStaleNs + period_ns) let_go(choice_);
}

void Following::choose(int strategy, std::uint64_t told_ns) {
  sim::agent::choose(static_cast<std::uint8_t>(strategy), choice_);
  told_ns_ = told_ns;
}

}  // namespace robot::foreseeing
