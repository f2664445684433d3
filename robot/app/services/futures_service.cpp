#include "robot/app/services/futures_service.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "robot/app/asked_moment.h"
#include "robot/app/known_game.h"
#include "robot/app/recalled_decision.h"
#include "robot/app/replayed_game.h"
#include "robot/bridge/player_map.h"
#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/check/event.h"
#include "sim/debug/argument_change.h"
#include "sim/debug/command_words.h"
#include "sim/debug/session.h"
#include "sim/foresight/situation.h"
#include "sim/io/source.h"
#include "sim/report/futures_report.h"

namespace robot::app {
namespace {

using nlohmann::json;
using sim::debug::Pair;

constexpr const char* kFutures = "/decision/futures";
constexpr const char* kEdit = "/sim/edit";
constexpr float kLongestFuture = 120;  // [s]

/// The moment at which all futures begin.
struct Start {
  std::string from;  // "game" or "beliefs"
  sim::debug::SharedSetup setup;
  sim::io::SituationTeams teams;
  std::optional<bridge::PlayerMaps> lineups;  // absent: each robot has the number of its place
  int robot = 0;                              // index of the asked robot
  std::function<sim::State(int)> state;       // of a pair, by its number; the first is the most likely

  int players() const { return setup->params.rules.players; }

  /// Returns the index of the robot with that name, or kNobody.
  int index_of(const std::string& name) const {
    const std::size_t bar = name.find('/');
    if (bar == std::string::npos) return sim::kNobody;
    const auto team = sim::debug::number_in<int>(name.substr(0, bar));
    const auto player = sim::debug::number_in<std::uint32_t>(name.substr(bar + 1));
    if (!lineups || !team || !player) return sim::check::robot_named(name, players(), teams);
    const sim::Side side = *team == teams.home ? sim::Side::home : sim::Side::away;
    const int place = *team == teams.of(side) ? lineups->of(side).place_of(*player) : 0;
    return place == 0 ? int{sim::kNobody} : sim::robot_of(side, place);
  }
  std::string name_of(int index) const {
    const sim::Side side = sim::side_of(index);
    const int place = sim::player_of(index);
    const int number = lineups ? static_cast<int>(lineups->of(side).player_at(place)) : place;
    return std::to_string(teams.of(side)) + "/" + std::to_string(number);
  }
};

/// Returns the name that the debugger gives a robot, whatever the numbers of teams and jerseys are.
std::string place_name(int robot) {
  return (sim::side_of(robot) == sim::Side::home ? "home/" : "away/") + std::to_string(sim::player_of(robot));
}

Result<std::vector<std::string>> edits_in(const json& request) {
  std::vector<std::string> lines;
  const auto found = request.find("edits");
  if (found == request.end()) return lines;
  const Error wrong{"'edits' must be a list of at most " + std::to_string(kMostEdits) + " texts"};
  if (!found->is_array() || found->size() > static_cast<std::size_t>(kMostEdits)) return wrong;
  for (const json& line : *found) {
    if (!line.is_string()) return wrong;
    lines.push_back(line.get<std::string>());
  }
  return lines;
}

/// Returns the whole number at `key`, or `otherwise` if it is not there.
Result<std::int64_t> whole_in(const json& request, const char* key, std::int64_t otherwise, std::int64_t least,
                              std::int64_t most) {
  const auto found = request.find(key);
  if (found == request.end()) return otherwise;
  const auto number = whole_number(*found);
  if (number && *number >= least && *number <= most) return *number;
  return Error{std::string("'") + key + "' must be a whole number " + std::to_string(least) + " .. " +
               std::to_string(most) + ", got " + printable(found->dump(), 40)};
}

/// The length of the comparison.
struct Extent {
  int pairs = 0;
  float seconds = 0;
};
Result<Extent> extent_in(const json& request) {
  const auto pairs = whole_in(request, "pairs", 200, 0, kMostPairs);
  if (!pairs) return pairs.failure();
  if (*pairs == 1) return Error{"'pairs' must be 2 or more, or 0 for no futures, got 1"};
  const auto found = request.find("seconds");
  const float seconds = found == request.end() ? 30.f : found->is_number() ? found->get<float>() : 0.f;
  if (!(seconds >= 1 && seconds <= kLongestFuture)) return Error{"'seconds' must be a number 1 .. 120"};
  if (static_cast<float>(*pairs) * seconds > kMostPlayed)
    return Error{"'pairs' times 'seconds' must be at most " + std::to_string(kMostPlayed)};
  return Extent{.pairs = static_cast<int>(*pairs), .seconds = seconds};
}

json places_json(const Start& start, const sim::World& world) {
  json robots = json::array();
  sim::for_each_robot(world.players, [&](int robot) {
    const sim::Body& body = world.bodies[robot];
    if (body.doing == sim::Body::Doing::removed) return;
    robots.push_back({{"name", start.name_of(robot)},
                      {"side", sim::side_of(robot) == sim::Side::home ? "home" : "away"},
                      {"x", body.position.x},
                      {"y", body.position.y},
                      {"heading", body.heading}});
  });
  return {{"ball", {{"x", world.ball.position.x}, {"y", world.ball.position.y}}}, {"robots", std::move(robots)}};
}

json leaves_json(const sim::agent::Tree& tree) {
  json all = json::array();
  for (std::size_t leaf = 0; leaf < tree.leaves.size(); ++leaf) {
    json arguments = json::array();
    for (const auto& [name, value] : sim::debug::arguments_of(tree, leaf))
      arguments.push_back({{"name", name}, {"value", value}});
    all.push_back({{"path", tree.leaf_words[leaf].path}, {"arguments", std::move(arguments)}});
  }
  return all;
}

/// Answers the questions. Used by the thread that serves questions.
class Futures {
 public:
  Futures(const memory::Channels& channels, const FuturesOptions& options)
      : channels_(channels), options_(options), game_(channels, options.rules), trees_(options.strategies) {}

  Result<json> futures(const json& request) {
    const auto edits = edits_in(request);
    if (!edits) return edits.failure();
    const auto extent = extent_in(request);
    if (!extent) return extent.failure();
    const auto start = options_.game && !request.contains("objects") ? game_start(request) : recalled_start(request);
    if (!start) return start.failure();

    auto first = changed(*start, *edits, 0);
    if (!first) return first.failure();
    const sim::debug::Moment &without = first->without, &with = first->with;
    json answer = {{"ok", true},
                   {"from", start->from},
                   {"tick", start->from == "game" ? json(without.state.world.tick) : json()},
                   {"robot", start->name_of(start->robot)},
                   {"side", sim::side_of(start->robot) == sim::Side::home ? "home" : "away"},
                   {"attacks", sim::attack_sign(without.state.world, sim::side_of(start->robot)) > 0 ? 1 : -1},
                   {"before", places_json(*start, without.state.world)},
                   {"after", places_json(*start, with.state.world)},
                   {"strategies", strategies()},
                   {"leaves", leaves_json(sim::debug::tree_of(with.setup->params, start->robot)->tree())},
                   {"futures", nullptr}};
    if (extent->pairs == 0) return answer;
    std::vector<Pair> pairs{*std::move(first)};
    for (int number = 1; number < extent->pairs; ++number) {
      if (start->from == "game") {  // all pairs begin with the same moment
        pairs.push_back(pairs.front());
        continue;
      }
      auto pair = changed(*start, *edits, number);
      if (!pair) return pair.failure();
      pairs.push_back(*std::move(pair));
    }
    const sim::Tick length = sim::ticks(extent->seconds);
    answer["futures"] = sim::report::to_json(sim::debug::futures(pairs, start->robot, length), length);
    return answer;
  }

  Result<json> edit(const json& request) {
    const auto edits = edits_in(request);
    if (!edits) return edits.failure();
    for (const std::string& line : *edits) {
      const auto words = sim::debug::words_of(line);
      const bool is_of_tree = words.size() > 1 && (words[1] == "threshold" || words[1] == "argument");
      if (is_of_tree || (!words.empty() && words[0] == "strategy"))
        return Error{"'" + printable(line, 100) + "': a running game keeps its trees; their futures can be compared"};
    }
    if (!request.contains("tick")) return Error{"'tick' must be the present tick of the game"};
    const auto start = game_start(request);
    if (!start) return start.failure();
    const auto pair = changed(*start, *edits, 0);
    if (!pair) return pair.failure();
    if (auto edited = options_.game->edit(pair->with.state); !edited) return edited.failure();
    return json{{"ok", true}};
  }

 private:
  std::vector<std::string> strategies() const {
    std::vector<std::string> all;
    const auto add = [&](std::string_view name) {
      if (std::ranges::find(all, name) == all.end()) all.emplace_back(name);
    };
    for (const std::string& name : options_.strategies) add(name);
    for (const std::string_view name : sim::io::names_of("strategies")) add(name);
    return all;
  }

  /// Returns the moment of the game that this process plays.
  Result<Start> game_start(const json& request) const {
    const auto robot = text_in(request, "robot");
    if (!robot) return robot.failure();
    constexpr std::int64_t now = -1;
    const auto seed = whole_in(request, "seed", now, 0, body::SimBody::kGreatestSeed);
    if (!seed) return seed.failure();
    const auto tick = whole_in(request, "tick", now, 0, sim::kNever - 1);
    if (!tick) return tick.failure();
    const auto state =
        options_.game->state_at(*seed == now ? std::nullopt : std::optional(static_cast<std::uint64_t>(*seed)),
                                *tick == now ? std::nullopt : std::optional(static_cast<sim::Tick>(*tick)));
    if (!state) return state.failure();
    const body::GameSetup& played = options_.game->setup();
    auto setup = sim::debug::rest_of_game(played.game, *state);
    if (!setup) return setup.failure();
    return begun({.setup = *std::move(setup),
                  .state = *state,
                  .teams = {.home = static_cast<int>(played.names.teams.home),
                            .away = static_cast<int>(played.names.teams.away)}},
                 *robot);
  }

  /// Returns the moment of a recorded game that can be played again, or else the one in which the robot believed.
  Result<Start> recalled_start(const json& request) {
    const auto moment = asked_moment(channels_, request);
    if (!moment) return moment.failure();
    if (moment->simulation && moment->truth)
      if (auto played = replayed_.at(*moment->simulation, *moment->truth, trees_))
        return begun(*std::move(played), moment->robot);
    return believed_start(*moment);
  }

  /// Returns the start at a moment of a whole game.
  static Result<Start> begun(ReplayedGame::Moment moment, const std::string& robot) {
    Start start{.from = "game",
                .setup = std::move(moment.setup),
                .teams = moment.teams,
                .lineups = {},
                .robot = 0,
                .state = [state = moment.state](int) { return state; }};
    start.robot = start.index_of(robot);
    if (start.robot == sim::kNobody)
      return Error{"expected " + sim::check::robot_names(start.players(), start.teams) + ", got '" +
                   printable(robot, 40) + "'"};
    return start;
  }

  /// Returns the moment in which the robot believed.
  Result<Start> believed_start(const AskedMoment& moment) {
    const std::string name = "robot " + printable(moment.robot, 40);
    if (!moment.objects.decision) return Error{name + " has not decided anything"};
    auto game = game_.of(moment.robot);
    if (!game) return game.failure();
    const auto tree = trees_.named(moment.objects.decision->value.strategy());
    if (!tree) return tree.failure(name);
    game->behaviours[0] = *tree;
    game->params.teams[0].behaviour = tree->get();
    const auto knowledge = bridge::knowledge_of(moment.objects, game->params);
    if (!knowledge) return knowledge.failure(name);
    const sim::foresight::Believed believed = sim::foresight::believe(game->params, *knowledge);
    if (!believed.refusal.empty()) return Error{name + ": " + believed.refusal};
    auto setup = sim::debug::rest_of_game(*game, believed.situation.state);
    if (!setup) return setup.failure();
    const foresight::GameState& told = moment.objects.game->value;
    return Start{
        .from = "beliefs",
        .setup = *setup,
        .teams = {.home = static_cast<int>(told.own_team()), .away = static_cast<int>(told.opponent().number())},
        .lineups = bridge::PlayerMaps(told, game->params.rules.players),
        .robot = sim::robot_of(sim::Side::home, knowledge->game.player),
        .state = [setup = *setup, situation = believed.situation](int number) {
          if (number == 0) return situation.state;
          return sim::foresight::sample(setup->params, situation, {static_cast<std::uint64_t>(number)});
        }};
  }

  /// Returns the moment of a pair, without and with the edits.
  Result<Pair> changed(const Start& start, const std::vector<std::string>& edits, int number) const {
    const sim::State state = start.state(number);
    sim::debug::Session session(start.setup, state, {});
    if (auto focused = session.run("robot " + place_name(start.robot)); !focused) return focused.failure();
    for (const std::string& line : edits)
      if (const auto done = run(start, session, line); !done)
        return Error{"'" + printable(line, 100) + "': " + done.error()};
    auto pair = session.edited();
    if (!pair) return Pair{.without = {start.setup, state}, .with = {start.setup, state}};
    return *std::move(pair);
  }

  /// Runs a line if it is an edit that clients may make: a file is not for them.
  Result<void> run(const Start& start, sim::debug::Session& session, const std::string& line) const {
    const auto words = sim::debug::words_of(line);
    if (words.empty() || (words[0] != "set" && words[0] != "strategy"))
      return Error{"expected an edit: 'set …' or 'strategy NAME'"};
    if (words[0] == "strategy" && words.size() == 2) {
      const std::vector<std::string> known = strategies();
      const std::string name = words[1].substr(0, words[1].find(','));
      if (std::ranges::find(known, words[1]) == known.end() &&
          (sim::io::is_path(name) || std::ranges::find(known, name) == known.end()))
        return sim::io::unknown_name("strategy", printable(name, 100), {known.begin(), known.end()});
    }
    std::string told;
    for (const std::string& word : words) {
      const int robot = start.index_of(word);
      told += (told.empty() ? "" : " ") + (robot == sim::kNobody ? word : place_name(robot));
    }
    const auto done = session.run(told);
    if (!done) return done.failure();
    return {};
  }

  const memory::Channels& channels_;
  const FuturesOptions options_;
  KnownGame game_;
  KnownTrees trees_;
  ReplayedGame replayed_;
};

}  // namespace

void add_futures_service(net::Services& services, const memory::Channels& channels, const FuturesOptions& options) {
  const auto futures = std::make_shared<Futures>(channels, options);
  const auto add = [&](const char* name, net::Services::For whom, Result<json> (Futures::*ask)(const json&)) {
    services.add(name, whom, [futures, name, ask](const json& request, const net::ClientContext&) {
      auto answer = ((*futures).*ask)(request);
      return answer ? *std::move(answer) : net::failure(std::string(name) + ": " + answer.error());
    });
  };
  add(kFutures, net::Services::For::questions, &Futures::futures);
  if (options.game) add(kEdit, net::Services::For::control, &Futures::edit);
}

}  // namespace robot::app
