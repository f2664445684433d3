#include "tests/walk/fall_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "robot/fit/math/least_squares.h"
#include "robot/nao/walk/named_parameters.h"
#include "sim/match/hash.h"
#include "sim/math/vec2.h"
#include "sim/motion/fall_table.h"
#include "tests/walk/rise.h"

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

constexpr Command kPushedWalk{.forward = 0.15};

constexpr const char* kClasses[] = {"stiff", "soft"};  // by Servos

/// The terms of a regression: slope, mean, and the share of each direction.
constexpr std::size_t kTerms = 2 + kDirections;
constexpr double kMiddle = 2.4;     // [N s] impulse at which the slope does not count
constexpr double kUsualSlope = 6;   // of this walk, and of those before it
constexpr int kMostSteps = 100;     // of Newton
constexpr double kLongest = 1;      // of one step in any term: a longer one may lead away
constexpr double kSmallest = 1e-9;  // a step that ends the search
// the ranges that the simulator reads
constexpr double kLeastSlope = 0.5, kMostSlope = 50;
constexpr double kLeastImpulse = 0.1, kMostImpulse = 50;  // [N s]
constexpr double kMostFalls = 600;                        // [1/min]

constexpr std::array<std::pair<Lying, std::size_t>, 4> kSides = {
    {{Lying::on_back, 0}, {Lying::on_front, 1}, {Lying::on_left, 2}, {Lying::on_right, 2}}};  // index into kDownOn

double deviation_of(std::size_t term) { return term <= 1 ? 3 : 1.5; }

/// Returns the hash of a text in 16 digits.
std::string hexadecimal(const std::string& text) {
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(sim::hash_of_text(text)));
  return hash;
}

/// Writes a number as short as it can be read.
std::string digits_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", number);
  return text;
}

Json rounded(double number) { return Json::parse(digits_of(number)); }

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

/// Returns the table as text: an entry a line, and of the counts a line for each strength of pushes.
std::string text_of(const Json& json, const std::string& margin = "") {
  std::string text;
  for (const auto& [key, value] : json.items()) {
    text.append(text.empty() ? "\n" : ",\n").append(margin).append("  ");
    if (json.is_object()) text.append(Json(key).dump()).append(": ");
    const bool opens = key == "counts" || value.is_array();
    text += opens && margin.size() < 4 ? text_of(value, margin + "  ") : line_of(value);
  }
  return json.is_object() ? "{" + text + "\n" + margin + "}" : "[" + text + "\n" + margin + "]";
}

Json toppling_json(const Toppling& toppling) {
  constexpr const char* kNames[] = {"front", "front_left", "left",  "back_left",
                                    "back",  "back_right", "right", "front_right"};
  Json json = {{"slope", rounded(toppling.slope)}};
  for (std::size_t i = 0; i < kDirections; ++i)
    json[kNames[i]] = {{"value", rounded(toppling.half[i])}, {"unit", "N s"}};
  return json;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the place in kDownOn of a robot that falls in this direction [rad].
std::size_t down_on(double direction) {
  switch (sim::motion::lying_after(sim::direction(static_cast<float>(direction)))) {
    case sim::Lying::on_back: return 0;
    case sim::Lying::on_front: return 1;
    default: return 2;
  }
}

/// Lets robots get up from each side. Returns the problem if there is one.
std::string count_rises(Servos servos, std::uint64_t first_seed, int robots, FallCounts& counts) {
  std::array<std::vector<double>, 3> seconds;
  std::vector<double> lay;
  for (const auto& [side, place] : kSides)
    for (const Rise& one :
         rises(servos, std::exchange(first_seed, first_seed + static_cast<std::uint64_t>(robots)), robots, side)) {
      ++counts.risen[place].robots;
      lay.push_back(one.lay);
      if (!one.at_once()) continue;
      ++counts.risen[place].first;
      seconds[place].push_back(one.seconds);
    }
  counts.lying = median_of(std::move(lay));
  for (std::size_t place = 0; place < kDownOn.size(); ++place) {
    if (seconds[place].empty()) return std::string("expected robots that get up, got none from the ") + kDownOn[place];
    counts.risen[place].seconds = median_of(std::move(seconds[place]));
  }
  return "";
}

Json getting_up_json(const FallCounts& counts) {
  Json json = {{"lying", {{"value", rounded(counts.lying)}, {"unit", "s"}}}};
  for (std::size_t place = 0; place < kDownOn.size(); ++place)
    json[kDownOn[place]] = {{"value", rounded(counts.risen[place].seconds)}, {"unit", "s"}};
  for (std::size_t place = 0; place < kDownOn.size(); ++place)
    json[std::string(kDownOn[place]) + "_failure"] = {{"value", rounded(failure_of(counts.risen[place]))},
                                                      {"unit", ""}};
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

/// Returns the way from `terms` to the best ones, if the logarithm of the penalised likelihood were a parabola.
std::optional<fit::Vector> newton_step(const std::vector<Pushed>& pushes, const fit::Vector& terms) {
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
  return fit::solve(std::move(curvature), std::move(slope));
}

}  // namespace

Toppling fit_toppling(const std::vector<Pushed>& pushes) {
  fit::Vector terms(kTerms);
  terms[0] = kUsualSlope;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto way = newton_step(pushes, terms);
    if (!way) break;
    double longest = 0;
    for (const double part : *way) longest = std::max(longest, std::abs(part));
    const double share = std::min(1., kLongest / std::max(longest, kSmallest));
    for (std::size_t k = 0; k < kTerms; ++k) terms[k] += share * (*way)[k];
    if (longest < kSmallest) break;
  }

  Toppling toppling{.slope = std::clamp(terms[0], kLeastSlope, kMostSlope)};
  for (std::size_t i = 0; i < kDirections; ++i)
    toppling.half[i] =
        std::clamp(kMiddle * std::exp(-(terms[1] + terms[2 + i]) / toppling.slope), kLeastImpulse, kMostImpulse);
  return toppling;
}

Result<FallCounts> count_falls(const Tested& tested, Servos servos, std::uint64_t first_seed, int robots) {
  FallCounts counts;
  std::string problem;
  std::uint64_t seed = first_seed;  // each case has robots of its own
  const auto count = [&](const Case& one, const std::string& name, auto&& see) {
    if (!problem.empty()) return;
    int trials = 0;
    const bool played = play(one, tested, servos, std::exchange(seed, seed + static_cast<std::uint64_t>(robots)),
                             robots, [&](const Outcome& outcome, const Plan&, int direction) {
                               ++trials;
                               see(outcome, static_cast<std::size_t>(direction));
                             });
    if (!played)
      problem = "expected a walk from foresight_walk_begin, got none";
    else if (trials == 0)
      problem = "expected robots on their feet until they are pushed, got none while " + name;
  };
  const auto walked = [&](const Case& one, const char* manner, double from) {
    Walked& into = counts.walks.emplace_back(Walked{.manner = manner});
    count(one, manner, [&](const Outcome& outcome, std::size_t) {
      into.falls += outcome.fell ? 1 : 0;
      into.minutes += (outcome.time - from) / 60;
      if (outcome.fell && from == 0) ++counts.alone[down_on(outcome.direction)];
    });
  };
  for (const auto& [manner, command] : kManners) walked(constant(command), manner, 0);
  walked(shoves({}), "shoved_standing", kShoved);
  walked(shoves(kPushedWalk), "shoved_walking", kShoved);
  for (auto* const all : {&counts.standing, &counts.walking})
    for (const double impulse : kImpulses) {
      const bool walks = all == &counts.walking;
      Pushed& pushed = all->emplace_back(Pushed{.impulse = impulse, .to = {}});
      count(pushes(impulse, walks ? kPushedWalk : Command{}), walks ? "walking" : "standing",
            [&](const Outcome& outcome, std::size_t direction) {
              ++pushed.to[direction].trials;
              pushed.to[direction].falls += outcome.fell ? 1 : 0;
            });
    }
  if (problem.empty()) problem = count_rises(servos, seed, robots, counts);
  if (!problem.empty()) return Error{problem};
  return counts;
}

double failure_of(const Risen& risen) { return (risen.robots - risen.first + 0.5) / (risen.robots + 1.); }

double share_of(int count, int all) { return (count + 0.5) / (all + 0.5 * kDownOn.size()); }

std::string fall_table(const Origin& origin, const std::array<FallCounts, 2>& counts) {
  Json table;
  table["about"] = origin.walk == "ours"
                       ? "Falls of our own walk on simulated robots (tests/walk). No real Nao has been pushed."
                       : "Falls of " + origin.walk +
                             " on simulated robots, which get up as our guardian does it (robot/nao/guardian/get_up).";
  table["made_by"] = {{"harness", "bench_walk falls"},
                      {"build", origin.build},
                      {"walk", origin.walk},
                      {"parameters", origin.parameters},
                      {"getting_up", hash_of_getting_up()},
                      {"first_seed", origin.first_seed},
                      {"robots", origin.robots}};
  table["collisions"] = {
      {"mass", {{"value", 5.3}, {"unit", "kg"}, {"source", "Aldebaran's table of masses, as in tests/walk/nao_model"}}},
      {"bounce", {{"value", 0.2}, {"unit", ""}, {"source", "estimate: plastic shells, and joints that give way"}}},
      {"soft", {{"value", 0.5}, {"unit", ""}, {"source", "estimate: half of a team's robots are worn"}}}};
  Json evidence;
  std::array<int, 3> alone{};
  for (const FallCounts& one : counts)
    for (std::size_t place = 0; place < alone.size(); ++place) alone[place] += one.alone[place];
  const int all_alone = alone[0] + alone[1] + alone[2];
  for (const std::size_t place : {1, 0})
    table["alone"][kDownOn[place]] = {{"value", rounded(share_of(alone[place], all_alone))}, {"unit", ""}};
  for (std::size_t place = 0; place < alone.size(); ++place) evidence["alone"][kDownOn[place]] = alone[place];
  for (std::size_t one = 0; one < counts.size(); ++one) {
    const std::string name = kClasses[one];
    for (const auto& [manner, falls, minutes] : counts[one].walks) {
      const std::string key(manner);
      table[name + "_rates"][key] = {{"value", rounded(std::min(falls / minutes, kMostFalls))}, {"unit", "1/min"}};
      evidence[name + "_rates"][key] = {{"falls", falls}, {"minutes", rounded(minutes)}};
    }
    table[name + "_standing"] = toppling_json(fit_toppling(counts[one].standing));
    table[name + "_walking"] = toppling_json(fit_toppling(counts[one].walking));
    table[name + "_getting_up"] = getting_up_json(counts[one]);
    for (std::size_t place = 0; place < kDownOn.size(); ++place)
      evidence[name + "_getting_up"][kDownOn[place]] = {{"robots", counts[one].risen[place].robots},
                                                        {"first", counts[one].risen[place].first}};
    evidence[name + "_standing"] = counts_json(counts[one].standing);
    evidence[name + "_walking"] = counts_json(counts[one].walking);
  }
  table["counts"] = evidence;
  return text_of(table) + "\n";
}

std::string hash_of(const Parameters& parameters) {
  std::string text;
  for (const NamedParameter& named : kNamedParameters) {
    if (named.name.starts_with("kick_")) continue;
    char line[96];
    std::snprintf(line, sizeof line, "%.*s=%a\n", static_cast<int>(named.name.size()), named.name.data(),
                  parameters.*named.place);
    text += line;
  }
  return hexadecimal(text);
}

std::string hash_of_getting_up() {
  std::string text;
  for (const auto& [side, place] : kSides)
    for (const KeyFrame& frame : get_up(side)) {
      std::vector<float> numbers(frame.position.begin(), frame.position.end());
      numbers.push_back(frame.seconds);
      for (const float number : numbers) {
        char digits[32];
        std::snprintf(digits, sizeof digits, "%a ", static_cast<double>(number));
        text += digits;
      }
    }
  return hexadecimal(text);
}

}  // namespace robot::nao::walk
