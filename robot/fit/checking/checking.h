// The check of models: the situations of recordings, simulated with them.
#pragma once

#include "robot/fit/checking/checks.h"
#include "robot/fit/evidence.h"
#include "robot/fit/report.h"

namespace robot::fit {

/// The situations that recordings show.
struct Situations {
  Drives drives;
  std::vector<KickFit> kicks;
  std::vector<Roll> rolls;
  FallsSeen falls;
  std::vector<TeamRecord> packets;
  Looks looks;
  BallPlaces balls;
};

/// Reads the situations. The models give the places of kicks and the sizes of robots.
Situations read_situations(const Evidence& evidence, const sim::Models& models);

/// Compares recordings with simulations of the same situations: the commands of robots, their kicks, free rolls, times at risk
/// of falling, packets, and images of balls. No behaviour is simulated, since that of a real team is not known.
///
/// The report has no figures. Its results are a row for each statistic: the recorded value, the simulated interval, and "inside" or
/// "OUTSIDE". With right models all are inside in 95 % of recordings. `scores` has the counts `statistics` and `outside`, `notes`
/// the situations that the recordings do not show. Each recording of a robot draws a pace of its own. The same for the same recordings.
Report check_models(const Evidence& evidence, const sim::Models& models);

/// The same from situations.
Report check_models(const Situations& situations, const sim::Models& models);

}  // namespace robot::fit
