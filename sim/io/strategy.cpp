#include "sim/io/strategy.h"

#include "robot/core/json_library.h"
#include "sim/io/marks.h"
#include "sim/io/reader.h"
#include "sim/io/source.h"
#include "sim/io/strategy_tree.h"
#include "sim/io/variation.h"
#include "sim/io/words.h"
#include "sim/motion/motion.h"

namespace sim::io {

using robot::Error;
using robot::Result;

namespace {

constexpr int kMostBases = 8;  // files in a chain of "based_on"
constexpr std::size_t kLongestName = 60;
constexpr const char* kMerged[] = {"parameters", "roles", "habits", "formation", "subtrees"};

/// Reads the places of players 1..: pairs of shares.
void read_places(Reader& reader, const Json& formation, const char* key, Vec2 (&places)[kMaxPlayers]) {
  const auto list = formation.find(key);
  if (list == formation.end()) return;
  const std::string path = "formation." + std::string(key);
  if (!list->is_array() || list->size() > kMaxPlayers)
    return reader.refuse(path + " must be a list of at most " + std::to_string(kMaxPlayers) + " places, got " +
                         shown(*list));
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Json& place = (*list)[i];
    const bool pair = place.is_array() && place.size() == 2 && place[0].is_number() && place[1].is_number();
    const double x = pair ? place[0].get<double>() : 1, y = pair ? place[1].get<double>() : 0;
    if (!(x >= -1 && x <= 0 && y >= -1 && y <= 1))
      return reader.refuse(path + "[" + std::to_string(i) + "] must be [-1 .. 0, -1 .. 1], got " + shown(place));
    places[i] = {static_cast<float>(x), static_cast<float>(y)};
  }
}

/// Merges `json` over `base`, section by section.
Json merged(Json base, const Json& json) {
  for (const auto& [key, value] : json.items()) {
    const bool section = std::find(std::begin(kMerged), std::end(kMerged), key) != std::end(kMerged);
    if (section && base.contains(key) && base[key].is_object() && value.is_object())
      base[key].update(value);
    else
      base[key] = value;
  }
  return base;
}

/// The part of a description that decides.
enum class Part { tree, menu };

/// The description with its bases (`whole`), and the part in its own file (`own`).
Result<agent::Tree> compiled(const Json& marked_whole, const Json& marked_own, const std::string& called,
                             Part part = Part::tree) {
  const Result<Json> cleaned = without_marks(marked_whole), cleaned_own = without_marks(marked_own);
  for (const Result<Json>* each : {&cleaned_own, &cleaned})
    if (!*each) return each->failure(called);
  const Json &whole = *cleaned, &own = *cleaned_own;
  Reader reader(called);
  agent::Tree tree;
  const char* const decides = part == Part::tree ? "tree" : "menu";
  reader.refuse_unknown(
      own, "", {"name", "about", "based_on", "parameters", "roles", "habits", "formation", decides, "subtrees"});
  tree.name = reader.text(own, "", "name");
  if (tree.name.empty() || tree.name.size() > kLongestName)
    reader.refuse("name must have 1 .. " + std::to_string(kLongestName) + " bytes");
  tree.about = reader.text(own, "", "about");
  for (const char* key : kMerged)
    if (const auto section = whole.find(key); section != whole.end()) reader.is_object(*section, key);
  if (!reader.good()) return reader.error();

  if (whole.contains("roles")) reader.read(whole["roles"], "roles", Fields::some, tree.settings.roles);
  if (whole.contains("habits")) reader.read(whole["habits"], "habits", Fields::some, tree.settings.habits);
  if (whole.contains("formation")) {
    reader.refuse_unknown(whole["formation"], "formation", {"ours", "theirs"});
    read_places(reader, whole["formation"], "ours", tree.settings.formation.ours);
    read_places(reader, whole["formation"], "theirs", tree.settings.formation.theirs);
  }
  if (!reader.good()) return reader.error();
  const auto compile = part == Part::tree ? &compile_tree : &compile_menu;
  if (const std::string problem = compile(whole, own, tree); !problem.empty()) return Error{called + ": " + problem};
  return tree;
}

/// Reads the description with all its bases. An error in a base names the file of that base.
Result<Json> whole_of(const Json& own, const std::string& called, int bases) {
  const auto based_on = own.find("based_on");
  if (based_on == own.end()) return own;
  if (!based_on->is_string()) return Error{called + ": based_on must be a text, got " + shown(*based_on)};
  if (bases == kMostBases)
    return Error{called + ": based_on leads through more than 8 files, or back to the same file"};
  const Result<Source> source = find_source("strategies", "strategy", based_on->get<std::string>());
  if (!source) return source.failure(called + ": based_on");
  const Result<Json> json = parse_object(source->text, source->called);
  if (!json) return json.failure();
  const Result<Json> base = whole_of(*json, source->called, bases + 1);
  if (!base) return base.failure();
  if (const Result<agent::Tree> checked = compiled(*base, *json, source->called); !checked) return checked.failure();
  return merged(*base, own);
}

/// A description, and the same with all its bases.
struct Described {
  Json own, whole;
};

/// Reads a description. `parameters` replace its own ones.
Result<Described> described(std::string_view text, const std::string& called, const Json& parameters) {
  if (text.size() > kMaxFileBytes)
    return Error{called + ": must have at most " + std::to_string(kMaxFileBytes) + " bytes, got " +
                 std::to_string(text.size())};
  Result<Json> own = parse_object(text, called);
  if (!own) return own.failure();
  // a changed parameter must exist; otherwise a typing mistake would pass
  if (!parameters.empty()) own = merged(std::move(*own), Json{{"parameters", parameters}});
  Result<Json> whole = whole_of(*own, called, 0);
  if (!whole) return whole.failure();
  return Described{*std::move(own), *std::move(whole)};
}

Result<agent::Tree> parse_upon(std::string_view text, const std::string& called, const Json& parameters) {
  const Result<Described> strategy = described(text, called, parameters);
  if (!strategy) return strategy.failure();
  return compiled(strategy->whole, strategy->own, called);
}

}  // namespace

Result<agent::Tree> parse_strategy(std::string_view text, const std::string& called) {
  return parse_upon(text, called, Json::object());
}

Result<agent::Tree> parse_menu(const Json& strategy, const std::string& called) {
  const Result<Json> whole = whole_of(strategy, called, 0);
  if (!whole) return whole.failure();
  return compiled(*whole, strategy, called, Part::menu);
}

Result<Json> flattened(std::string_view text, const std::string& called) {
  Result<Described> strategy = described(text, called, Json::object());
  if (!strategy) return strategy.failure();
  if (const Result<agent::Tree> checked = compiled(strategy->whole, strategy->own, called); !checked)
    return checked.failure();
  strategy->whole.erase("based_on");
  return std::move(strategy->whole);
}

Result<std::unique_ptr<agent::TreeBehaviour>> load_strategy(const std::string& name) {
  const std::string called = "strategy '" + name + "'";
  const Result<Variation> variation = parse_variation(name, called);
  if (!variation) return variation.failure();
  if (!variation->number.is_null()) return Error{called + ": strategies take no number behind a colon"};
  const Result<Source> source = find_source("strategies", "strategy", variation->name);
  if (!source) return source.failure();
  Result<agent::Tree> tree = parse_upon(source->text, called, variation->changes);
  if (!tree) return tree.failure();
  tree->name += name.substr(variation->name.size());
  return std::make_unique<agent::TreeBehaviour>(std::move(*tree));
}

Result<void> check_kicks(const agent::Tree& tree, const Team& team) {
  for (int player = 1; player <= kMaxPlayers; ++player) {
    const Models& models = team.models_of(player);
    std::vector<std::string_view> known;
    for (int i = 0; i < models.motion.kick_count; ++i) known.emplace_back(models.motion.kicks[i].name);
    for (int i = 0; i < tree.settings.kicks.count; ++i) {
      const std::string name = tree.settings.kicks.names[i];
      if (motion::find_kick(models.motion, name) < 0)
        return Error{"strategy '" + tree.name + "': models '" + models.name + "' have no kick " + shown(name) +
                     hint(name, known)};
    }
  }
  return {};
}

}  // namespace sim::io
