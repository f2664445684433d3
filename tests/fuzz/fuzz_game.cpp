// Any broadcast at a field: every packet of the GameController and of teammates is read or refused.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "robot/game/control_packet.h"
#include "robot/game/match.h"
#include "robot/game/team_message.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace game = robot::game;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (const auto message = game::parse_team_message(bytes, 1))
    if (!game::parse_team_message(game::to_bytes(*message, 1), 1))
      __builtin_trap();  // a message that was read can be sent again
  const auto packet = game::parse_control_packet(bytes);
  const auto unreadable = game::unreadable_game(bytes, 14, 1);
  if (packet && unreadable) __builtin_trap();  // a packet cannot be both
  if (unreadable) {
    game::Match match;
    if (match.update(*unreadable, 1) != game::Match::Change::began) __builtin_trap();
    static_cast<void>(game::session_name(*unreadable, "A", "build"));
  }
  if (!packet) return 0;
  for (const auto& team : packet->teams) {
    const auto seen = game::seen_by(*packet, team.number(), 1);
    if (!seen) __builtin_trap();  // a team of the packet must find itself in it
    game::Match match;
    match.update(*seen, 1);
    static_cast<void>(game::session_name(*seen, "A", "build"));
  }
  return 0;
}
