// All years: the game ends at once when one side leads by Rules::mercy_goals.
#pragma once

#include "sim/referee/court.h"

namespace sim::referee::mercy {

inline bool due(const Court& court) {
  const int lead = court.book.score[0] - court.book.score[1];
  return court.rules.mercy_goals > 0 && std::abs(lead) >= court.rules.mercy_goals;
}

inline void apply(Court& court) { finish(court); }

}  // namespace sim::referee::mercy
