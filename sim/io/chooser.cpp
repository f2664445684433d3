#include "sim/io/chooser.h"

#include <algorithm>

#include "sim/foresight/chooser.h"
#include "sim/io/models.h"
#include "sim/io/playbook.h"
#include "sim/io/policy.h"
#include "sim/io/reader.h"
#include "sim/io/source.h"
#include "sim/io/strategy.h"
#include "sim/io/variation.h"

namespace sim::io {

using robot::Result;

namespace {

struct Description {
  std::string name;
  std::vector<std::string> strategies;
  std::string opponent = "baseline";
  std::string opponent_models;  // empty: the true ones
  foresight::Terms terms;
};

Result<Description> parse(std::string_view text, const std::string& called, const Json& changes) {
  Result<Json> json = parse_object(text, called);
  if (!json) return json.failure();
  json->update(changes);
  Reader reader(called);
  Description description;
  reader.read(*json, "", Fields::some, description.terms, {"name", "about", "choose", "opponent", "opponent_models"});
  description.name = reader.text(*json, "", "name", description.name);
  reader.text(*json, "", "about");  // only for people
  description.opponent = reader.text(*json, "", "opponent", description.opponent);
  description.opponent_models = reader.text(*json, "", "opponent_models", description.opponent_models);
  const Json& from = (*json)["choose"];
  const bool names = from.is_array() && std::ranges::all_of(from, [](const Json& name) { return name.is_string(); });
  if (!names || from.size() < 2)
    reader.refuse("choose must be a list of 2 .. 8 strategies, got " + shown(from));
  else
    for (const Json& name : from) description.strategies.push_back(name.get<std::string>());
  if (!reader.good()) return reader.error();
  return description;
}

bool is_embedded(std::string_view kind, const std::string& name) {
  const auto names = names_of(kind);
  return std::ranges::find(names, name) != names.end();
}

/// The form of a description of a behaviour.
enum class Form { tree, chooser, policy };

struct Found {
  Form form = Form::tree;
  std::string text;  // empty for a tree
};

/// Finds the description that is no decision tree.
Result<Found> find_form(const std::string& name, const std::string& called) {
  if (is_embedded("playbooks", name)) return Found{Form::chooser, find_source("playbooks", "playbook", name)->text};
  if (!is_path(name)) return Found{};
  const Result<Source> source = find_source("strategies", "strategy", name);
  if (!source) return source.failure();
  const Result<Json> json = parse_object(source->text, called);
  if (!json) return json.failure();
  if (json->contains("choose")) return Found{Form::chooser, source->text};
  if (json->contains("menu")) return Found{Form::policy, source->text};
  return Found{};
}

/// Returns an Error if the tree names a kick that a robot of the side lacks.
Result<void> check_team(const agent::Tree& tree, const Matchup& game, Side side) {
  if (tree.settings.kicks.count == 0) return {};
  Team team;
  const std::string& models = game.models[static_cast<std::size_t>(side)];
  if (auto loaded = load_team_models(models, kMaxPlayers, team); !loaded) return loaded.failure();
  return check_kicks(tree, team);
}

}  // namespace

Result<std::shared_ptr<const agent::Behaviour>> load_behaviour(const std::string& name, const Matchup& game,
                                                               Side side) {
  using Behaviour = std::shared_ptr<const agent::Behaviour>;
  const std::string called = "strategy '" + name + "'";
  const Result<Variation> variation = parse_variation(name, called);
  if (!variation) return variation.failure();
  const Result<Found> found = find_form(variation->name, called);
  if (!found) return found.failure();
  if (found->form == Form::policy) {
    if (name != variation->name) return robot::Error{called + ": a learned policy takes no changes behind its name"};
    auto policy = parse_policy(found->text, called);
    if (!policy) return policy.failure();
    if (auto checked = check_team(policy->frame().tree, game, side); !checked) return checked.failure();
    return Behaviour(std::make_shared<agent::PolicyBehaviour>(*std::move(policy)));
  }
  if (found->form == Form::tree) {
    if (!is_path(variation->name) && !is_embedded("strategies", variation->name)) {
      std::vector<std::string_view> known = names_of("strategies");
      for (const std::string_view playbook : names_of("playbooks")) known.push_back(playbook);
      return unknown_name("strategy", variation->name, known);
    }
    auto tree = load_strategy(name);
    if (!tree) return tree.failure();
    if (auto checked = check_team((*tree)->tree(), game, side); !checked) return checked.failure();
    return Behaviour(std::move(*tree));
  }

  Result<Description> description = parse(found->text, called, variation->changes);
  if (!description) return description.failure();
  const auto own = static_cast<std::size_t>(side), others = 1 - own;
  auto playbook = prepare_playbook(
      {.strategies = description->strategies,
       .opponent = description->opponent,
       .rules = game.rules,
       .models = game.models[own],
       .opponent_models = description->opponent_models.empty() ? game.models[others] : description->opponent_models,
       .players = game.players,
       .pace = game.pace});
  if (!playbook) return playbook.failure(called);
  return Behaviour(std::make_shared<foresight::Chooser>(
      description->name + name.substr(variation->name.size()),
      foresight::Plans{std::move(playbook->params), playbook->outlook, std::move(playbook->behaviours)},
      description->terms));
}

}  // namespace sim::io
