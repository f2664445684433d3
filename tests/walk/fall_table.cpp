#include "tests/walk/fall_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "robot/fit/math/least_squares.h"
#include "robot/nao/walk/named_parameters.h"
#include "sim/match/hash.h"

namespace robot::nao::walk {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kImpulses[] = {1.2, 1.8, 2.4, 3.0, 4.0};  // [N s]

struct NamedCommand {
  const char* name;
  Command command;
};

constexpr NamedCommand kManners[] = {
    {"standing", {}},
    {"slow", {.forward = 0.1}},
    {"ahead", {.forward = 0.2}},
    {"fast", {.forward = 0.25}},
    {"sideways", {.left = 0.1}},
    {"turning", {.turn = 0.8}},
};

constexpr const char* kClasses[] = {"stiff", "soft"};  // by Servos

/// The terms of a regression: slope, mean, and the share of each direction.
constexpr std::size_t kTerms = 2 + kDirections;
constexpr double kMiddle = 2.4;     // [N s] impulse at which the slope does not count
constexpr double kUsualSlope = 6;   // of this walk, and of those before it
constexpr int kMostSteps = 100;     // of Newton
constexpr double kLongest = 1;      // of one step in any term: a longer one may lead away
constexpr double kSmallest = 1e-9;  // a step that ends the search
constexpr double kLeastSlope = 0.5, kLeastImpulse = 0.1, kMostImpulse = 50;  // [N s]

double deviation_of(std::size_t term) { return term <= 1 ? 3 : 1.5; }

/// Writes a number as short as it can be read.
std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", number);
  return text;
}

Json rounded(double number) { return Json::parse(text_of(number)); }

/// Returns JSON in one line, with a space behind each comma and colon.
std::string line_of(const Json& json) {
  if (!json.is_structured()) return json.dump();
  std::string line;
  for (const auto& [key, value] : json.items()) {
    line += line.empty() ? "" : ", ";
    if (json.is_object()) line.append(Json(key).dump()).append(": ");
    line += line_of(value);
  }
  return json.is_object() ? "{" + line + "}" : "[" + line + "]";
}

Json toppling_json(const Toppling& toppling) {
  constexpr const char* kNames[] = {"front", "front_left", "left",  "back_left",
                                    "back",  "back_right", "right", "front_right"};
  Json json = {{"slope", rounded(toppling.slope)}};
  for (std::size_t i = 0; i < kDirections; ++i)
    json[kNames[i]] = {{"value", rounded(toppling.half[i])}, {"unit", "N s"}};
  return json;
}

Json counts_json(const std::vector<Pushed>& pushes) {
  Json all = Json::array();
  for (const Pushed& pushed : pushes) {
    Json trials = Json::array(), falls = Json::array();
    for (const Trials& to : pushed.to) trials.push_back(to.trials), falls.push_back(to.falls);
    all.push_back({{"impulse", pushed.impulse}, {"trials", trials}, {"falls", falls}});
  }
  return all;
}

}  // namespace

Toppling fit_toppling(const std::vector<Pushed>& pushes) {
  fit::Vector terms(kTerms);
  terms[0] = kUsualSlope;
  for (int step = 0; step < kMostSteps; ++step) {
    fit::Vector slope(kTerms);
    std::vector<fit::Vector> curvature(kTerms, fit::Vector(kTerms));
    for (std::size_t k = 0; k < kTerms; ++k) {
      const double variance = deviation_of(k) * deviation_of(k);
      slope[k] = ((k == 0 ? kUsualSlope : 0) - terms[k]) / variance;
      curvature[k][k] = 1 / variance;
    }
    for (const Pushed& pushed : pushes)
      for (std::size_t i = 0; i < kDirections; ++i) {
        const auto trials = static_cast<double>(pushed.to[i].trials), falls = static_cast<double>(pushed.to[i].falls);
        const std::array<std::pair<std::size_t, double>, 3> features = {
            {{0, std::log(pushed.impulse / kMiddle)}, {1, 1}, {2 + i, 1}}};
        double sum = 0;
        for (const auto& [k, value] : features) sum += terms[k] * value;
        const double p = 1 / (1 + std::exp(-sum));
        for (const auto& [k, value] : features) {
          slope[k] += (falls - trials * p) * value;
          for (const auto& [j, other] : features) curvature[k][j] += trials * p * (1 - p) * value * other;
        }
      }
    const auto way = fit::solve(std::move(curvature), std::move(slope));
    if (!way) break;
    double longest = 0;
    for (const double part : *way) longest = std::max(longest, std::abs(part));
    const double share = std::min(1., kLongest / std::max(longest, kSmallest));
    for (std::size_t k = 0; k < kTerms; ++k) terms[k] += share * (*way)[k];
    if (longest < kSmallest) break;
  }

  Toppling toppling{.slope = std::max(terms[0], kLeastSlope)};
  for (std::size_t i = 0; i < kDirections; ++i)
    toppling.half[i] =
        std::clamp(kMiddle * std::exp(-(terms[1] + terms[2 + i]) / toppling.slope), kLeastImpulse, kMostImpulse);
  return toppling;
}

std::optional<FallCounts> count_falls(const Tested& tested, Servos servos, std::uint64_t first_seed, int robots) {
  FallCounts counts;
  std::uint64_t seed = first_seed;  // each case has robots of its own
  const auto seeds = [&] { return std::exchange(seed, seed + static_cast<std::uint64_t>(robots)); };
  for (const auto& [name, command] : kManners) {
    Walked& walked = counts.walks.emplace_back(Walked{.manner = name});
    const bool played =
        play(constant(command), tested, servos, seeds(), robots, [&](const Outcome& outcome, const Plan&, int) {
          walked.falls += outcome.fell ? 1 : 0;
          walked.minutes += outcome.time / 60;
        });
    if (!played) return {};
  }
  for (const bool walks : {false, true}) {
    Walked& shoved = counts.walks.emplace_back(Walked{.manner = walks ? "shoved_walking" : "shoved_standing"});
    const bool played = play(shoves({.forward = walks ? 0.15 : 0}), tested, servos, seeds(), robots,
                             [&](const Outcome& outcome, const Plan&, int) {
                               shoved.falls += outcome.fell ? 1 : 0;
                               shoved.minutes += (outcome.time - kShoved) / 60;
                             });
    if (!played) return {};
  }
  for (const bool walks : {false, true})
    for (const double impulse : kImpulses) {
      Pushed& pushed = (walks ? counts.walking : counts.standing).emplace_back(Pushed{.impulse = impulse, .to = {}});
      const bool played = play(pushes(impulse, {.forward = walks ? 0.15 : 0}), tested, servos, seeds(), robots,
                               [&](const Outcome& outcome, const Plan&, int direction) {
                                 Trials& to = pushed.to[static_cast<std::size_t>(direction)];
                                 ++to.trials;
                                 to.falls += outcome.fell ? 1 : 0;
                               });
      if (!played) return {};
    }
  return counts;
}

std::string fall_table(const Origin& origin, const std::array<FallCounts, 2>& counts) {
  Json table;
  table["about"] = origin.walk == "ours"
                       ? "Falls of our own walk on simulated robots (tests/walk). No real Nao has been pushed."
                       : "Falls of " + origin.walk + " on simulated robots.";
  table["made_by"] = {{"harness", "bench_walk falls"},   {"build", origin.build},           {"walk", origin.walk},
                      {"parameters", origin.parameters}, {"first_seed", origin.first_seed}, {"robots", origin.robots}};
  table["collisions"] = {
      {"mass", {{"value", 5.3}, {"unit", "kg"}, {"source", "Aldebaran's table of masses, as in tests/walk/nao_model"}}},
      {"bounce", {{"value", 0.2}, {"unit", ""}, {"source", "estimate: plastic shells, and joints that give way"}}},
      {"soft", {{"value", 0.5}, {"unit", ""}, {"source", "estimate: half of a team's robots are worn"}}}};
  for (std::size_t one = 0; one < counts.size(); ++one) {
    const std::string name = kClasses[one];
    Json& rates = table[name + "_rates"];
    for (const Walked& walked : counts[one].walks)
      rates[std::string(walked.manner)] = {{"value", rounded(walked.falls / std::max(walked.minutes, 1e-9))},
                                           {"unit", "1/min"}};
    table[name + "_standing"] = toppling_json(fit_toppling(counts[one].standing));
    table[name + "_walking"] = toppling_json(fit_toppling(counts[one].walking));
  }
  Json& evidence = table["counts"];
  for (std::size_t one = 0; one < counts.size(); ++one) {
    Json& own = evidence[kClasses[one]];
    for (const Walked& walked : counts[one].walks)
      own["rates"][std::string(walked.manner)] = {{"falls", walked.falls}, {"minutes", rounded(walked.minutes)}};
    own["standing"] = counts_json(counts[one].standing);
    own["walking"] = counts_json(counts[one].walking);
  }

  std::string text;
  for (const auto& [key, value] : table.items()) {
    text.append(text.empty() ? "{\n" : ",\n").append("  ").append(Json(key).dump()).append(": ");
    if (key != "counts") {
      text += line_of(value);
      continue;
    }
    // a line for each strength of pushes
    std::string lines;
    for (const auto& [name, own] : value.items())
      for (const auto& [state, counted] : own.items()) {
        lines.append(lines.empty() ? "{\n" : ",\n").append("    ").append(Json(name + "_" + state).dump()).append(": ");
        if (counted.is_object()) {
          lines += line_of(counted);
          continue;
        }
        std::string rows;
        for (const Json& row : counted) rows.append(rows.empty() ? "[\n" : ",\n").append("      ").append(line_of(row));
        lines.append(rows).append("\n    ]");
      }
    text.append(lines).append("\n  }");
  }
  return text + "\n}\n";
}

std::string hash_of(const Parameters& parameters) {
  std::string text;
  for (const NamedParameter& named : kNamedParameters) {
    char line[96];
    std::snprintf(line, sizeof line, "%.*s=%a\n", static_cast<int>(named.name.size()), named.name.data(),
                  parameters.*named.place);
    text += line;
  }
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(sim::hash_of_text(text)));
  return hash;
}

}  // namespace robot::nao::walk
