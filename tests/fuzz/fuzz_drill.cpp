// Any drill, policy or options of an environment: a result that can be used, or an error sentence.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/agent/net.h"
#include "sim/drills/drill.h"
#include "sim/drills/starts.h"
#include "sim/environment/options.h"
#include "sim/io/matchup.h"
#include "sim/io/policy.h"
#include "sim/match/snapshot.h"

namespace {

/// A start must be a state that can be played on.
void start(const sim::drills::Drill& drill) {
  static const auto game = sim::io::prepare({});
  const auto starts = sim::drills::Starts::prepare(drill, game->params);
  if (starts && !sim::restore(sim::snapshot_of(starts->draw(game->params, {1}))).state) std::abort();
}

/// A net must give an output for each rule of the menu.
void evaluate(const sim::agent::PolicyBehaviour& policy) {
  const float inputs[sim::agent::kMaxWidth] = {};
  float outputs[sim::agent::kMaxWidth];
  sim::agent::evaluate(policy.net(), inputs, outputs);
  if (policy.net().outputs() != static_cast<int>(policy.frame().tree.menu.size())) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (const auto drill = sim::drills::parse_drill(bytes, "drill 'fuzz'")) start(*drill);
  if (const auto policy = sim::io::parse_policy(bytes, "strategy 'fuzz'")) evaluate(*policy);
  if (const auto options = sim::environment::read_options(bytes); options && options->frame.columns.count() == 0)
    std::abort();
  return 0;
}
