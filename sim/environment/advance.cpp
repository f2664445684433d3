#include "sim/environment/advance.h"

#include "sim/match/step.h"

namespace sim::environment {

void advance(const Params& params, State* const* games, referee::Events* events, int count) {
  for (int i = 0; i < count; ++i) step(params, *games[i], events[i]);
}

}  // namespace sim::environment
