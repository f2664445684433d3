#include "sim/check/scenario.h"

#include <algorithm>
#include <filesystem>

#include "robot/core/folder.h"
#include "robot/core/json_library.h"
#include "sim/io/reader.h"
#include "sim/io/source.h"
#include "sim/io/words.h"

namespace sim::check {

using io::Fields;
using io::Json;
using io::Reader;
using robot::Error;
using robot::Result;

namespace {

constexpr std::size_t kMostMetrics = 64, kMostEvents = 64;

/// The numbers of "check".
struct Numbers {
  float seconds = 20;
  int seeds = 100, players = 0;
  bool fuzz = false;

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("seconds", self.seconds, "", 0.1f, 3600.f);
    see("seeds", self.seeds, "", 2, 1'000'000);
    see("players", self.players, "", 0, kMaxPlayers);
    see("fuzz", self.fuzz, "", false, true);
  }
};

void read_metrics(Reader& reader, const Json& check, std::vector<NamedMetric>& into) {
  const Json* metrics = reader.find(check, "metrics", Fields::some);
  if (!metrics) return reader.refuse("check.metrics is missing");
  if (!reader.is_object(*metrics, "check.metrics")) return;
  if (metrics->empty() || metrics->size() > kMostMetrics)
    return reader.refuse("check.metrics must have 1 .. 64 entries, got " + std::to_string(metrics->size()));
  for (const auto& [name, text] : metrics->items()) {
    const std::string path = "check.metrics." + name;
    if (!text.is_string()) return reader.refuse(path + " must be a text, got " + io::shown(text));
    Result<Metric> metric = parse_metric(text.get_ref<const std::string&>());
    if (!metric) return reader.refuse(path + ": " + metric.error());
    into.push_back({.name = name, .text = text.get<std::string>(), .metric = std::move(*metric)});
  }
}

void read_limit(Reader& reader, const Json& limits, const std::string& path, const char* key,
                std::optional<double>& into) {
  const auto found = limits.find(key);
  if (found == limits.end()) return;
  if (!found->is_number()) return reader.refuse(path + "." + key + " must be a number, got " + io::shown(*found));
  into = found->get<double>();
}

void read_expectations(Reader& reader, const Json& check, std::vector<NamedMetric>& metrics) {
  const Json* expect = reader.find(check, "expect", Fields::some);
  if (!expect || !reader.is_object(*expect, "check.expect")) return;
  std::vector<std::string_view> known;
  for (const NamedMetric& metric : metrics) known.emplace_back(metric.name);
  for (const auto& [name, limits] : expect->items()) {
    const std::string path = "check.expect." + name;
    const auto metric = std::ranges::find(metrics, name, &NamedMetric::name);
    if (metric == metrics.end()) return reader.refuse(path + " names no metric" + io::hint(name, known));
    if (!reader.is_object(limits, path)) return;
    reader.refuse_unknown(limits, path, {"at_least", "at_most"});
    if (limits.empty()) return reader.refuse(path + " must have at_least or at_most");
    read_limit(reader, limits, path, "at_least", metric->at_least);
    read_limit(reader, limits, path, "at_most", metric->at_most);
  }
}

void read_events(Reader& reader, const Json& check, int players, const io::SituationTeams& teams,
                 std::vector<Event>& into) {
  const Json* events = reader.find(check, "events", Fields::some);
  if (!events) return;
  if (!events->is_array() || events->size() > kMostEvents)
    return reader.refuse("check.events must be a list of at most 64 texts, got " + io::shown(*events));
  for (std::size_t i = 0; i < events->size(); ++i) {
    const Json& text = (*events)[i];
    const std::string path = "check.events[" + std::to_string(i) + "]";
    if (!text.is_string()) return reader.refuse(path + " must be a text, got " + io::shown(text));
    const Result<Event> event = parse_event(text.get_ref<const std::string&>(), players, teams);
    if (!event) return reader.refuse(path + ": " + event.error());
    into.push_back(*event);
  }
  std::ranges::stable_sort(into, {}, &Event::at);
}

/// Reads everything but the events, which need the number of players.
bool read_check(Reader& reader, const Json& check, const Overrides& overrides, Scenario& into) {
  Numbers numbers;
  reader.read(check, "check", Fields::some, numbers,
              {"home", "away", "rules", "models", "events", "metrics", "expect"});
  into.game.strategies[0] = reader.text(check, "check", "home", into.game.strategies[0]);
  into.game.strategies[1] = reader.text(check, "check", "away", into.game.strategies[1]);
  into.game.rules = reader.text(check, "check", "rules", into.game.rules);
  const std::string models = reader.text(check, "check", "models", "match");
  read_metrics(reader, check, into.metrics);
  read_expectations(reader, check, into.metrics);
  for (std::string& side : into.game.models) side = models;
  if (!overrides.home.empty()) into.game.strategies[0] = overrides.home;
  if (!overrides.away.empty()) into.game.strategies[1] = overrides.away;
  into.game.players = numbers.players;
  into.seconds = static_cast<double>(numbers.seconds);
  into.seeds = overrides.seeds > 0 ? overrides.seeds : numbers.seeds;
  return numbers.fuzz;
}

}  // namespace

Result<Scenario> load_scenario(const std::string& path, const Overrides& overrides) {
  const std::string plain = io::is_path(path) ? path : "./" + path;
  const Result<io::Source> source = io::find_source("situations", "situation", plain);
  if (!source) return source.failure();
  const Result<Json> json = io::parse_object(source->text, source->called);
  if (!json) return json.failure();
  Reader reader(source->called);
  Scenario scenario;
  scenario.name = std::filesystem::path(path).filename().string();
  if (const auto about = json->find("about"); about != json->end() && about->is_string())
    scenario.about = about->get<std::string>();
  const auto check = json->find("check");
  if (check == json->end())
    return Error{source->called + ": check is missing, expected an object with the metrics of this situation"};
  if (!reader.is_object(*check, "check")) return reader.error();
  const bool fuzz = read_check(reader, *check, overrides, scenario);
  if (!reader.good()) return reader.error();

  auto lineup = contest::Lineup::prepare({.game = scenario.game, .rest = {}});
  if (!lineup) return lineup.failure(source->called);
  const io::SituationTeams teams = io::read_teams(reader, *json);
  if (reader.good()) read_events(reader, *check, lineup->params().rules.players, teams, scenario.events);
  if (!reader.good()) return reader.error();
  auto openings = contest::Openings::read(plain, fuzz, lineup->params());
  if (!openings) return openings.failure();
  scenario.lineup.emplace(std::move(*lineup));
  scenario.openings.emplace(std::move(*openings));
  return scenario;
}

Result<std::vector<Scenario>> load_scenarios(const std::string& path, const Overrides& overrides) {
  std::vector<std::string> paths;
  std::error_code failed;
  if (std::filesystem::is_directory(path, failed)) {
    const auto files = robot::list_folder(path);
    if (!files) return files.failure();
    for (const robot::FolderEntry& file : *files)
      if (file.name.ends_with(".json")) paths.push_back((std::filesystem::path(path) / file.name).string());
    if (paths.empty())
      return Error{"folder '" + path + "': expected situations, files that end in .json, there are none"};
  } else {
    paths.push_back(path);
  }
  std::vector<Scenario> scenarios;
  for (const std::string& one : paths) {
    Result<Scenario> scenario = load_scenario(one, overrides);
    if (!scenario) return scenario.failure();
    scenarios.push_back(std::move(*scenario));
  }
  return scenarios;
}

}  // namespace sim::check
