#include "sim/app/contest_report.h"

#include <cmath>
#include <cstdio>
#include <string_view>

namespace sim::app {
namespace {

using compare::Interval;
using compare::kA;
using compare::kB;
using compare::Verdict;

template <class... Values>
std::string text(const char* format, Values... values) {
  char buffer[300];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

std::int64_t games_of(const Outcome& outcome) { return 2 * outcome.tally.pairs; }

double per_game(const Outcome& outcome, std::int64_t sum) {
  return outcome.tally.pairs == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(games_of(outcome));
}

const char* noun(Metric metric) {
  switch (metric) {
    case Metric::goals: return "goals";
    case Metric::first_goal: return "of the first goal";
    case Metric::conceded: return "fewer conceded goals";
    case Metric::score_within: return "of scoring in time";
  }
  return "";
}

/// The sentence that people take home.
std::string verdict_sentence(const ContestReport& report) {
  const ComparisonChoice& choice = report.comparison.choice();
  const Interval gain = compare::gain_per_game(report.outcome.tally);
  const std::string amount =
      text("%+.3f %s per game (95 %%: %+.3f .. %+.3f)", gain.mean, noun(choice.metric), gain.low, gain.high);
  switch (report.outcome.verdict) {
    case Verdict::better: return choice.b + " is better than " + choice.a + ": " + amount;
    case Verdict::not_better:
      return choice.b + " is not better than " + choice.a + text(" by %.2g per game: ", report.options.question.h1) +
             amount;
    case Verdict::undecided: return "undecided whether " + choice.b + " is better than " + choice.a + ": " + amount;
    case Verdict::identical: return choice.b + " and " + choice.a + " are identical: every pair came out even";
  }
  return "";
}

std::string replay_of(const ContestReport& report, const DecisivePair& pair) {
  const ComparisonChoice& choice = report.comparison.choice();
  const std::string& against = choice.opponent.empty() ? choice.a : choice.opponent;
  std::string command = "foresight-sim match --home " + choice.b + " --away " + against + " --rules " + choice.rules +
                        " --models " + choice.models;
  if (choice.players > 0) command += " --players " + std::to_string(choice.players);
  if (choice.pace == Pace::every_tick) command += " --every-tick";
  return command + " --seed " + std::to_string(report.comparison.seed_of(pair.number)) + " --mcap game.mcap";
}

Json to_json(const Interval& interval) {
  // what is not known is infinite, which JSON cannot say
  const auto bound = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  return {{"mean", interval.mean}, {"low", bound(interval.low)}, {"high", bound(interval.high)}};
}

}  // namespace

Json to_json(const ContestReport& report) {
  const auto& [comparison, options, outcome] = report;
  const compare::Tally& tally = outcome.tally;
  const double ratio = compare::llr(tally, options.question);
  Json json = {{"run", Json::parse(comparison.specification())},
               {"verdict", compare::name(outcome.verdict)},
               {"sentence", verdict_sentence(report)},
               {"pairs", tally.pairs},
               {"games", games_of(outcome)},
               {"gain", to_json(compare::gain_per_game(tally))},
               {"llr", std::isfinite(ratio) ? Json(ratio) : Json()},
               {"h0", options.question.h0},
               {"h1", options.question.h1}};
  for (const int behaviour : {kA, kB})
    json[behaviour == kA ? "a" : "b"] = {{"goals", per_game(outcome, tally.goals[behaviour])},
                                         {"conceded", per_game(outcome, tally.conceded[behaviour])}};
  json["b_won_drawn_lost"] = {tally.won, tally.drawn, tally.lost};
  json["pairing_gain"] = compare::pairing_gain(tally);
  json["home_advantage"] = to_json(compare::home_advantage(tally));
  json["models_fitted"] = false;
  json["seconds"] = outcome.seconds;
  json["marks"] = Json::array();
  for (const Mark& mark : outcome.marks)
    json["marks"].push_back({mark.pairs, mark.gain.mean, std::isfinite(mark.llr) ? Json(mark.llr) : Json()});
  json["histogram"] = {{"from", -Outcome::kWidest}, {"pairs", outcome.histogram}};
  json["decisive"] = Json::array();
  for (const DecisivePair& pair : outcome.decisive)
    json["decisive"].push_back({{"pair", pair.number}, {"gain", pair.gain}, {"replay", replay_of(report, pair)}});
  return json;
}

std::string to_text(const ContestReport& report, bool explain) {
  const auto& [comparison, options, outcome] = report;
  const compare::Tally& tally = outcome.tally;
  const ComparisonChoice& choice = comparison.choice();
  std::string out = verdict_sentence(report) + "\n\n";
  out += text("%-22s%12s%12s\n", "", "A", "B");
  out += text("%-22s%12.12s%12.12s\n", "", choice.a.c_str(), choice.b.c_str());
  out += text("%-22s%12.3f%12.3f\n", "goals per game", per_game(outcome, tally.goals[kA]),
              per_game(outcome, tally.goals[kB]));
  out += text("%-22s%12.3f%12.3f\n", "conceded", per_game(outcome, tally.conceded[kA]),
              per_game(outcome, tally.conceded[kB]));
  out += text("%-22s%12lld%12lld\n", "won", static_cast<long long>(tally.lost), static_cast<long long>(tally.won));
  out += text("%-22s%12lld\n\n", "drawn", static_cast<long long>(tally.drawn));

  out += text("games            %lld in %lld pairs, %.0f s, %.0f a minute\n", static_cast<long long>(games_of(outcome)),
              static_cast<long long>(tally.pairs), outcome.seconds,
              static_cast<double>(games_of(outcome)) * 60 / std::max(outcome.seconds, 1e-3));
  const compare::Bounds bounds = compare::bounds_of(options.question);
  if (!options.pairs)
    out += text("test             LLR %+.2f of %+.2f for %g, %+.2f for %g\n", compare::llr(tally, options.question),
                bounds.h0, options.question.h0, bounds.h1, options.question.h1);
  if (const double gain = compare::pairing_gain(tally); gain > 0)
    out += text("pairs            spare %.2f times as many games without\n", gain);
  const Interval home = compare::home_advantage(tally);
  out += text("home advantage   %+.3f (95 %%: %+.3f .. %+.3f)\n", home.mean, home.low, home.high);
  out += "holds for        rules " + choice.rules + ", models " + choice.models + " (not fitted to robots of yours)\n";
  if (!options.pairs && outcome.verdict != Verdict::undecided && outcome.verdict != Verdict::identical)
    out += "                 a test that stops early tends to overstate the gain a little\n";
  if (!explain) return out;

  out += "\nmost decisive pairs, with the game that B plays at home\n";
  for (const DecisivePair& pair : outcome.decisive) out += text("  %+d  ", pair.gain) + replay_of(report, pair) + "\n";
  return out;
}

namespace {

struct Needed {
  double variance, seconds_per_pair;
  compare::Plan plan;
};

Needed needed_by(const ContestReport& pilot) {
  const double variance = compare::pair_variance(pilot.outcome.tally);
  compare::Plan plan = compare::plan(variance, pilot.options.question.h1 - pilot.options.question.h0);
  // the sequential test gives no answer before
  const auto fewest = static_cast<double>(pilot.options.question.fewest_pairs);
  for (double* const pairs : {&plan.sequential, &plan.sequential_worst}) *pairs = std::max(*pairs, fewest);
  return {.variance = variance,
          .seconds_per_pair =
              pilot.outcome.seconds / static_cast<double>(std::max<std::int64_t>(1, pilot.outcome.tally.pairs)),
          .plan = plan};
}

}  // namespace

Json plan_json(const ContestReport& pilot) {
  const auto [variance, seconds, plan] = needed_by(pilot);
  const auto entry = [seconds = seconds](double pairs) {
    return Json{{"games", 2 * std::ceil(pairs)}, {"seconds", pairs * seconds}};
  };
  return {{"delta", pilot.options.question.h1 - pilot.options.question.h0},
          {"pilot_pairs", pilot.outcome.tally.pairs},
          {"pair_variance", variance},
          {"fixed_80", entry(plan.fixed_80)},
          {"fixed_95", entry(plan.fixed_95)},
          {"sequential", entry(plan.sequential)},
          {"sequential_worst", entry(plan.sequential_worst)}};
}

std::string plan_text(const ContestReport& pilot) {
  const auto [variance, seconds, plan] = needed_by(pilot);
  std::string out = text("to tell a gain of %g per game from none (a pilot of %lld pairs, variance %.2f):\n\n",
                         pilot.options.question.h1 - pilot.options.question.h0,
                         static_cast<long long>(pilot.outcome.tally.pairs), variance);
  const auto line = [&out, seconds = seconds](const char* what, double pairs) {
    out += text("  %-52s%9.0f games%9.1f min\n", what, 2 * std::ceil(pairs), pairs * seconds / 60);
  };
  line("sequential test, where one of its answers is true", plan.sequential);
  line("sequential test, where the truth lies between them", plan.sequential_worst);
  line("fixed number, found in 80 % of runs", plan.fixed_80);
  line("fixed number, found in 95 % of runs", plan.fixed_95);
  return out;
}

}  // namespace sim::app
