// Fitted figures as models of the simulator.
#include <utility>

#include "robot/app/fit/fits.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/io/models.h"

namespace robot::app {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the entry of a model file that `name` leads to ("ball.deceleration"), or null if the models have none.
const Json* entry_at(const Json& models, const std::string& name) {
  const Json* at = &models;
  for (const std::string_view part : split(name, ".")) {
    if (!at->is_object() || !at->contains(part)) return nullptr;
    at = &(*at)[part];
  }
  return at;
}

/// Returns the first names, and the number of the others.
std::string names_of(const std::vector<std::string>& recordings) {
  constexpr std::size_t kMost = 3;
  if (recordings.size() <= kMost) return joined(recordings, ", ");
  return joined({recordings.begin(), recordings.begin() + kMost}, ", ") +
         formatted(" and %zu more", recordings.size() - kMost);
}

/// Returns the value with six digits: more than any fit knows.
double rounded(double value) { return std::stod(formatted("%.6g", value)); }

Json entry_of(const fit::Figure& figure, const Json& before) {
  const std::string source = before.value("source", "");
  const std::string old = formatted("%.4g", before.value("value", 0.)) + (source.empty() ? "" : ", " + source);
  return {{"value", rounded(figure.value)},
          {"unit", figure.unit},
          {"source", "fitted to " + names_of(figure.recordings) + ": " + to_text(figure) + "; before: " + old}};
}

}  // namespace

Result<std::string> fitted_models(const Fits& fits, const std::string& base, const std::string& name) {
  sim::io::Sources sources;
  const auto models = sim::io::load_models(base, &sources);
  if (!models) return models.failure();
  const Json known = Json::parse(sim::io::print_models(*models, sources));
  Json fitted{{"name", name},
              {"about", "Fitted to recordings by foresight-lab fit; every other figure is that of " + base + "."},
              {"based_on", base}};
  for (const fit::Figure& figure : fits.figures()) {
    const Json* before = entry_at(known, figure.name);
    if (!before || !figure.is_known()) continue;
    Json* into = &fitted;
    for (const std::string_view part : split(figure.name, ".")) into = &(*into)[std::string(part)];
    *into = entry_of(figure, *before);
  }
  // a table would replace the fitted rates
  if (models->motion.falls.table.given && fitted.contains("falls"))
    if (const Json& falls = fitted["falls"];
        falls.contains("per_minute_walking") || falls.contains("per_second_touching"))
      fitted["falls"]["table"] = false;
  const std::string text = fitted.dump(2) + "\n";
  if (const auto read = sim::io::parse_models(text, "fitted models"); !read) return read.failure();
  return text;
}

}  // namespace robot::app
