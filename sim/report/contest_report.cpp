#include "sim/report/contest_report.h"
#include "robot/core/json_library.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <optional>

namespace sim::report {
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

std::int64_t games_of(const contest::Outcome& outcome) { return 2 * outcome.tally.pairs; }

double per_game(const contest::Outcome& outcome, std::int64_t sum) {
  return outcome.tally.pairs == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(games_of(outcome));
}

/// Shortens a name from its beginning: the ends of paths differ.
std::string shortened(const std::string& name) {
  constexpr std::size_t kMost = 11;
  return name.size() <= kMost ? name : ".." + name.substr(name.size() - kMost + 2);
}

std::string name_of_b(const contest::ComparisonChoice& choice) {
  return choice.changed > 0 ? choice.b + text(" of players 1 .. %d", choice.changed) : choice.b;
}

const char* noun(contest::Metric metric) {
  switch (metric) {
    case contest::Metric::goals: return "goals";
    case contest::Metric::first_goal: return "of the first goal";
    case contest::Metric::conceded: return "fewer conceded goals";
    case contest::Metric::score_within: return "of scoring in time";
    case contest::Metric::ball_advance: return "m of the ball's way";
  }
  return "";
}

/// Quotes a word for the shell, if it needs quotes.
std::string quoted(const std::string& word) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("_-+=.,:/%", c);
  };
  if (!word.empty() && std::ranges::all_of(word, plain)) return word;
  std::string all = "'";
  for (const char c : word) all += c == '\'' ? "'\\''" : std::string(1, c);
  return all + "'";
}

/// Returns the command that plays the game of a pair in which B is at home.
std::string replay_of(const ContestReport& report, const contest::DecisivePair& pair) {
  const contest::ComparisonChoice& choice = report.comparison.choice();
  const std::string& against = choice.opponent.empty() ? choice.a : choice.opponent;
  std::string command = "foresight-sim match --home " + quoted(choice.b) + " --away " + quoted(against) + " --rules " +
                        quoted(choice.rules) + " --models " + quoted(choice.models);
  if (choice.changed > 0)
    command += " --changed " + std::to_string(choice.changed) + " --home-rest " + quoted(choice.a);
  if (choice.players > 0) command += " --players " + std::to_string(choice.players);
  if (choice.pace == Pace::every_tick) command += " --every-tick";
  if (!choice.situation.empty()) command += " --from " + quoted(choice.situation);
  if (choice.fuzz) command += " --fuzz";
  if (choice.seconds > 0) command += text(" --seconds %g", choice.seconds);
  return command + " --seed " + std::to_string(report.comparison.seed_of(pair.number)) + " --mcap game.mcap";
}

/// Returns null for an unknown bound: it is infinite, and JSON has no infinity.
Json bound_json(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json to_json(const Interval& interval) {
  return {{"mean", interval.mean}, {"low", bound_json(interval.low)}, {"high", bound_json(interval.high)}};
}

/// Returns the unbiased gain, or nothing unless a sequential test has answered.
std::optional<Interval> unbiased(const ContestReport& report) {
  const double unit = report.comparison.unit();
  if (!report.outcome.sequential || compare::pair_variance(report.outcome.tally, unit) <= 0) return {};
  return compare::unbiased_gain(report.outcome.tally, report.options.question, unit);
}

Json unbiased_json(const ContestReport& report) {
  const auto gain = unbiased(report);
  return gain ? to_json(*gain) : Json();
}

}  // namespace

std::string sentence_of(const ContestReport& report) {
  const contest::ComparisonChoice& choice = report.comparison.choice();
  const Interval gain = compare::gain_per_game(report.outcome.tally, report.comparison.unit());
  const std::string amount =
      text("%+.3f %s per game (95 %%: %+.3f .. %+.3f)", gain.mean, noun(choice.metric), gain.low, gain.high);
  switch (report.outcome.verdict) {
    case Verdict::better: return name_of_b(choice) + " is better than " + choice.a + ": " + amount;
    case Verdict::not_better:
      return name_of_b(choice) + " is not better than " + choice.a +
             text(" by %.2g per game: ", report.options.question.h1) + amount;
    case Verdict::undecided:
      return "undecided whether " + name_of_b(choice) + " is better than " + choice.a + ": " + amount;
    case Verdict::identical: return name_of_b(choice) + " and " + choice.a + " are identical: every pair came out even";
  }
  return "";
}

Json to_json(const ContestReport& report) {
  const auto& [comparison, options, outcome] = report;
  const compare::PairStatistics& tally = outcome.tally;
  const double unit = comparison.unit();
  const double ratio = compare::llr(tally, options.question, unit);
  const compare::Bounds bounds = compare::bounds_of(options.question);
  Json json = {{"run", Json::parse(comparison.specification())},
               {"verdict", compare::name(outcome.verdict)},
               {"sentence", sentence_of(report)},
               {"pairs", tally.pairs},
               {"games", games_of(outcome)},
               {"gain", to_json(compare::gain_per_game(tally, unit))},
               {"unbiased_gain", unbiased_json(report)},
               {"llr", std::isfinite(ratio) ? Json(ratio) : Json()},
               {"bounds", {bounds.h0, bounds.h1}},
               {"h0", options.question.h0},
               {"h1", options.question.h1}};
  for (const int behaviour : {kA, kB})
    json[behaviour == kA ? "a" : "b"] = {{"goals", per_game(outcome, tally.goals[behaviour])},
                                         {"conceded", per_game(outcome, tally.conceded[behaviour])}};
  json["b_won_drawn_lost"] = {tally.won, tally.drawn, tally.lost};
  json["b_points_of_pairs"] = tally.points;
  json["pairing_gain"] = compare::pairing_gain(tally);
  json["home_advantage"] = to_json(compare::home_advantage(tally, unit));
  json["models_fitted"] = false;
  json["marks"] = Json::array();
  for (const contest::Mark& mark : outcome.marks)
    json["marks"].push_back({mark.pairs, mark.gain.mean, std::isfinite(mark.llr) ? Json(mark.llr) : Json(),
                             bound_json(mark.gain.low), bound_json(mark.gain.high)});
  const double column = contest::column_of(comparison.choice().metric);
  json["histogram"] = {{"from", -contest::Outcome::kWidest * column}, {"column", column}, {"pairs", outcome.histogram}};
  json["decisive"] = Json::array();
  for (const contest::DecisivePair& pair : outcome.decisive)
    json["decisive"].push_back(
        {{"pair", pair.number}, {"gain", pair.gain / unit}, {"replay", replay_of(report, pair)}});
  return json;
}

Json to_whole_json(const ContestReport& report) {
  Json json = to_json(report);
  json["seconds"] = report.outcome.seconds;
  json["decision_us"] = {report.outcome.cost[kA].mean_us(), report.outcome.cost[kB].mean_us()};
  return json;
}

std::string to_text(const ContestReport& report, bool explain) {
  const auto& [comparison, options, outcome] = report;
  const compare::PairStatistics& tally = outcome.tally;
  const contest::ComparisonChoice& choice = comparison.choice();
  std::string out = sentence_of(report) + "\n\n";
  out += text("%-22s%12s%12s\n", "", "A", "B");
  out += text("%-22s%12s%12s\n", "", shortened(choice.a).c_str(), shortened(choice.b).c_str());
  out += text("%-22s%12.3f%12.3f\n", "goals per game", per_game(outcome, tally.goals[kA]),
              per_game(outcome, tally.goals[kB]));
  out += text("%-22s%12.3f%12.3f\n", "conceded", per_game(outcome, tally.conceded[kA]),
              per_game(outcome, tally.conceded[kB]));
  out += text("%-22s%12lld%12lld\n", "won", static_cast<long long>(tally.lost), static_cast<long long>(tally.won));
  out += text("%-22s%12lld\n", "drawn", static_cast<long long>(tally.drawn));
  if (outcome.cost[kA].timed > 0)
    out += text("%-22s%12.2f%12.2f us\n", "a decision costs", outcome.cost[kA].mean_us(), outcome.cost[kB].mean_us());
  out += "\n";

  out += text("games            %lld in %lld pairs", static_cast<long long>(games_of(outcome)),
              static_cast<long long>(tally.pairs));
  // blocks from the disk took no time
  if (outcome.cost[kA].timed > 0)
    out += text(", %.0f s, %.0f a minute", outcome.seconds,
                static_cast<double>(games_of(outcome)) * 60 / std::max(outcome.seconds, 1e-3));
  out += "\n";
  const compare::Bounds bounds = compare::bounds_of(options.question);
  if (!options.pairs)
    out += text("test             LLR %+.2f of %+.2f for %g, %+.2f for %g\n",
                compare::llr(tally, options.question, comparison.unit()), bounds.h0, options.question.h0, bounds.h1,
                options.question.h1);
  if (const double gain = compare::pairing_gain(tally); gain > 0)
    out += text("pairing gain     %.2f times as many games without pairs\n", gain);
  const Interval home = compare::home_advantage(tally, comparison.unit());
  out += text("home advantage   %+.3f (95 %%: %+.3f .. %+.3f)\n", home.mean, home.low, home.high);
  out += "holds for        rules " + choice.rules + ", models " + choice.models + " (not fitted to robots of yours)\n";
  if (const auto gain = unbiased(report))
    out += text("unbiased gain    %+.3f (95 %%: %+.3f .. %+.3f), when to stop allowed for\n", gain->mean, gain->low,
                gain->high);
  if (!explain) return out;

  out += "\nmost decisive pairs, with the game that B plays at home\n";
  for (const contest::DecisivePair& pair : outcome.decisive)
    out += text("  %+g  ", pair.gain / comparison.unit()) + replay_of(report, pair) + "\n";
  return out;
}

namespace {

struct Needed {
  double variance, seconds_per_pair;
  compare::Plan plan;
};

Needed needed_by(const ContestReport& pilot) {
  const double variance = compare::pair_variance(pilot.outcome.tally, pilot.comparison.unit());
  compare::Plan plan = compare::plan(variance, pilot.options.question.h1 - pilot.options.question.h0);
  // the sequential test gives no answer before this number of pairs
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

}  // namespace sim::report
