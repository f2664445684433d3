#include "sim/report/coverage_report.h"

#include <algorithm>
#include <cmath>

#include "robot/core/json_library.h"
#include "robot/core/text.h"

namespace sim::report {
namespace {

using debug::Asked, debug::MeanGain, debug::Part, debug::Visits;
using robot::formatted;

constexpr std::size_t kPartWidth = 56;

double ratio(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

double mean_stay(const Visits& visits) {
  return visits.stays > 0 ? static_cast<double>(visits.ticks) * static_cast<double>(kTickDuration) /
                                static_cast<double>(visits.stays)
                          : 0;
}

/// Returns the beginning of a text, with three dots where it is cut.
std::string shortened(const std::string& text, std::size_t most) {
  return text.size() <= most ? text : text.substr(0, most - 3) + "...";
}

std::string mean_gain_text(const MeanGain& gain) {
  return std::isfinite(gain.half_width) ? formatted("%+.3f +-%.3f", gain.mean, gain.half_width)
                                        : formatted("%+.3f", gain.mean);
}

std::string part_line(const CoverageReport& report, std::size_t number) {
  const Part& part = report.parts.all()[number];
  const Visits& visits = report.coverage.parts[number];
  const std::string name = std::string(2 * static_cast<std::size_t>(part.depth), ' ') + part.name +
                           (part.skill.empty() || part.skill == part.name ? "" : " (" + part.skill + ")");
  std::string row = formatted("%-*s", static_cast<int>(kPartWidth), shortened(name, kPartWidth).c_str());
  if (visits.decisions == 0) return row + "  never\n";
  return row + formatted(" %6.2f %% %9.2f %8.2f s %6.1f %%  %s\n", 100 * report.time_share(number),
                         ratio(visits.stays, report.coverage.games), mean_stay(visits),
                         100 * ratio(visits.interrupted, visits.stays),
                         mean_gain_text(gain_of(visits, report.coverage.games)).c_str());
}

std::string answers_of(const Asked& asked) {
  std::string text = formatted("%s, %lld times", asked.yes > 0 ? "yes" : "no", static_cast<long long>(asked.times()));
  if (asked.unknown == asked.no && asked.no > 0) text += ", because the value is unknown";
  return text;
}

}  // namespace

double CoverageReport::time_share(std::size_t part) const {
  return ratio(coverage.parts[part].ticks, coverage.parts.front().ticks);
}

std::vector<std::size_t> CoverageReport::never_reached() const {
  std::vector<std::size_t> never;
  for (std::size_t i = 0; i < coverage.parts.size(); ++i) {
    if (coverage.parts[i].decisions > 0) continue;
    const std::string& path = parts.all()[i].path;
    if (never.empty() || !path.starts_with(parts.all()[never.back()].path + "/")) never.push_back(i);
  }
  return never;
}

std::vector<std::size_t> CoverageReport::always_same() const {
  std::vector<std::size_t> same;
  for (std::size_t i = coverage.comparisons.size(); i-- > 0;)
    if (const Asked& asked = coverage.comparisons[i]; (asked.yes > 0) != (asked.no > 0)) same.push_back(i);
  return same;
}

std::string to_text(const CoverageReport& report) {
  std::string text = "The tree " + report.parts.tree().name + " " + report.about + ".\n\n";
  text += formatted("%-*s %8s %9s %10s %8s  %s\n", static_cast<int>(kPartWidth), "part", "time", "stays", "mean stay",
                    "broken", "goals within 30 s");
  for (std::size_t i = 0; i < report.parts.all().size(); ++i) text += part_line(report, i);
  text +=
      "\ntime: share of the time in play; stays: per game; broken: stays that began less than 0.5 s after the last;\n"
      "goals: own minus theirs after a decision, with the 95 % interval.\n";

  const std::vector<std::size_t> never = report.never_reached(), same = report.always_same();
  if (!never.empty()) text += "\nnever reached\n";
  for (const std::size_t part : never) text += "  " + report.parts.all()[part].path + "\n";
  if (!same.empty()) text += "\nalways the same answer\n";
  for (const std::size_t node : same)
    text += formatted("  %4zu  %-38s %s\n", node, report.parts.tree().node_words[node].condition.c_str(),
                      answers_of(report.coverage.comparisons[node]).c_str());
  return text;
}

Json to_json(const CoverageReport& report) {
  Json parts = Json::array(), comparisons = Json::array();
  for (std::size_t i = 0; i < report.parts.all().size(); ++i) {
    const Part& part = report.parts.all()[i];
    const Visits& visits = report.coverage.parts[i];
    Json row = {{"path", part.path},     {"decisions", visits.decisions},    {"time_share", report.time_share(i)},
                {"stays", visits.stays}, {"mean_stay_s", mean_stay(visits)}, {"interrupted", visits.interrupted}};
    if (!part.skill.empty()) row["skill"] = part.skill;
    if (visits.decisions > 0) {
      const MeanGain gain = gain_of(visits, report.coverage.games);
      row["goals_within_30_s"] = gain.mean;
      if (std::isfinite(gain.half_width)) row["half_width"] = gain.half_width;
    }
    parts.push_back(std::move(row));
  }
  for (std::size_t i = report.coverage.comparisons.size(); i-- > 0;) {
    const Asked& asked = report.coverage.comparisons[i];
    const agent::Words& words = report.parts.tree().node_words[i];
    comparisons.push_back({{"node", i},
                           {"path", words.path},
                           {"condition", words.condition},
                           {"yes", asked.yes},
                           {"no", asked.no},
                           {"unknown", asked.unknown}});
  }
  return {{"strategy", report.parts.tree().name},
          {"games", report.coverage.games},
          {"parts", std::move(parts)},
          {"comparisons", std::move(comparisons)}};
}

}  // namespace sim::report
