#include "sim/check/report.h"

#include <algorithm>
#include <cstdio>

#include "robot/core/json_library.h"

namespace sim::check {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kVerdicts[] = {"", "passed", "unsure", "FAILED"};  // by Verdict

int count(const std::vector<Checked>& all, Verdict verdict) {
  int sum = 0;
  for (const Checked& one : all) sum += static_cast<int>(std::ranges::count(one.findings, verdict, &Finding::verdict));
  return sum;
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string limits_of(const NamedMetric& metric) {
  std::string text;
  if (metric.at_least) text += "at least " + number(*metric.at_least);
  if (metric.at_most) text += (text.empty() ? "" : ", ") + ("at most " + number(*metric.at_most));
  return text;
}

/// Returns the cells of one line.
std::vector<std::string> cells_of(const std::string& situation, const Finding& finding) {
  const bool has_value = finding.games > 0;
  return {situation,
          finding.metric->name,
          std::to_string(finding.games),
          has_value ? number(finding.mean) : "none",
          has_value ? number(finding.interval.low) + " .. " + number(finding.interval.high) : "",
          limits_of(*finding.metric),
          kVerdicts[static_cast<int>(finding.verdict)]};
}

std::string table(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines.front().size());
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  std::string text;
  for (const auto& line : lines) {
    std::string padded;
    for (std::size_t i = 0; i < line.size(); ++i) padded += line[i] + std::string(widths[i] - line[i].size() + 2, ' ');
    padded.erase(padded.find_last_not_of(' ') + 1);
    text += padded + "\n";
  }
  return text;
}

}  // namespace

bool all_passed(const std::vector<Checked>& all) { return count(all, Verdict::failed) == 0; }

std::string to_text(const std::vector<Checked>& all) {
  std::vector<std::vector<std::string>> lines = {
      {"situation", "metric", "games", "mean", "95 %", "expected", "verdict"}};
  for (const Checked& one : all)
    for (const Finding& finding : one.findings) lines.push_back(cells_of(one.scenario->name, finding));
  return table(lines) + "\n" + std::to_string(count(all, Verdict::passed)) + " passed, " +
         std::to_string(count(all, Verdict::unsure)) + " unsure, " + std::to_string(count(all, Verdict::failed)) +
         " failed\n";
}

Json to_json(const std::vector<Checked>& all) {
  constexpr const char* kWords[] = {"none", "passed", "unsure", "failed"};  // by Verdict
  Json situations = Json::array();
  for (const Checked& one : all) {
    Json metrics = Json::array();
    for (const Finding& finding : one.findings) {
      const NamedMetric& metric = *finding.metric;
      Json json = Json::object();
      json["name"] = metric.name;
      json["metric"] = metric.text;
      json["games"] = finding.games;
      json["mean"] = finding.games > 0 ? Json(finding.mean) : Json();
      json["low"] = finding.games > 0 ? Json(finding.interval.low) : Json();
      json["high"] = finding.games > 0 ? Json(finding.interval.high) : Json();
      if (metric.at_least) json["at_least"] = *metric.at_least;
      if (metric.at_most) json["at_most"] = *metric.at_most;
      json["verdict"] = kWords[static_cast<int>(finding.verdict)];
      metrics.push_back(std::move(json));
    }
    Json situation = Json::object();
    situation["file"] = one.scenario->name;
    situation["about"] = one.scenario->about;
    situation["home"] = one.scenario->game.strategies[0];
    situation["away"] = one.scenario->game.strategies[1];
    situation["seeds"] = one.scenario->seeds;
    situation["metrics"] = std::move(metrics);
    situations.push_back(std::move(situation));
  }
  Json json = Json::object();
  json["passed"] = all_passed(all);
  json["situations"] = std::move(situations);
  return json;
}

}  // namespace sim::check
