#include "robot/bridge/player_map.h"

#include <algorithm>
#include <set>

namespace robot::bridge {

std::uint32_t keeper_of(const pb::TeamState& team) { return team.goalkeeper() != 0 ? team.goalkeeper() : 1; }

PlayerMap::PlayerMap(const pb::TeamState& team, int places) {
  std::set<std::uint32_t> playing;
  for (int i = 0; i < team.players_size(); ++i)
    if (team.players(i).penalty() != pb::PlayerState::PENALTY_SUBSTITUTE)
      playing.insert(static_cast<std::uint32_t>(i) + 1);
  for (int place = 1; team.players_size() == 0 && place <= places; ++place)
    playing.insert(static_cast<std::uint32_t>(place));

  const bool has_keeper = playing.erase(keeper_of(team)) == 1;
  if (has_keeper) players_.front() = keeper_of(team);
  // without a keeper the goal stays empty, unless a player would have no place
  const bool first_is_free = !has_keeper && static_cast<int>(playing.size()) >= places;
  for (int place = first_is_free ? 1 : 2; place <= places && !playing.empty(); ++place)
    players_[static_cast<std::size_t>(place - 1)] = playing.extract(playing.begin()).value();
}

int PlayerMap::place_of(std::uint32_t player) const {
  const auto found = std::find(players_.begin(), players_.end(), player);
  return player == 0 || found == players_.end() ? 0 : static_cast<int>(found - players_.begin()) + 1;
}

std::string PlayerMap::text() const {
  std::set<std::uint32_t> numbers(players_.begin(), players_.end());
  numbers.erase(0);
  std::string text;
  for (const std::uint32_t number : numbers) text += (text.empty() ? "" : ", ") + std::to_string(number);
  return text;
}

}  // namespace robot::bridge
