// Five bytes are one event for a guardian, and one cycle. No stream of events may break its laws.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

#include "tests/support/guardian_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tests::GuardianLaws laws;
  for (; size >= 5; data += 5, size -= 5) {
    std::uint32_t details = 0;
    std::memcpy(&details, data + 1, 4);
    // the highest bits of the first byte: number of cycles without another event
    std::string broken = laws.step(data[0] % 40, details);
    for (int quiet = data[0] / 40 * 40; quiet > 0 && broken.empty(); --quiet) broken = laws.step(39, 0);
    if (broken.empty()) continue;
    std::fprintf(stderr, "%s\n", broken.c_str());
    __builtin_trap();
  }
  return 0;
}
