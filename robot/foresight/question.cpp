#include "robot/foresight/question.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string_view>

#include "sim/foresight/tally.h"
#include "sim/match/situation.h"
#include "sim/match/step.h"

namespace robot::foreseeing {
namespace {

using nlohmann::json;
using sim::Vec2;

// the enumerators of the messages are those of the simulator
using sim::foresight::kMeasureNames;
using sim::foresight::kUntilNames;
constexpr std::array kAdvice = {"none", "keep", "change"};

constexpr float kDefaultHorizon = 30, kLongestHorizon = 1200;  // [s]
constexpr std::uint32_t kDefaultBudgetMs = 500, kLeastBudgetMs = 10, kMostBudgetMs = 10'000;
constexpr float kDefaultCost = 0.02f;
constexpr const char* kBaseline = "baseline";
constexpr std::size_t kMostName = 200;

std::string shown(const json& value) {
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 60) + "…";
  return text;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// Reads members of a JSON object into a message, and keeps the first thing that is wrong.
class Reader {
 public:
  bool good() const { return problem_.empty(); }
  Error error() const { return Error{problem_}; }
  void refuse(std::string problem) {
    if (good()) problem_ = std::move(problem);
  }

  bool is_object(const json& value, const std::string& path, std::initializer_list<std::string_view> keys) {
    if (!value.is_object()) {
      refuse((path.empty() ? "a question" : "'" + path + "'") + " must be an object, got " + shown(value));
      return false;
    }
    for (const auto& item : value.items())
      if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
        refuse("'" + below(path, item.key().substr(0, 40)) + "' is nothing that a question has");
    return good();
  }

  /// Calls set(number) if there is one. Ranges are checked by who knows them.
  template <class Set>
  void read_number(const json& object, const std::string& path, const char* key, Set&& set) {
    const auto found = object.find(key);
    if (found == object.end()) return;
    if (!found->is_number() || !std::isfinite(found->get<double>()))
      return refuse("'" + below(path, key) + "' must be a number, got " + shown(*found));
    set(found->get<double>());
  }

  template <class Set>
  void read_count(const json& object, const std::string& path, const char* key, Set&& set) {
    const auto found = object.find(key);
    if (found == object.end()) return;
    if (!found->is_number_unsigned() || found->get<std::uint64_t>() > 1'000'000'000)
      return refuse("'" + below(path, key) + "' must be a whole number 0 .. 1000000000, got " + shown(*found));
    set(found->get<std::uint32_t>());
  }

  template <class Set>
  void read_text(const json& object, const char* key, Set&& set) {
    const auto found = object.find(key);
    if (found == object.end()) return;
    if (!found->is_string()) return refuse("'" + std::string(key) + "' must be a text, got " + shown(*found));
    set(found->get<std::string>());
  }

  template <std::size_t Count, class Set>
  void read_name(const json& object, const char* key, const std::array<const char*, Count>& names, Set&& set) {
    const auto found = object.find(key);
    if (found == object.end()) return;
    std::string all;
    for (std::size_t i = 0; i < Count; ++i) {
      if (*found == names[i]) return set(static_cast<int>(i));
      all += (i == 0 ? "" : ", ") + std::string(names[i]);
    }
    refuse("'" + std::string(key) + "' must be one of " + all + ", got " + shown(*found));
  }

  static std::string below(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : path + "." + std::string(key);
  }

 private:
  std::string problem_;
};

void read_place(Reader& reader, const json& object, const std::string& path, auto& place) {
  for (const char* key : {"x", "y"})
    if (!object.contains(key)) reader.refuse("'" + Reader::below(path, key) + "' is missing");
  reader.read_number(object, path, "x", [&](double x) { place.set_x(static_cast<float>(x)); });
  reader.read_number(object, path, "y", [&](double y) { place.set_y(static_cast<float>(y)); });
}

void read_moved(Reader& reader, const json& object, const std::string& path, pb::WhatIf::MovedRobot& robot) {
  if (!reader.is_object(object, path, {"side", "player", "x", "y", "heading"})) return;
  const auto side = object.find("side");
  if (side == object.end() || (*side != "own" && *side != "opponent"))
    reader.refuse("'" + path + ".side' must be own or opponent, got " +
                  (side == object.end() ? "nothing" : shown(*side)));
  else
    robot.set_opponent(*side == "opponent");
  if (!object.contains("player")) reader.refuse("'" + path + ".player' is missing");
  reader.read_count(object, path, "player", [&](std::uint32_t player) { robot.set_player(player); });
  read_place(reader, object, path, robot);
  reader.read_number(object, path, "heading", [&](double heading) { robot.set_heading(static_cast<float>(heading)); });
}

void read_edit(Reader& reader, const json& object, pb::WhatIf::Edit& edit) {
  if (!reader.is_object(object, "edit", {"ball", "robots", "own_score", "opponent_score", "seconds_remaining"})) return;
  if (const auto ball = object.find("ball"); ball != object.end() && reader.is_object(*ball, "edit.ball", {"x", "y"}))
    read_place(reader, *ball, "edit.ball", *edit.mutable_ball());
  if (const auto robots = object.find("robots"); robots != object.end()) {
    if (!robots->is_array() || robots->size() > sim::kMaxRobots)
      return reader.refuse("'edit.robots' must be a list of at most " + std::to_string(sim::kMaxRobots) + ", got " +
                           shown(*robots));
    for (std::size_t i = 0; i < robots->size(); ++i)
      read_moved(reader, (*robots)[i], "edit.robots[" + std::to_string(i) + "]", *edit.add_robots());
  }
  reader.read_count(object, "edit", "own_score", [&](std::uint32_t score) { edit.set_own_score(score); });
  reader.read_count(object, "edit", "opponent_score", [&](std::uint32_t score) { edit.set_opponent_score(score); });
  reader.read_number(object, "edit", "seconds_remaining",
                     [&](double seconds) { edit.set_seconds_remaining(static_cast<float>(seconds)); });
}

json points(const google::protobuf::RepeatedField<float>& from) {
  json list = json::array();
  for (const float value : from) list.push_back(value);
  return list;
}

json to_json(const pb::Forecast::StrategyForecast& strategy, bool in_full) {
  json told = {
      {"strategy", strategy.strategy()}, {"rollouts", strategy.rollouts()}, {"mean", strategy.mean()},
      {"error", strategy.error()},       {"score", strategy.score()},       {"concede", strategy.concede()},
      {"gain", strategy.gain()},         {"gain_low", strategy.gain_low()}, {"gain_high", strategy.gain_high()},
      {"best", strategy.best()},         {"raced_on", strategy.raced_on()}};
  if (!in_full) return told;
  told["heat_columns"] = strategy.heat_columns();
  told["heat"] = json::array();
  for (const std::uint32_t count : strategy.heat()) told["heat"].push_back(count);
  told["paths"] = json::array();
  for (const pb::Forecast::Path& path : strategy.paths()) {
    json robots = json::array();
    for (const pb::Forecast::RobotPath& robot : path.robots())
      robots.push_back({{"player", robot.player()}, {"points", points(robot.points())}});
    told["paths"].push_back(
        {{"spacing", path.spacing()}, {"ball", points(path.ball())}, {"robots", std::move(robots)}});
  }
  return told;
}

json to_json(const pb::Forecast::Situation& situation) {
  json bodies = json::array();
  for (const pb::Forecast::Situation::Body& body : situation.bodies())
    bodies.push_back({{"side", body.opponent() ? "opponent" : "own"},
                      {"player", body.player()},
                      {"x", body.x()},
                      {"y", body.y()},
                      {"heading", body.heading()},
                      {"deviation", body.deviation()}});
  return {{"ball",
           {{"x", situation.ball_x()},
            {"y", situation.ball_y()},
            {"deviation", situation.ball_deviation()},
            {"elsewhere", situation.ball_elsewhere()}}},
          {"robots", std::move(bodies)},
          {"own_score", situation.own_score()},
          {"opponent_score", situation.opponent_score()},
          {"seconds_remaining", situation.seconds_remaining()}};
}

bool is_within(float value, float least, float most) { return value >= least && value <= most; }

/// Of a place [m] that is refused later, where it is none on the field.
bool is_sane(float place) { return is_within(place, -100, 100); }

/// [0] .. [1] inclusive, where 0 stands for what is left out.
Result<void> check_names(const pb::WhatIf& question, const std::vector<std::string>& known) {
  if (question.strategies_size() > sim::foresight::kMaxStrategies)
    return Error{"'strategies' must be 1 .. " + std::to_string(sim::foresight::kMaxStrategies) + ", got " +
                 std::to_string(question.strategies_size())};
  std::string all;
  for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
  const auto check = [&](const std::string& name) -> Result<void> {
    if (std::find(known.begin(), known.end(), name) != known.end()) return {};
    return Error{"no strategy " + shown(name.substr(0, kMostName)) + "; there are: " + all};
  };
  for (int i = 0; i < question.strategies_size(); ++i) {
    const std::string& name = question.strategies(i);
    if (Result<void> checked = check(name); !checked) return checked;
    if (std::find(question.strategies().begin(), question.strategies().begin() + i, name) !=
        question.strategies().begin() + i)
      return Error{"'strategies' must differ, " + name + " is there twice"};
  }
  // there is always a baseline, whatever one's own team plays
  return question.opponent() == kBaseline ? Result<void>{} : check(question.opponent());
}

sim::Side side_of(const pb::WhatIf::MovedRobot& robot) { return robot.opponent() ? sim::Side::away : sim::Side::home; }

/// The body's index of a moved robot that plays, in a situation whose own side is home.
int index_of(const pb::WhatIf::MovedRobot& robot, const Lineups& lineups) {
  return sim::robot_of(side_of(robot), lineups.of(side_of(robot)).place_of(robot.player()));
}

std::string name_of(const pb::WhatIf::MovedRobot& robot) {
  return std::string(robot.opponent() ? "opponent player " : "own player ") + std::to_string(robot.player());
}

Result<void> check_place(const sim::field::Field& field, const std::string& who, Vec2 at, float room) {
  const std::string where = who + " at " + number(static_cast<double>(at.x)) + ", " + number(static_cast<double>(at.y));
  if (!std::isfinite(at.x) || !std::isfinite(at.y) || !sim::field::inside_field(field, at, room))
    return Error{where + " is not on the field"};
  for (int post = 0; post < 4; ++post)
    if (sim::distance(sim::field::post_of(field, post), at) < room + field.post_radius)
      return Error{where + " is in a goalpost"};
  return {};
}

/// Nobody stands in anybody, nor on the ball, as far as the edit has a say in it.
Result<void> check_apart(const pb::WhatIf::Edit& edit, const Lineups& lineups, const sim::ContactModel& contact,
                         const sim::World& world) {
  std::string problem;
  for (const pb::WhatIf::MovedRobot& moved : edit.robots()) {
    const int robot = index_of(moved, lineups);
    const Vec2 at = world.bodies[robot].position;
    sim::for_each_robot(world.players, [&](int other) {
      const sim::Body& body = world.bodies[other];
      if (other == robot || body.doing == sim::Body::Doing::removed) return;
      const bool moved_too = std::any_of(edit.robots().begin(), edit.robots().end(),
                                         [&](const auto& one) { return index_of(one, lineups) == other; });
      // who was not moved is only believed to be there
      if (moved_too && sim::distance(body.position, at) < 2 * contact.robot_radius)
        problem = name_of(moved) + " stands in another robot";
    });
    if (edit.has_ball() && sim::distance(world.ball.position, at) < contact.robot_radius)
      problem = name_of(moved) + " stands on the ball";
  }
  if (problem.empty()) return {};
  return Error{problem};
}

}  // namespace

Result<pb::WhatIf> parse_question(const json& asked) {
  Reader reader;
  pb::WhatIf question;
  if (!reader.is_object(
          asked, "", {"strategies", "opponent", "measure", "until", "horizon", "budget_ms", "switching_cost", "edit"}))
    return reader.error();
  if (const auto strategies = asked.find("strategies"); strategies != asked.end()) {
    if (!strategies->is_array() ||
        !std::all_of(strategies->begin(), strategies->end(), [](const json& name) { return name.is_string(); }) ||
        strategies->size() > 100)
      reader.refuse("'strategies' must be a list of names, got " + shown(*strategies));
    else
      for (const json& name : *strategies) question.add_strategies(name.get<std::string>());
  }
  reader.read_text(asked, "opponent", [&](std::string name) { question.set_opponent(std::move(name)); });
  reader.read_name(asked, "measure", kMeasureNames,
                   [&](int i) { question.set_measure(static_cast<pb::WhatIf::Measure>(i)); });
  reader.read_name(asked, "until", kUntilNames, [&](int i) { question.set_until(static_cast<pb::WhatIf::Until>(i)); });
  reader.read_number(asked, "", "horizon", [&](double seconds) { question.set_horizon(static_cast<float>(seconds)); });
  reader.read_count(asked, "", "budget_ms", [&](std::uint32_t budget) { question.set_budget_ms(budget); });
  reader.read_number(asked, "", "switching_cost",
                     [&](double cost) { question.set_switching_cost(static_cast<float>(cost)); });
  if (const auto edit = asked.find("edit"); edit != asked.end()) read_edit(reader, *edit, *question.mutable_edit());
  if (!reader.good()) return reader.error();
  return question;
}

json to_json(const pb::Forecast& forecast, bool in_full) {
  const pb::WhatIf& question = forecast.question();
  json strategies = json::array();
  for (const auto& strategy : forecast.strategies()) strategies.push_back(to_json(strategy, in_full));
  return {{"question",
           {{"strategies", std::vector<std::string>(question.strategies().begin(), question.strategies().end())},
            {"asked_by", question.asked_by()},
            {"opponent", question.opponent()},
            {"measure", kMeasureNames[static_cast<std::size_t>(question.measure())]},
            {"until", kUntilNames[static_cast<std::size_t>(question.until())]},
            {"horizon", question.horizon()},
            {"budget_ms", question.budget_ms()},
            {"switching_cost", question.switching_cost()}}},
          {"advice", kAdvice[static_cast<std::size_t>(forecast.advice())]},
          {"choice", forecast.choice()},
          {"reason", forecast.reason()},
          {"strategies", std::move(strategies)},
          {"asked_ns", std::to_string(forecast.asked_ns())},
          {"answered_ms", forecast.answered_ms()},
          {"computed_ms", forecast.computed_ms()},
          {"simulated", forecast.simulated()},
          {"models", forecast.models()},
          {"situation", to_json(forecast.situation())}};
}

Result<pb::WhatIf> complete(pb::WhatIf question, const std::vector<std::string>& known) {
  if (question.strategies_size() == 0)
    for (std::size_t i = 0; i < std::min<std::size_t>(known.size(), sim::foresight::kMaxStrategies); ++i)
      question.add_strategies(known[i]);
  if (question.opponent().empty()) question.set_opponent(kBaseline);
  if (question.horizon() == 0) question.set_horizon(kDefaultHorizon);
  if (question.budget_ms() == 0) question.set_budget_ms(kDefaultBudgetMs);
  if (!question.has_switching_cost()) question.set_switching_cost(kDefaultCost);

  if (Result<void> named = check_names(question, known); !named) return Error{named.error()};
  if (!pb::WhatIf::Measure_IsValid(question.measure())) return Error{"'measure' is none that there is"};
  if (!pb::WhatIf::Until_IsValid(question.until())) return Error{"'until' is none that there is"};
  if (!is_within(question.horizon(), 1, kLongestHorizon))
    return Error{"'horizon' must be 1 .. 1200 [s], got " + number(static_cast<double>(question.horizon()))};
  if (question.budget_ms() < kLeastBudgetMs || question.budget_ms() > kMostBudgetMs)
    return Error{"'budget_ms' must be 10 .. 10000 [ms], got " + std::to_string(question.budget_ms())};
  if (!is_within(question.switching_cost(), 0, 10))
    return Error{"'switching_cost' must be 0 .. 10, got " + number(static_cast<double>(question.switching_cost()))};
  return question;
}

sim::foresight::Question question_of(const pb::WhatIf& question) {
  return {.own = sim::Side::home,
          .measure = static_cast<sim::foresight::Measure>(question.measure()),
          .until = static_cast<sim::foresight::Until>(question.until()),
          .horizon = sim::ticks(question.horizon()),
          .switching_cost = question.switching_cost()};
}

void tell(const pb::WhatIf::Edit& edit, const Lineups& lineups, sim::foresight::Knowledge& knowledge) {
  sim::agent::Beliefs& beliefs = knowledge.beliefs;
  for (const pb::WhatIf::MovedRobot& moved : edit.robots()) {
    if (moved.opponent() || lineups.own.place_of(moved.player()) != knowledge.game.player) continue;
    if (!is_sane(moved.x()) || !is_sane(moved.y()) || !is_within(moved.heading(), -sim::kPi, sim::kPi)) continue;
    beliefs.pose = {.pose = {{moved.x(), moved.y()}, sim::normalized(moved.heading())}};
  }
  if (!edit.has_ball() || !is_sane(edit.ball().x()) || !is_sane(edit.ball().y())) return;
  const sim::Pose2& pose = beliefs.pose.pose;
  const Vec2 to_ball = Vec2{edit.ball().x(), edit.ball().y()} - pose.position;
  beliefs.ball = {.position = sim::turned_back(to_ball, sim::direction(pose.heading)), .seen = knowledge.now};
}

Result<void> apply(const pb::WhatIf::Edit& edit, const Lineups& lineups, const sim::Params& params,
                   sim::foresight::Situation& situation) {
  sim::State& state = situation.state;
  sim::World& world = state.world;
  const sim::ContactModel& contact = params.teams[0].models.contact;
  for (const pb::WhatIf::MovedRobot& moved : edit.robots()) {
    if (const Lineup& lineup = lineups.of(side_of(moved)); lineup.place_of(moved.player()) == 0)
      return Error{name_of(moved) + " does not play: players are " + lineup.text()};
    const Vec2 at{moved.x(), moved.y()};
    if (Result<void> placed = check_place(params.rules.field, name_of(moved), at, contact.robot_radius); !placed)
      return placed;
    if (!is_within(moved.heading(), -sim::kPi, sim::kPi))
      return Error{name_of(moved) + ": 'heading' must be -3.1416 .. 3.1416 [rad], got " +
                   number(static_cast<double>(moved.heading()))};
    const int robot = index_of(moved, lineups);
    sim::Body& body = world.bodies[robot];
    body = {};
    body.position = at;
    body.heading = moved.heading();
    body.facing = sim::direction(moved.heading());
    state.book.penalised_until[robot] = 0;
    sim::enter(params, state, robot);
    situation.doubt.position[robot] = situation.doubt.heading[robot] = 0;
  }
  if (edit.has_ball()) {
    const Vec2 at{edit.ball().x(), edit.ball().y()};
    if (Result<void> placed = check_place(params.rules.field, "the ball", at, 0); !placed) return placed;
    sim::place(world.ball, at);
    situation.doubt.ball = situation.doubt.ball_velocity = situation.doubt.ball_elsewhere = 0;
    situation.doubt.ball_by_own_eyes = false;
    constexpr float kKnown = 0.1f;  // [m] and [m/s]
    sim::know_ball(state, world.tick, kKnown);
  }
  if (Result<void> apart = check_apart(edit, lineups, contact, world); !apart) return apart;
  if (edit.own_score() > 255 || edit.opponent_score() > 255)
    return Error{"a score must be 0 .. 255, got " + std::to_string(std::max(edit.own_score(), edit.opponent_score()))};
  if (edit.has_own_score()) state.book.score[0] = static_cast<std::uint8_t>(edit.own_score());
  if (edit.has_opponent_score()) state.book.score[1] = static_cast<std::uint8_t>(edit.opponent_score());
  if (!edit.has_seconds_remaining()) return {};
  const float half = params.rules.half_duration;
  if (!is_within(edit.seconds_remaining(), 0, half))
    return Error{"'seconds_remaining' must be 0 .. " + number(static_cast<double>(half)) + " [s], got " +
                 number(static_cast<double>(edit.seconds_remaining()))};
  state.book.clock = sim::ticks(half - edit.seconds_remaining());
  return {};
}

}  // namespace robot::foreseeing
