#include "robot/app/fit/fits.h"

#include <algorithm>
#include <utility>

#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "robot/fit/ball_noise/ball_noise.h"
#include "robot/fit/ball_noise/latency.h"
#include "robot/fit/checking/checking.h"
#include "robot/fit/falling/falling.h"
#include "robot/fit/localisation/localisation.h"
#include "robot/fit/localisation/odometry.h"
#include "robot/fit/opponents/opponents.h"
#include "robot/fit/plan.h"
#include "robot/fit/radio/radio.h"
#include "robot/fit/rebounds/rebounds.h"
#include "robot/fit/visibility/false_balls.h"
#include "robot/fit/visibility/visibility.h"
#include "robot/fit/walking/walking.h"
#include "sim/io/models.h"

namespace robot::app {
namespace {

nlohmann::ordered_json json_of(const fit::Figure& figure) {
  return {{"value", figure.value},
          {"unit", figure.unit},
          {"low", figure.low},
          {"high", figure.high},
          {"known", figure.is_known()},
          {"events", figure.events},
          {"kind", figure.kind},
          {"recordings", figure.recordings},
          {"domain",
           {{"quantity", figure.domain.quantity},
            {"unit", figure.domain.unit},
            {"from", figure.domain.from},
            {"to", figure.domain.to}}}};
}

nlohmann::ordered_json json_of(const fit::HeldOut& held_out) {
  const lab::ErrorFigures& errors = held_out.errors;
  return {{"curve", held_out.curve}, {"from", held_out.from},   {"to", held_out.to}, {"images", errors.samples},
          {"mean", errors.mean},     {"median", errors.median}, {"p95", errors.p95}, {"bias", held_out.bias}};
}

bool is_wanted(const std::string& name, const std::vector<std::string>& only) {
  return only.empty() || std::ranges::find(only, name) != only.end();
}

/// Makes a fit if it is wanted. A refusal becomes a sentence.
template <class Make>
auto made(const std::string& name, const std::vector<std::string>& only, Make&& make, std::vector<std::string>& kept) {
  using Made = std::optional<std::decay_t<decltype(*make())>>;
  if (!is_wanted(name, only)) return Made{};
  auto fit = make();
  if (fit) return Made{std::move(*fit)};
  kept.push_back(name + ": " + fit.error());
  return Made{};
}

/// The recordings for fits that report alike. Readings that several fits share are made once, when the first one wants them.
class Readings {
 public:
  Readings(const fit::Evidence& recordings, const sim::Models& base) : evidence(recordings), models(base) {}

  const fit::BallPlaces& ball_places() {
    if (!ball_places_) ball_places_ = fit::read_ball_places(evidence);
    return *ball_places_;
  }
  const fit::Looks& looks() {
    if (!looks_) looks_ = fit::read_looks(evidence, models);
    return *looks_;
  }

  const fit::Evidence& evidence;
  const sim::Models& models;

 private:
  std::optional<fit::BallPlaces> ball_places_;
  std::optional<fit::Looks> looks_;
};

/// A fit that reports as all do.
struct Reporting {
  const char* name;
  fit::Report (*make)(Readings& readings);
};
constexpr Reporting kReporting[] = {
    {"walk", [](Readings& all) { return fit::fit_walking(all.evidence, all.models); }},
    {"ball_noise", [](Readings& all) { return fit::fit_ball_noise(all.ball_places(), all.models); }},
    {"latency", [](Readings& all) { return fit::fit_latency(all.ball_places(), all.models); }},
    {"visibility", [](Readings& all) { return fit::fit_visibility(all.looks(), all.models); }},
    {"false_balls", [](Readings& all) { return fit::false_balls_of(all.looks(), all.models); }},
    {"odometry", [](Readings& all) { return fit::fit_odometry(all.evidence, all.models); }},
    {"localisation", [](Readings& all) { return fit::fit_localisation(all.evidence, all.models); }},
    {"rebounds", [](Readings& all) { return fit::fit_rebounds(all.evidence, all.models); }},
    {"falls", [](Readings& all) { return fit::fit_falling(all.evidence, all.models); }},
    {"radio", [](Readings& all) { return fit::fit_radio(all.evidence, all.models); }},
    {"opponents", [](Readings& all) { return fit::fit_opponents(all.evidence, all.models); }},
};

Result<void> check_names(const std::vector<std::string>& only) {
  const std::vector<std::string>& names = names_of_fits();
  for (const std::string& name : only)
    if (std::ranges::find(names, name) == names.end())
      return Error{"--only: expected " + joined(names, ", ") + ", got '" + printable(name, 40) + "'"};
  return {};
}

/// Adds a sentence for each figure that is known too loosely.
void keep_loose(Fits& fits) {
  for (const fit::Figure& figure : fits.figures())
    if (!figure.is_known())
      fits.kept.push_back(formatted("%s: it is known to ± %.2g%s%s only, and stays", figure.name.c_str(),
                                    (figure.high - figure.low) / 2, figure.unit.empty() ? "" : " ",
                                    figure.unit.c_str()));
}

}  // namespace

const std::vector<std::string>& names_of_fits() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"ball_distance", "rolling", "kicks"};
    for (const Reporting& one : kReporting) all.emplace_back(one.name);
    return all;
  }();
  return names;
}

std::vector<fit::Figure> Fits::figures() const {
  std::vector<fit::Figure> all;
  if (ball_distance) all = ball_distance->figures;
  if (rolling) all.push_back(rolling->deceleration);
  if (kicks) {
    for (const fit::KickFit& kick : kicks->fits) all.insert(all.end(), kick.figures.begin(), kick.figures.end());
    all.push_back(kicks->partial);
  }
  for (const fit::Report& report : reports) all.insert(all.end(), report.figures.begin(), report.figures.end());
  return all;
}

std::vector<std::pair<std::string, fit::Table>> Fits::tables() const {
  std::vector<std::pair<std::string, fit::Table>> all;
  if (ball_distance) all.emplace_back("ball_distance", table_of(*ball_distance));
  if (rolling) all.emplace_back("rolling", table_of(*rolling));
  if (kicks)
    for (const fit::KickFit& kick : kicks->fits)
      all.emplace_back("kick_" + kick.kind, table_of(kick, kicks->recordings));
  for (const fit::Report& report : reports) all.insert(all.end(), report.tables.begin(), report.tables.end());
  return all;
}

Result<Fits> fit_all(const fit::Evidence& evidence, const std::vector<std::string>& only, const std::string& base) {
  if (const auto checked = check_names(only); !checked) return checked.failure();
  auto models = sim::io::load_models(base);
  if (!models) return models.failure();
  Fits fits;
  fits.left_out = evidence.left_out;
  fits.ball_distance = made(
      "ball_distance", only, [&] { return fit::fit_ball_distance(fit::read_ball_sizes(evidence)); }, fits.kept);
  fits.rolling = made(
      "rolling", only, [&] { return fit::fit_rolling(evidence); }, fits.kept);
  if (fits.rolling) {
    fits.kept.push_back(fits.rolling->kept);
    models->ball.deceleration = static_cast<float>(fits.rolling->deceleration.value);
  }
  fits.kicks = made(
      "kicks", only, [&] { return fit::fit_kicks(evidence, fit::kick_facts_of(*models)); }, fits.kept);
  if (fits.kicks) fits.kept.insert(fits.kept.end(), fits.kicks->kept.begin(), fits.kicks->kept.end());
  Readings readings(evidence, *models);
  for (const Reporting& one : kReporting) {
    if (!is_wanted(one.name, only)) continue;
    fit::Report& report = fits.reports.emplace_back(one.make(readings));
    fits.kept.insert(fits.kept.end(), report.kept.begin(), report.kept.end());
  }
  keep_loose(fits);
  return fits;
}

Result<std::vector<fit::Need>> needs_of(const fit::Evidence& evidence, const std::string& base) {
  const auto models = sim::io::load_models(base);
  if (!models) return models.failure();
  std::vector<fit::Need> needs = fit::plan(evidence, fit::kick_facts_of(*models));
  Readings readings(evidence, *models);
  for (const Reporting& one : kReporting) {
    const fit::Report report = one.make(readings);
    needs.insert(needs.end(), report.needs.begin(), report.needs.end());
  }
  return needs;
}

Result<fit::Report> check(const fit::Evidence& evidence, const std::string& base) {
  const auto models = sim::io::load_models(base);
  if (!models) return models.failure();
  return fit::check_models(evidence, *models);
}

std::string to_text(const Fits& fits) {
  std::string text;
  if (fits.ball_distance) text += to_text(*fits.ball_distance) + '\n';
  if (fits.rolling) text += to_text(*fits.rolling) + '\n';
  if (fits.kicks) text += to_text(*fits.kicks) + '\n';
  for (const fit::Report& report : fits.reports)
    if (!report.empty() || !report.results.empty()) text += to_text(report) + '\n';
  for (const std::string& sentence : fits.kept) text += "kept      " + sentence + '\n';
  for (const std::string& sentence : fits.left_out) text += "left out  " + sentence + '\n';
  return text;
}

nlohmann::ordered_json to_json(const Fits& fits) {
  nlohmann::ordered_json json{{"figures", nlohmann::ordered_json::object()}};
  for (const fit::Figure& figure : fits.figures()) json["figures"][figure.name] = json_of(figure);
  if (fits.ball_distance) {
    auto& held_out = json["ball_distance"]["held_out"] = nlohmann::ordered_json::array();
    for (const fit::HeldOut& errors : fits.ball_distance->held_out) held_out.push_back(json_of(errors));
  }
  if (fits.rolling) json["rolling"]["spread"] = fits.rolling->spread;
  if (fits.kicks)
    for (const fit::KickFit& kick : fits.kicks->fits)
      json["kicks"][kick.kind] = {{"kicks", kick.kicks.size()},
                                  {"out_of_place", kick.out_of_place},
                                  {"disturbed", kick.disturbed},
                                  {"missed", kick.missed},
                                  {"covered", kick.covered},
                                  {"crps", kick.crps},
                                  {"constant_error", kick.constant_error}};
  for (const fit::Report& report : fits.reports)
    for (const auto& [name, score] : report.scores) json[report.name][name] = score;
  json["kept"] = fits.kept;
  json["left_out"] = fits.left_out;
  return json;
}

}  // namespace robot::app
