#include "sim/environment/description.h"

#include "robot/core/json_library.h"
#include "sim/io/json.h"
#include "sim/world/world.h"

namespace sim::environment {
namespace {

using io::Json;

Json columns_of(const agent::Columns& columns) {
  Json list = Json::array();
  for (const agent::Column& column : columns.list()) {
    const agent::FeatureInfo& info = agent::info_of(column.feature);
    list.push_back({{"name", agent::name_of(column)},
                    {"feature", info.name},
                    {"unit", info.unit},
                    {"formula", agent::formula_of(column)},
                    {"about", info.about}});
  }
  return list;
}

/// Returns the path of each rule.
Json menu_of(const agent::Tree& tree) {
  Json list = Json::array();
  for (const std::uint16_t entry : tree.menu) {
    const bool is_leaf = (entry & agent::kLeafBit) != 0;
    const std::size_t index = entry & ~std::size_t{agent::kLeafBit};
    list.push_back(is_leaf ? tree.leaf_words[index].path : tree.node_words[index].path);
  }
  return list;
}

Json skills() {
  Json list = Json::array();
  for (int i = 0; i < agent::skill_count(); ++i) {
    const agent::SkillInfo& skill = agent::info_of(static_cast<agent::Skill>(i));
    Json parameters = Json::array();
    for (int p = 0; p < skill.count; ++p) {
      const auto& [name, range, standard, about] = skill.parameters[p];
      parameters.push_back({{"name", name},
                            {"unit", range.unit},
                            {"least", io::short_number(range.least)},
                            {"most", io::short_number(range.most)},
                            {"whole", range.names != nullptr}});
    }
    list.push_back({{"skill", skill.name}, {"parameters", parameters}});
  }
  return list;
}

Json actions_of(const Options& options) {
  if (options.actions == Kind::menu) return menu_of(options.frame.tree);
  return options.actions == Kind::skills ? skills() : Json(kMotionNames);
}

}  // namespace

std::string name_of_agent(int robot) {
  return (side_of(robot) == Side::home ? "home_" : "away_") + std::to_string(player_of(robot));
}

std::string description_of(const Options& options, const std::vector<int>& agents) {
  Json names = Json::array();
  for (const int robot : agents) names.push_back(name_of_agent(robot));
  return Json{{"drill", options.drill.name},
              {"kind", kKinds[static_cast<int>(options.actions)]},
              {"tick_seconds", 1.0 / kTicksPerSecond},
              {"ticks", options.ticks},
              {"agents", names},
              {"columns", columns_of(options.frame.columns)},
              {"actions", actions_of(options)}}
      .dump();
}

}  // namespace sim::environment
