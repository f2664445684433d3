#include "sim/learn/layer.h"

#include <algorithm>
#include <filesystem>

#include "robot/core/json_library.h"
#include "sim/io/reader.h"
#include "sim/io/source.h"
#include "sim/io/vocabulary.h"

namespace sim::learn {
namespace {

using io::Json, io::Reader;
using robot::Result;

/// Reads a list of names that `known` knows.
template <class Known>
std::vector<std::string> names_in(Reader& reader, const Json& json, const char* key, const Known& known) {
  std::vector<std::string> names;
  const auto list = json.find(key);
  if (list == json.end()) return names;
  if (!list->is_array()) {
    reader.refuse(std::string(key) + " must be a list of names, got " + io::shown(*list));
    return names;
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string place = std::string(key) + "[" + std::to_string(i) + "]";
    if (!(*list)[i].is_string()) {
      reader.refuse(place + " must be a text, got " + io::shown((*list)[i]));
      continue;
    }
    names.push_back((*list)[i].get<std::string>());
    if (const auto found = known(names.back()); !found) reader.refuse(place + ": " + found.error());
  }
  return names;
}

void read_actions(Reader& reader, const Json& json, Layer& layer) {
  const auto list = json.find("actions");
  if (list == json.end()) return;
  bool good = list->is_array();
  for (const Json& action : *list) good = good && action.is_object() && action.contains("do");
  if (!good) return reader.refuse("actions must be a list of rules with 'do', got " + io::shown(*list));
  for (const Json& action : *list) layer.actions.push_back(action.dump());
}

void read_exercises(Reader& reader, const Json& json, Layer& layer) {
  const auto exercises = json.find("exercises");
  bool good = exercises != json.end() && exercises->is_object() && !exercises->empty();
  if (good)
    for (const auto& [name, weight] : exercises->items()) good = good && weight.is_number() && weight.get<double>() > 0;
  if (!good) return reader.refuse("exercises must be an object of drills and their weights above 0");
  for (const auto& [name, weight] : exercises->items()) layer.exercises.emplace_back(name, weight.get<double>());
}

bool share_one(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return std::ranges::any_of(a, [&](const std::string& one) { return std::ranges::find(b, one) != b.end(); });
}

void add_all(const std::vector<std::string>& from, std::vector<std::string>& to) {
  for (const std::string& one : from)
    if (std::ranges::find(to, one) == to.end()) to.push_back(one);
}

}  // namespace

bool Layer::has(const Knob& knob) const { return share_one(knob.skills, skills) || share_one(knob.features, features); }

Result<Layer> parse_layer(std::string_view text, const std::string& called, const std::string& name) {
  const Result<Json> json = io::parse_object(text, called);
  if (!json) return json.failure();
  Reader reader(called);
  reader.refuse_unknown(*json, "", {"about", "skills", "leaves", "features", "conditions", "actions", "exercises"});
  Layer layer{.name = name,
              .about = reader.text(*json, "", "about"),
              .skills = {},
              .leaves = {},
              .features = {},
              .conditions = {},
              .actions = {},
              .exercises = {}};
  layer.skills = names_in(reader, *json, "skills", io::skill_named);
  layer.leaves = json->contains("leaves") ? names_in(reader, *json, "leaves", io::skill_named) : layer.skills;
  layer.features = names_in(reader, *json, "features", io::feature_named);
  layer.conditions = names_in(reader, *json, "conditions", io::feature_named);
  read_actions(reader, *json, layer);
  read_exercises(reader, *json, layer);
  if (!reader.good()) return reader.error();
  return layer;
}

Result<Layer> load_layer(const std::string& name) {
  const Result<io::Source> source = io::find_source("layers", "layer", name);
  if (!source) return source.failure();
  return parse_layer(source->text, source->called, std::filesystem::path(name).stem().string());
}

Layer seam_of(const Layer& lower, const Layer& upper) {
  Layer seam = upper;
  seam.name = lower.name + " and " + upper.name;
  seam.about = "the numbers of both layers together";
  add_all(lower.skills, seam.skills);
  add_all(lower.features, seam.features);
  for (const auto& exercise : lower.exercises)
    if (std::ranges::find(seam.exercises, exercise.first, &std::pair<std::string, double>::first) ==
        seam.exercises.end())
      seam.exercises.push_back(exercise);
  seam.actions.clear();
  seam.conditions.clear();
  return seam;
}

}  // namespace sim::learn
