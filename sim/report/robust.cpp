#include "sim/report/robust.h"
#include "robot/core/json_library.h"

#include <cstdio>

namespace sim::report {
namespace {

std::string name_of(const UnderConditions& each) { return each.conditions.empty() ? "as modelled" : each.conditions; }

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

}  // namespace

std::vector<std::string> turned_by(const std::vector<UnderConditions>& found) {
  std::vector<std::string> names;
  for (const UnderConditions& each : found)
    if (each.verdict != found.front().verdict) names.push_back(name_of(each));
  return names;
}

std::string robust_sentence(const contest::ComparisonChoice& choice, const std::vector<UnderConditions>& found) {
  const std::string verdict(compare::name(found.front().verdict));
  const std::string said = choice.b + " against " + choice.a + ": " + verdict;
  const std::vector<std::string> turning = turned_by(found);
  if (turning.empty()) return said + " throughout, under all " + std::to_string(found.size()) + " models";
  return said + " under these models; another verdict with " + listed(turning);
}

Json robust_json(const contest::ComparisonChoice& choice, const std::vector<UnderConditions>& found) {
  Json json = {{"sentence", robust_sentence(choice, found)},
               {"verdict", compare::name(found.front().verdict)},
               {"throughout", turned_by(found).empty()},
               {"turned_by", turned_by(found)},
               {"conditions", Json::array()}};
  for (const UnderConditions& each : found)
    json["conditions"].push_back(
        {{"name", name_of(each)},
         {"verdict", compare::name(each.verdict)},
         {"gain", {{"mean", each.gain.mean}, {"low", each.gain.low}, {"high", each.gain.high}}},
         {"pairs", each.pairs}});
  return json;
}

std::string robust_text(const contest::ComparisonChoice& choice, const std::vector<UnderConditions>& found) {
  std::string out = robust_sentence(choice, found) + "\n\n";
  for (const UnderConditions& each : found) {
    char line[200];
    std::snprintf(line, sizeof line, "%-18s%-12s %+.3f (95 %%: %+.3f .. %+.3f), %lld pairs\n", name_of(each).c_str(),
                  std::string(compare::name(each.verdict)).c_str(), each.gain.mean, each.gain.low, each.gain.high,
                  static_cast<long long>(each.pairs));
    out += line;
  }
  return out + "\nrules " + choice.rules + ", models " + choice.models + " (not fitted to robots of yours)\n";
}

}  // namespace sim::report
