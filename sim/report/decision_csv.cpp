#include "sim/report/decision_csv.h"

#include <cmath>
#include <set>
#include <string_view>

#include "robot/core/csv.h"
#include "robot/core/text.h"
#include "sim/math/angles.h"

namespace sim::report {
namespace {

using agent::Feature, agent::FeatureInfo;
using robot::csv_cell, robot::formatted;

/// Returns the features that the tree reads, in the order of the table.
std::set<Feature> features_of(const agent::Tree& tree) {
  std::set<Feature> features;
  for (const agent::Node& node : tree.nodes) {
    features.insert(node.feature);
    if (node.other != agent::kNoFeature) features.insert(node.other);
  }
  return features;
}

std::string csv_value(const FeatureInfo& info, float value) {
  if (std::isnan(value)) return "";
  if (info.kind == FeatureInfo::Kind::yes_no) return value > 0.5f ? "yes" : "no";
  if (info.kind == FeatureInfo::Kind::name) return info.names[static_cast<int>(value)];
  const bool is_angle = std::string_view(info.unit) == "rad";
  return formatted("%.9g", static_cast<double>(is_angle ? kDegrees * value : value));
}

}  // namespace

std::string csv_head(const agent::Tree& tree) {
  std::string head = "time [s],skill,role,leaf";
  for (const Feature feature : features_of(tree)) {
    const FeatureInfo& info = agent::info_of(feature);
    const std::string_view unit = std::string_view(info.unit) == "rad" ? "deg" : info.unit;
    head += ",";
    head += csv_cell(info.name + (unit.empty() ? std::string() : " [" + std::string(unit) + "]"));
  }
  return head + "\n";
}

std::string csv_row(const agent::Tree& tree, const debug::LoggedDecision& logged) {
  std::string row =
      formatted("%.4f,%s,%s,", static_cast<double>(age(logged.decision.tick, 0)), logged.skill, logged.role);
  if (logged.evaluation) row += csv_cell(tree.leaf_words[logged.evaluation->leaf].path);
  for (const Feature feature : features_of(tree)) {
    row += ",";
    if (logged.evaluation) row += csv_value(agent::info_of(feature), logged.values[debug::index_of(feature)]);
  }
  return row + "\n";
}

}  // namespace sim::report
