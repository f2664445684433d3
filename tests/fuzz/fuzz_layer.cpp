// Any layer of learning, and any strategy with marks: a result that can be used, or an error sentence.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "robot/core/json_library.h"
#include "sim/io/strategy.h"
#include "sim/learn/edit.h"
#include "sim/learn/knobs.h"
#include "sim/learn/layer.h"

namespace {

using sim::io::Json;

bool plays(const Json& strategy) { return static_cast<bool>(sim::io::parse_strategy(strategy.dump(), "strategy")); }

/// Each knob of a strategy can be turned to both ends, and the strategy still plays.
void turn_knobs(const Json& strategy) {
  const auto knobs = sim::learn::knobs_of(strategy);
  if (!knobs) std::abort();
  for (const bool up : {false, true}) {
    std::vector<float> values;
    for (const sim::learn::Knob& knob : *knobs) values.push_back(rounded(knob, up ? knob.most : knob.least));
    if (!plays(sim::learn::with_values(strategy, *knobs, values))) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto layer = sim::learn::parse_layer(bytes, "layer 'fuzz'", "fuzz");
  const auto strategy = sim::io::flattened(bytes, "strategy 'fuzz'");
  if (strategy) turn_knobs(*strategy);
  if (layer)
    for (const sim::learn::LeafRule& leaf :
         leaves_of(*sim::io::flattened(R"({"name": "s", "tree": {"do": "kick"}})", "s"), *layer))
      if (leaf.alternatives.size() > layer->actions.size()) std::abort();
  return 0;
}
