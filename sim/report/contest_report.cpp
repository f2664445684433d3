#include "sim/report/contest_report.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <optional>

namespace sim::report {
namespace {

using robot::formatted;

using compare::Interval;
using compare::kA;
using compare::kB;
using compare::Verdict;

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
  return choice.changed > 0 ? choice.b + formatted(" of players 1 .. %d", choice.changed) : choice.b;
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
  if (choice.seconds > 0) command += formatted(" --seconds %g", choice.seconds);
  return command + " --seed " + std::to_string(report.comparison.seed_of(pair.number)) + " --mcap game.mcap";
}

/// Returns null for an unknown bound: it is infinite, and JSON has no infinity.
Json bound_json(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json to_json(const Interval& interval) {
  return {{"mean", interval.mean}, {"low", bound_json(interval.low)}, {"high", bound_json(interval.high)}};
}

/// Reports whether a sequential test has answered, so that its early stop makes the plain gain too extreme.
bool is_corrected(const ContestReport& report) {
  return report.outcome.sequential && compare::pair_variance(report.outcome.tally, report.comparison.unit()) > 0;
}

/// Returns the question with its h1 in the metric's unit.
compare::Hypothesis question_of(const ContestReport& report) {
  return compare::asked(report.options.question, report.outcome.tally, report.comparison.unit());
}

/// The gain that a sentence has: after the answer of a sequential test, the corrected one.
struct ShownGain {
  Interval per_game;
  bool corrected = false;

  /// Whether the whole 95 % interval lies below 0. "Not better" would hide it.
  bool is_worse() const { return per_game.high < 0; }
};

ShownGain shown_gain(const ContestReport& report) {
  const compare::PairStatistics& tally = report.outcome.tally;
  const double unit = report.comparison.unit();
  if (!is_corrected(report)) return {.per_game = compare::gain_per_game(tally, unit)};
  return {.per_game = compare::unbiased_gain(tally, report.options.question, unit), .corrected = true};
}

/// "+0.123 goals per game (95 %: +0.045 .. +0.201)", with the correction.
std::string text_of(const ShownGain& gain, const ContestReport& report) {
  const auto& [mean, low, high] = gain.per_game;
  return formatted("%+.3f %s per game (95 %%: %+.3f .. %+.3f%s)", mean, noun(report.comparison.choice().metric), low,
                   high, gain.corrected ? ", corrected for the early stop" : "");
}

/// "0.098 per game, which is 0.1 of its standard deviation", or only the number if it was asked for.
std::string h1_of(const ContestReport& report) {
  const compare::Hypothesis question = question_of(report);
  std::string said = formatted("%.2g per game", question.h1);
  if (question.part > 0) said += formatted(" (%g of its standard deviation)", question.part);
  return said;
}

}  // namespace

std::string games_without_pairs(double pairing_gain) {
  return formatted("%.0f %% %s games", 100 * std::abs(pairing_gain - 1), pairing_gain < 1 ? "fewer" : "more");
}

std::string sentence_of(const ContestReport& report) {
  const contest::ComparisonChoice& choice = report.comparison.choice();
  const compare::PairStatistics& tally = report.outcome.tally;
  const std::string a = choice.a, b = name_of_b(choice);
  const ShownGain gain = shown_gain(report);
  const std::string amount = text_of(gain, report);
  switch (report.outcome.verdict) {
    case Verdict::better: return b + " is better than " + a + ": " + amount;
    case Verdict::not_better:
      return b + (gain.is_worse() ? " is worse than " + a : " is not better than " + a + " by " + h1_of(report)) +
             ": " + amount;
    case Verdict::undecided: return "undecided whether " + b + " is better than " + a + ": " + amount;
    case Verdict::identical: return b + " and " + a + " are identical: each plays the games of the other";
    case Verdict::too_rare:
      return "too rare to tell whether " + b + " is better than " + a +
             formatted(": %lld of %lld pairs had a gain; raise --pairs or choose a longer metric",
                       static_cast<long long>(tally.uneven), static_cast<long long>(tally.pairs));
  }
  return "";
}

Json to_json(const ContestReport& report) {
  const auto& [comparison, options, outcome] = report;
  const compare::PairStatistics& tally = outcome.tally;
  const double unit = comparison.unit();
  const ShownGain shown = shown_gain(report);
  const compare::Hypothesis question = question_of(report);
  const double ratio = compare::llr(tally, question, unit);
  const compare::Bounds bounds = compare::bounds_of(question);
  Json json = {{"run", Json::parse(comparison.specification())},
               {"verdict", compare::name(outcome.verdict)},
               {"sentence", sentence_of(report)},
               {"worse", shown.is_worse()},
               {"pairs", tally.pairs},
               {"games", games_of(outcome)},
               {"different_pairs", outcome.different},
               {"uneven_pairs", tally.uneven},
               {"same_pairs", tally.same},
               {"gain", to_json(compare::gain_per_game(tally, unit))},
               {"unbiased_gain", shown.corrected ? to_json(shown.per_game) : Json()},
               {"llr", std::isfinite(ratio) ? Json(ratio) : Json()},
               {"bounds", {bounds.h0, bounds.h1}},
               {"h0", question.h0},
               {"h1", question.h1},
               {"h1_part", question.part},
               {"standard_deviation", std::sqrt(compare::pair_variance(tally, unit))}};
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
  out += formatted("%-22s%12s%12s\n", "", "A", "B");
  out += formatted("%-22s%12s%12s\n", "", shortened(choice.a).c_str(), shortened(choice.b).c_str());
  out += formatted("%-22s%12.3f%12.3f\n", "goals per game", per_game(outcome, tally.goals[kA]),
                   per_game(outcome, tally.goals[kB]));
  out += formatted("%-22s%12.3f%12.3f\n", "conceded", per_game(outcome, tally.conceded[kA]),
                   per_game(outcome, tally.conceded[kB]));
  out += formatted("%-22s%12lld%12lld\n", "won", static_cast<long long>(tally.lost), static_cast<long long>(tally.won));
  out += formatted("%-22s%12lld\n", "drawn", static_cast<long long>(tally.drawn));
  if (outcome.cost[kA].timed > 0)
    out +=
        formatted("%-22s%12.2f%12.2f us\n", "a decision costs", outcome.cost[kA].mean_us(), outcome.cost[kB].mean_us());
  out += "\n";

  out += formatted("games            %lld in %lld pairs", static_cast<long long>(games_of(outcome)),
                   static_cast<long long>(tally.pairs));
  out += outcome.different == tally.pairs
             ? ", no two alike"
             : formatted(", %lld of them different", static_cast<long long>(outcome.different));
  // blocks from the disk took no time
  if (outcome.cost[kA].timed > 0)
    out += formatted(", %.0f s, %.0f a minute", outcome.seconds,
                     static_cast<double>(games_of(outcome)) * 60 / std::max(outcome.seconds, 1e-3));
  out += "\n";
  const compare::Hypothesis question = question_of(report);
  const compare::Bounds bounds = compare::bounds_of(question);
  if (!options.pairs)
    out += formatted("test             LLR %+.2f of %+.2f for %.3g, %+.2f for %.3g\n",
                     compare::llr(tally, question, comparison.unit()), bounds.h0, question.h0, bounds.h1, question.h1);
  if (question.h1 > question.h0 && question.part > 0)
    out += formatted(
        "asked            is the gain at least %.3g per game? %g of its standard deviation over these pairs, %.3g\n",
        question.h1, question.part, std::sqrt(compare::pair_variance(tally, comparison.unit())));
  if (const double gain = compare::pairing_gain(tally); gain > 0)
    out += formatted("pairing gain     %.2f: without pairs, the same interval takes %s\n", gain,
                     games_without_pairs(gain).c_str());
  const Interval home = compare::home_advantage(tally, comparison.unit());
  out +=
      formatted("%-16s %+.3f (95 %%: %+.3f .. %+.3f)%s\n", choice.situation.empty() ? "home advantage" : "the moment",
                home.mean, home.low, home.high, choice.situation.empty() ? "" : " for the home side's place in it");
  out += "holds for        rules " + choice.rules + ", models " + choice.models + " (not fitted to robots of yours)\n";
  if (is_corrected(report)) {
    const Interval plain = compare::gain_per_game(tally, comparison.unit());
    out += formatted("plain mean       %+.3f (95 %%: %+.3f .. %+.3f), which an early stop makes too extreme\n",
                     plain.mean, plain.low, plain.high);
  }
  if (!explain) return out;

  out += "\nmost decisive pairs, with the game that B plays at home\n";
  for (const contest::DecisivePair& pair : outcome.decisive)
    out += formatted("  %+g  ", pair.gain / comparison.unit()) + replay_of(report, pair) + "\n";
  return out;
}

}  // namespace sim::report
