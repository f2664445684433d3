// Whatever is broadcast at a field: every packet is read or refused, by either team.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "robot/game/control_packet.h"
#include "robot/game/match.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace game = robot::game;
  const auto packet = game::parse_control_packet({reinterpret_cast<const char*>(data), size});
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
