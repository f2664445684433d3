// Any bytes as a snapshot, damaged or with a matching hash: a refusal, or a state that can be stored and read again.
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "sim/match/hash.h"
#include "sim/match/snapshot.h"

namespace {

void check(std::span<const std::uint8_t> bytes) {
  const sim::Restored restored = sim::restore(bytes);
  if (restored.state.has_value() == !restored.refusal.empty()) std::abort();
  if (!restored.state) return;
  const sim::Restored again = sim::restore(sim::snapshot_of(*restored.state));
  if (!again.state || sim::hash_of(*again.state) != sim::hash_of(*restored.state)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check({data, size});

  // the input written over a good snapshot from the place that its first two bytes name, and sealed again
  if (size < 3) return 0;
  sim::State state;
  state.world.players = 4;
  std::vector<std::uint8_t> bytes = sim::snapshot_of(state);
  const std::size_t at = (data[0] + 256u * data[1]) % bytes.size();
  for (std::size_t i = 2; i < size && at + i - 2 < bytes.size(); ++i) bytes[at + i - 2] = data[i];
  sim::seal(bytes);
  check(bytes);
  return 0;
}
