// All models that foresight-lab fit knows, fitted to the recordings of a team.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/fit/ball_distance/ball_distance.h"
#include "robot/fit/kicks/kicks.h"
#include "robot/fit/report.h"
#include "robot/fit/rolling/rolling.h"

namespace robot::app {

/// The names for --only, in the order of the report.
const std::vector<std::string>& names_of_fits();

/// All fits that the recordings carry.
struct Fits {
  std::optional<fit::BallDistance> ball_distance;
  std::optional<fit::Rolling> rolling;
  std::optional<fit::Kicks> kicks;
  std::vector<fit::Report> reports;   // of the fits that report alike
  std::vector<std::string> kept;      // one sentence for each model that stays as it is
  std::vector<std::string> left_out;  // one sentence for each recording that could not be used

  /// Reports whether there is no fitted figure.
  bool empty() const { return figures().empty(); }
  /// Returns all fitted figures.
  std::vector<fit::Figure> figures() const;
  /// Returns the tables behind the fits by name.
  std::vector<std::pair<std::string, fit::Table>> tables() const;
};

/// Fits the models named in `only`, or all if it is empty. `base` is the name or the file of models. They give the facts that are
/// not fitted: the places of the ball for a kick, and the deceleration if no rolls show it. Returns an Error for an unknown name.
Result<Fits> fit_all(const fit::Evidence& evidence, const std::vector<std::string>& only, const std::string& base);

/// Returns what should be recorded next, for all fits. Returns an Error if `base` cannot be loaded.
Result<std::vector<fit::Need>> needs_of(const fit::Evidence& evidence, const std::string& base);

/// Simulates the recorded situations with the models `base`, a name or a file (robot/fit/checking). Returns an Error if they cannot
/// be loaded.
Result<fit::Report> check(const fit::Evidence& evidence, const std::string& base);

/// Formats the fits for a terminal, or as JSON.
std::string to_text(const Fits& fits);
nlohmann::ordered_json to_json(const Fits& fits);

/// Returns a single HTML file without scripts, which needs no other file: pictures first, then tables.
std::string page_of(const Fits& fits);

/// Returns a page of a check of the models `base`.
std::string page_of_check(const fit::Report& report, const std::string& base);

/// Returns a description of models (sim/io/models.h): those of `base` with the fitted figures that the simulator has and that
/// are known well enough. The
/// source of each one says what it was fitted to, and keeps the old value and source. Returns an Error if `base` cannot be
/// loaded or if a figure is outside its range.
Result<std::string> fitted_models(const Fits& fits, const std::string& base, const std::string& name);

}  // namespace robot::app
