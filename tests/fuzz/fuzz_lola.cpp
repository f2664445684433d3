// Any bytes from LoLA's socket are frames or are refused. A reader that has read other frames before gives the same result.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "robot/nao/lola/sensors.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using robot::nao::SensorFrames, robot::nao::Sensors;
  std::string_view bytes(reinterpret_cast<const char*>(data), size);
  SensorFrames experienced;
  while (true) {
    const auto first = SensorFrames().size_of_first(bytes);
    const auto again = experienced.size_of_first(bytes);
    if (static_cast<bool>(first) != static_cast<bool>(again) || (first && *first != *again)) __builtin_trap();
    if (!first || *first == 0) return 0;

    SensorFrames fresh;
    Sensors by_experienced, by_fresh;
    const bool read = static_cast<bool>(experienced.read(bytes.substr(0, *first), by_experienced));
    if (static_cast<bool>(fresh.read(bytes.substr(0, *first), by_fresh)) != read) __builtin_trap();
    if (read && std::memcmp(&by_experienced, &by_fresh, sizeof by_fresh) != 0) __builtin_trap();
    bytes.remove_prefix(*first);
  }
}
