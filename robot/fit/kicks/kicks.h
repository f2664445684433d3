// How each kind of kick sends the ball.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/fit/evidence.h"
#include "robot/fit/figure.h"
#include "robot/fit/kicks/kick_model.h"
#include "sim/match/params.h"

namespace robot::fit {

/// The facts about kicks that are not fitted.
struct KickFacts {
  std::vector<KickKind> kinds;
  double deceleration = 0.3;  // [m/s²] of the ball
  double spread = 1;          // see KickModel::density
};

/// Returns the facts of the models.
KickFacts kick_facts_of(const sim::Models& models);

/// One kind of kick.
struct KickFit {
  std::string kind;
  std::vector<TrackedKick> kicks;  // in place and undisturbed
  std::size_t out_of_place = 0, disturbed = 0, missed = 0;
  std::vector<double> durations;  // [s] of all runs with a reported end, also of disturbed ones
  double status_step = 0;         // [s] greatest time between two messages of the motion status at their begin
  KickModel model;
  std::vector<Figure>
      figures;         // range [m], range_deviation, direction [rad], direction_deviation [rad], delay [s]; habits
  Figure partial;      // hits.partial, by the kicks of this kind
  double slowest = 0;  // [m/s] of the kicks that count
  // on kicks held out, each fifth in turn
  double covered = 0;         // [0..1] share that lands in the region of 90 %
  double crps = 0;            // [m] of the landing distance
  double constant_error = 0;  // [m] of a constant, which has no better score
};

struct Kicks {
  std::vector<std::string> recordings;  // names of those with a kick, by index
  std::vector<KickFit> fits;
  Figure partial;                 // hits.partial of all kinds: the mean by the width of their intervals
  std::vector<std::string> kept;  // one sentence for each kind that was seen and cannot be fitted
};

/// Returns the kicks of each kind that was seen, not fitted yet. `recordings` receives the names of the recordings with a kick.
std::vector<KickFit> seen_kicks(const Evidence& evidence, const KickFacts& facts, std::vector<std::string>& recordings);

/// Fits each kind of kick that was seen often enough. The interval of a figure covers the luck of kicks. Returns an Error if no
/// kind can be fitted.
Result<Kicks> fit_kicks(const Evidence& evidence, const KickFacts& facts);

/// As fit_kicks() for one kind. Returns an Error with fewer than 15 kicks.
Result<KickFit> fit_kind(KickFit seen, const std::vector<std::string>& recordings, const KickFacts& facts);

/// Returns the kicks of one kind that count.
Table table_of(const KickFit& fit, const std::vector<std::string>& recordings);
std::string to_text(const Kicks& kicks);

}  // namespace robot::fit
