#include "robot/fit/checking/checking.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/core/text.h"

namespace robot::fit {
namespace {

constexpr double kFarthestDrawn = 3;  // half intervals

void append(std::vector<Statistic> more, std::vector<Statistic>& all) {
  for (Statistic& one : more)
    if (std::isfinite(one.recorded)) all.push_back(std::move(one));
}

std::string number(double value, const std::string& unit) {
  return formatted("%.3g%s%s", value, unit.empty() ? "" : " ", unit.c_str());
}

Results results_of(const std::vector<Statistic>& statistics, const std::vector<Verdict>& verdicts) {
  Results results{.title = "Recorded and simulated",
                  .head = {"", "statistic", "recorded", "simulated", "verdict", "events"},
                  .rows = {}};
  for (std::size_t i = 0; i < statistics.size(); ++i) {
    const Statistic& one = statistics[i];
    const Verdict& verdict = verdicts[i];
    results.rows.push_back({std::to_string(i + 1), one.name, number(one.recorded, one.unit),
                            formatted("%.3g .. %.3g", verdict.low, verdict.high), verdict.inside ? "inside" : "OUTSIDE",
                            formatted("%zu %s", one.events, one.kind.c_str())});
  }
  return results;
}

Picture picture_of(const std::vector<Statistic>& statistics, const std::vector<Verdict>& verdicts) {
  const double right = static_cast<double>(statistics.size()) + 0.5;
  Mark dots{.label = "recorded", .x = {}, .y = {}, .high = {}};
  for (std::size_t i = 0; i < statistics.size(); ++i) {
    dots.x.push_back(static_cast<double>(i + 1));
    dots.y.push_back(std::clamp(verdicts[i].distance(statistics[i].recorded), -kFarthestDrawn, kFarthestDrawn));
  }
  const auto line = [&](double y, const char* label) {
    return Mark{.shape = Mark::Shape::line,
                .role = Mark::Role::other,
                .label = label,
                .x = {0.5, right},
                .y = {y, y},
                .high = {}};
  };
  return {.title = "Each statistic beside its simulated interval",
          .x_label = "number of the statistic in the table",
          .y_label = "distance from the simulated median [half intervals, at most 3]",
          .axes = {.left = 0.5, .right = right, .bottom = -1.1 * kFarthestDrawn, .top = 1.1 * kFarthestDrawn},
          .marks = {line(-1, "ends of the interval"), line(1, ""), std::move(dots)}};
}

}  // namespace

Situations read_situations(const Evidence& evidence, const sim::Models& models) {
  Situations situations;
  std::vector<std::string> recordings;
  situations.drives = read_drives(evidence);
  situations.kicks = seen_kicks(evidence, kick_facts_of(models), recordings);
  for (std::size_t i = 0; i < evidence.games.size(); ++i) {
    const std::vector<Roll> rolls = rolls_in(evidence.games[i]->record, i);
    situations.rolls.insert(situations.rolls.end(), rolls.begin(), rolls.end());
  }
  situations.falls =
      read_falls(evidence, {.upright = models.contact.robot_radius, .lying = models.contact.lying_radius});
  situations.packets = read_teams(evidence);
  situations.looks = read_looks(evidence, models);
  situations.balls = read_ball_places(evidence);
  return situations;
}

Report check_models(const Situations& situations, const sim::Models& models) {
  Report report{.name = "check", .title = "What was recorded, simulated with these models"};
  std::vector<Statistic> statistics;
  append(check_walk(situations.drives, models, report.notes), statistics);
  append(check_kicks(situations.kicks, models, report.notes), statistics);
  append(check_rolls(situations.rolls, models, report.notes), statistics);
  append(check_falls(situations.falls, models, report.notes), statistics);
  append(check_packets(situations.packets, models, report.notes), statistics);
  append(check_sights(sights_of(situations.looks, models), models, report.notes), statistics);
  append(check_noise(situations.balls, models, report.notes), statistics);
  append(check_false_balls(situations.looks, models, report.notes), statistics);
  const std::vector<Verdict> verdicts = judge(statistics);
  const auto outside = std::ranges::count(verdicts, false, &Verdict::inside);
  report.scores = {{"statistics", static_cast<double>(statistics.size())}, {"outside", static_cast<double>(outside)}};
  if (statistics.empty()) {
    report.notes.insert(report.notes.begin(),
                        "nothing can be checked: expected robots that walk, kick, fall or see the ball beside a truth");
    return report;
  }
  report.results.push_back(results_of(statistics, verdicts));
  report.pictures.push_back(picture_of(statistics, verdicts));
  return report;
}

Report check_models(const Evidence& evidence, const sim::Models& models) {
  return check_models(read_situations(evidence, models), models);
}

}  // namespace robot::fit
