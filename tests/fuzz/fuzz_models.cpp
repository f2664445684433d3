// Any models file: models that print and read back, or an error sentence.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/io/models.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto models = sim::io::parse_models(bytes, "models 'fuzz'");
  if (!models) return 0;
  const std::string printed = sim::io::print_models(*models);
  const auto again = sim::io::parse_models(printed, "models 'again'");
  if (!again || sim::io::print_models(*again) != printed) std::abort();
  return 0;
}
