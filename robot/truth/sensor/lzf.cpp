#include "robot/truth/sensor/lzf.h"

#include <cstdint>

#include "robot/core/little_endian.h"

namespace robot::truth {

Result<std::string> unpack_lzf(std::string_view packed, std::size_t size) {
  const Error other_size{"expected LZF data of " + std::to_string(size) + " bytes, got fewer or more"};
  std::string out;
  out.reserve(size);
  ByteReader reader(packed);
  while (!reader.rest().empty()) {
    const auto control = reader.number<std::uint8_t>();
    // up to 32 bytes as they are
    if (control < 32) {
      out.append(reader.take(control + std::size_t{1}));
      if (out.size() > size) return other_size;
      continue;
    }
    // 3 to 264 bytes that came before; they may overlap the new ones
    std::size_t length = (control >> 5) + std::size_t{2};
    if (length == 9) length += reader.number<std::uint8_t>();
    const std::size_t back = (control & 31u) * std::size_t{256} + reader.number<std::uint8_t>() + 1;
    if (back > out.size()) return Error{"expected LZF data, got a reference to bytes before the first one"};
    if (length > size - out.size()) return other_size;
    for (; length > 0; --length) out.push_back(out[out.size() - back]);
  }
  if (!reader.finished() || out.size() != size) return other_size;
  return out;
}

}  // namespace robot::truth
