// Any strategy file: a tree that leads every decision to a leaf, or an error sentence.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/io/strategy.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace agent = sim::agent;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto tree = sim::io::parse_strategy(bytes, "strategy 'fuzz'");
  if (!tree) return 0;

  // every path leads to earlier nodes, and finally to a leaf
  const auto leads_on = [&](std::uint16_t to, std::size_t before) {
    return to & agent::kLeafBit ? (to & ~agent::kLeafBit) < static_cast<int>(tree->leaves.size()) : to < before;
  };
  if (!leads_on(tree->root, tree->nodes.size())) std::abort();
  for (std::size_t i = 0; i < tree->nodes.size(); ++i)
    if (!leads_on(tree->nodes[i].yes, i) || !leads_on(tree->nodes[i].no, i)) std::abort();
  return 0;
}
