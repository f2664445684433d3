#include "sim/report/learn_page.h"

#include <algorithm>
#include <cmath>

#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/compare/verdict.h"
#include "sim/report/page.h"
#include "sim/report/plot.h"

namespace sim::report {
namespace {

using learn::Against, learn::Course, learn::CurvePoint, learn::Lesson;
using robot::formatted;

constexpr const char* kLearnStyle = R"(
h2 { font-size: 18px; margin: 26px 0 4px; } .soft { color: var(--soft); } .verdict { font-size: 22px; margin: 10px 0; }
.card { padding: 10px 16px; overflow-x: auto; } ul { padding-left: 20px; margin: 6px 0; }
th, td { padding: 3px 16px 3px 0; text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; } .sure { font-weight: 600; } .worse { font-weight: 600; color: var(--bad); }
svg { display: block; max-width: 640px; width: 100%; } svg text { fill: var(--soft); font-size: 11px; } circle.end { stroke: none; } circle.training { fill: var(--open); }
circle.held { fill: var(--blue); } .card + .card { margin-top: 10px; } .training { stroke: var(--open); fill: none; stroke-width: 2; }
.held { stroke: var(--blue); fill: none; stroke-width: 2.5; } .band { fill: var(--blue); opacity: 0.18; }
.zero { stroke: var(--line); } .legend b { font-weight: 600; } .legend .t { color: var(--open); }
.legend .h { color: var(--blue); }
)";

std::vector<std::string> lines_of(const std::vector<learn::Change>& changes) {
  std::vector<std::string> lines;
  for (const learn::Change& change : changes) lines.push_back(text_of(change));
  return lines;
}

double percent(int part, int all) { return all == 0 ? 0 : 100. * part / all; }

/// Returns the verdict as a sentence.
std::string verdict_of(const Course& course) {
  if (course.changes.empty()) return "Nothing was learned: no change won its test.";
  if (!course.gate.empty() && course.better) return "The learned tree is better.";
  return "The learned tree is not proved better.";
}

std::string sentence_of(const Against& against) {
  const compare::Interval gain = compare::gain_per_game(against.outcome.tally);
  return formatted("%s: %+.3f goals a game (95 %%: %+.3f .. %+.3f), %lld pairs: %s",
                   against.opponent.empty() ? "against the start" : ("both against " + against.opponent).c_str(),
                   gain.mean, gain.low, gain.high, static_cast<long long>(against.outcome.tally.pairs),
                   against.opponent.empty() ? std::string(name(against.outcome.verdict)).c_str()
                   : against.passed         ? "not worse"
                                            : "worse");
}

/// Returns whether an exercise surely became worse.
bool is_worse(const Lesson::Success& success) {
  return learn::is_sure({.mean = -success.gain.mean, .error = success.gain.error});
}

std::string success_line(const Lesson::Success& success) {
  return formatted("%-32s %5.1f %% → %5.1f %%   %+.1f ± %.1f of %d%s", success.exercise.c_str(),
                   percent(success.before, success.attempts), percent(success.after, success.attempts),
                   100 * success.gain.mean, 100 * learn::kSure * success.gain.error, success.attempts,
                   is_worse(success) ? "  WORSE" : "");
}

/// Draws the gain of the mean on held-out seeds, and that of the best candidate on its own seeds.
std::string curve_svg(const std::vector<CurvePoint>& curve) {
  double most = 0.02, least = 0;
  std::vector<double> x, low, high;
  std::vector<std::pair<double, double>> training, held;
  for (const CurvePoint& point : curve) {
    x.push_back(point.generation);
    low.push_back(point.held_out - learn::kSure * point.error);
    high.push_back(point.held_out + learn::kSure * point.error);
    training.emplace_back(point.generation, point.training);
    held.emplace_back(point.generation, point.held_out);
    most = std::max({most, high.back(), point.training}), least = std::min({least, low.back(), point.training});
  }
  Plot plot(0, curve.back().generation, least, 1.1 * most);
  plot.band("band", x, low, high);
  plot.level("zero", 0, "");
  plot.line("training", training);
  plot.line("held", held);
  return plot.svg("gain over the start by generation", "generation");
}

std::string list_of(const std::vector<std::string>& lines) {
  std::string list = "<ul>";
  for (const std::string& line : lines) list.append("<li>").append(escaped(line)).append("</li>");
  return list + "</ul>";
}

std::string successes_table(const Lesson& lesson) {
  std::string table = "<table><tr><th>exercise</th><th>before</th><th>after</th><th>gain</th><th>attempts</th></tr>";
  for (const Lesson::Success& success : lesson.successes)
    table += formatted("<tr><td>%s</td><td>%.1f %%</td><td>%.1f %%</td><td%s>%+.1f ± %.1f</td><td>%d</td></tr>",
                       escaped(success.exercise).c_str(), percent(success.before, success.attempts),
                       percent(success.after, success.attempts),
                       is_worse(success)              ? " class=\"worse\""
                       : learn::is_sure(success.gain) ? " class=\"sure\""
                                                      : "",
                       100 * success.gain.mean, 100 * learn::kSure * success.gain.error, success.attempts);
  return table + "</table>";
}

std::string lesson_section(const Lesson& lesson) {
  std::string section = "<h2>" + escaped(lesson.name) + "</h2><p class=\"soft\">" + escaped(lesson.about) + "</p>";
  section += "<div class=\"card\">" + successes_table(lesson) + "</div>";
  if (lesson.curve.size() > 1)
    section += "<div class=\"card\">" + curve_svg(lesson.curve) +
               "<p class=\"legend soft\">Points gained over the start: <b class=\"h\">the mean</b> on seeds that chose "
               "nothing, with 95 %; <b class=\"t\">the best candidate</b> on the seeds that chose it, which is too "
               "good.</p></div>";
  if (!lesson.changes.empty()) section += "<p>Changed:</p>" + list_of(lines_of(lesson.changes));
  return section + "<details><summary>What was tried</summary>" + list_of(lesson.notes) + "</details>";
}

Json gain_json(const contest::Mean& gain) { return {{"mean", gain.mean}, {"error", gain.error}}; }

Json lesson_json(const Lesson& lesson) {
  Json json = {{"name", lesson.name},
               {"changes", lines_of(lesson.changes)},
               {"notes", lesson.notes},
               {"curve", Json::array()},
               {"successes", Json::array()}};
  for (const CurvePoint& point : lesson.curve)
    json["curve"].push_back({{"generation", point.generation},
                             {"training", point.training},
                             {"held_out", point.held_out},
                             {"error", point.error}});
  for (const Lesson::Success& success : lesson.successes)
    json["successes"].push_back({{"exercise", success.exercise},
                                 {"attempts", success.attempts},
                                 {"before", success.before},
                                 {"after", success.after},
                                 {"gain", gain_json(success.gain)}});
  return json;
}

}  // namespace

std::string learn_text(const Course& course) {
  std::string text;
  for (const Lesson& lesson : course.lessons) {
    text += lesson.name + ": " + lesson.about + "\n";
    for (const std::string& note : lesson.notes) text.append("  ").append(note).append("\n");
    for (const Lesson::Success& success : lesson.successes)
      text.append("  ").append(success_line(success)).append("\n");
    text += "\n";
  }
  text += verdict_of(course) + "\n";
  for (const std::string& change : lines_of(course.changes)) text.append("  ").append(change).append("\n");
  for (const Against& against : course.gate) text.append("  ").append(sentence_of(against)).append("\n");
  return text;
}

Json learn_json(const Course& course) {
  Json json = {{"better", course.better}, {"changes", lines_of(course.changes)},       {"lessons", Json::array()},
               {"gate", Json::array()},   {"first_test_seed", course.first_test_seed}, {"strategy", course.learned}};
  for (const Lesson& lesson : course.lessons) json["lessons"].push_back(lesson_json(lesson));
  for (const Against& against : course.gate) {
    const compare::Interval gain = compare::gain_per_game(against.outcome.tally);
    json["gate"].push_back({{"opponent", against.opponent},
                            {"passed", against.passed},
                            {"verdict", name(against.outcome.verdict)},
                            {"pairs", against.outcome.tally.pairs},
                            {"gain", {{"mean", gain.mean}, {"low", gain.low}, {"high", gain.high}}}});
  }
  return json;
}

std::string learn_page(const Course& course) {
  const std::string title = "Learned from " + course.start.value("name", std::string("a tree"));
  std::string body = "<h1>" + escaped(title) + "</h1><p class=\"verdict\">" + escaped(verdict_of(course)) + "</p>";
  std::vector<std::string> answers;
  for (const Against& against : course.gate) answers.push_back(sentence_of(against));
  body += list_of(answers);
  if (!course.changes.empty()) body += "<h2>What changed</h2>" + list_of(lines_of(course.changes));
  for (const Lesson& lesson : course.lessons) body += lesson_section(lesson);
  return html_page(title, kLearnStyle, body);
}

}  // namespace sim::report
