// Writes logs in the Northern Bites' format, nblog version 7, for tests without the real ones.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tests {

class NblogWriter {
 public:
  /// Adds one block. `values` are the fields of its header after type, time and size, such as "(width 4) (height 2)".
  void block(std::string_view type, std::string_view from, std::uint64_t when_us, std::string_view values,
             std::string_view bytes);

  /// The whole file.
  std::string file() const;

 private:
  std::string contents_, payload_;
};

/// A protobuf message with the float fields 1, 2, 3, ...
std::string float_fields(const std::vector<float>& values);

}  // namespace tests
