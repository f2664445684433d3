#include "sim/io/situation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "robot/core/json_library.h"
#include "sim/foresight/guess.h"
#include "sim/io/reader.h"
#include "sim/io/source.h"
#include "sim/match/situation.h"
#include "sim/match/step.h"

namespace sim::io {

using robot::Result;

namespace {

using Phase = agent::Game::Phase;
using SetPlay = agent::Game::SetPlay;

// by enumerator
constexpr std::span kSetPlayWords = std::span(agent::kSetPlayWords).first<agent::kSetPlays>();
constexpr std::array kSides = {"home", "away"};

constexpr float kKnownDeviation = 0.1f;  // [m] and [m/s] of a ball or robot just seen

// limits of shaking
constexpr float kShaken = 0.3f;                           // [m]
constexpr float kTurned = 0.35f;                          // [rad]
constexpr float kRoomToBall = 0.2f, kRoomToRobot = 0.4f;  // [m] between middles
constexpr std::uint32_t kTries = 20;
constexpr std::uint32_t kShakes = 1000;  // first number of the event

struct Clock {
  int half = 1;
  float clock = 0, remaining = -1;  // remaining < 0: not given

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("half", self.half, "", 1, 4);
    see("clock", self.clock, "", 0.f, 36000.f);
    see("remaining", self.remaining, "", 0.f, 36000.f);
  }
};

struct Teams : SituationTeams {
  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("home", self.home, "", 1, 999);
    see("away", self.away, "", 1, 999);
  }
};

struct Score {
  int home = 0, away = 0;

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("home", self.home, "", 0, 255);
    see("away", self.away, "", 0, 255);
  }
};

struct PlaceOnField {
  float x = 0, y = 0;

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("x", self.x, "", -20.f, 20.f);
    see("y", self.y, "", -20.f, 20.f);
  }
};

struct Velocity {
  float velocity_x = 0, velocity_y = 0;

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("velocity_x", self.velocity_x, "", -20.f, 20.f);
    see("velocity_y", self.velocity_y, "", -20.f, 20.f);
  }
};

/// The uncertainty of a place; below 0: not given.
struct BallDoubt {
  float deviation = -1, velocity_deviation = -1;

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("deviation", self.deviation, "", 0.f, 10.f);
    see("velocity_deviation", self.velocity_deviation, "", 0.f, 10.f);
  }
};

struct RobotDoubt {
  float deviation = -1, heading_deviation = -1;

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("deviation", self.deviation, "", 0.f, 10.f);
    see("heading_deviation", self.heading_deviation, "", 0.f, 3.2f);
  }
};

struct Standing {
  int player = 1;
  float heading = 0, penalised = 0;

  template <class Self, class See>
  static void visit(Self& self, See&& see) {
    see("player", self.player, "", 1, kMaxPlayers);
    see("heading", self.heading, "", -3.1415927f, 3.1415927f);
    see("penalised", self.penalised, "", 0.f, 3600.f);
  }
};

/// Returns the enumerator named by the text at `key`, or `otherwise`.
template <class Enum>
Enum name_at(Reader& reader, const Json& object, const std::string& path, const char* key,
             std::span<const char* const> names, Enum otherwise) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (*found == names[i]) return static_cast<Enum>(i);
  reader.refuse(Reader::below(path, key) + " must be one of " + listed({names.begin(), names.end()}) + ", got " +
                shown(*found));
  return otherwise;
}

/// Turns ball and robots by half a turn round the middle of the field.
void turn_round(World& world) {
  const Vec2 velocity = world.ball.velocity;
  place(world.ball, -world.ball.position);
  world.ball.velocity = -velocity;
  for_each_robot(world.players, [&](int robot) {
    Body& body = world.bodies[robot];
    body.position = -body.position;
    body.heading = normalized(body.heading + kPi);
    body.facing = direction(body.heading);
  });
}

/// The builder of a state from a description.
class Scene {
 public:
  Scene(Reader& reader, const Params& params, const RandomKey* shaken, bool turned)
      : reader_(reader), params_(params), shaken_(shaken), turned_(turned) {}

  State build(const Json& json) {
    referee::Events events;
    state_ = begin(params_, {.seed = seed_in(json)}, events);
    read_teams(reader_, json);
    read_game(json);
    if (const Json* ball = reader_.find(json, "ball", Fields::all)) read_ball(*ball);
    if (const Json* robots = reader_.find(json, "robots", Fields::all)) read_robots(*robots);
    reader_.refuse_unknown(json, "",
                           {"about", "seed", "teams", "phase", "set_play", "kicking", "half", "clock", "remaining",
                            "score", "ball", "robots", "check"});
    if (!reader_.good()) return state_;
    if (turned_) turn();
    if (shaken_) shake();
    start_play(params_, state_);
    set_phase(json);
    // all robots see the ball and hear their teammates
    know_ball(state_, state_.world.tick, kKnownDeviation);
    return state_;
  }

 private:
  std::uint64_t seed_in(const Json& json) {
    const auto seed = json.find("seed");
    if (seed == json.end()) return 0;
    if (!seed->is_number_unsigned()) reader_.refuse("seed must be a whole number from 0, got " + shown(*seed));
    return seed->is_number_unsigned() ? seed->get<std::uint64_t>() : 0;
  }

  void read_game(const Json& json) {
    referee::Book& book = state_.book;
    Clock clock;
    read_some(json, "", clock, {"half", "clock", "remaining"});
    if (clock.half > params_.rules.halves)
      reader_.refuse("half must be at most " + std::to_string(params_.rules.halves) + " by these rules, got " +
                     std::to_string(clock.half));
    if (clock.clock > params_.rules.half_duration)
      reader_.refuse("clock must be at most " + short_text(params_.rules.half_duration) + " [s] by these rules, got " +
                     short_text(clock.clock));
    if (clock.remaining > params_.rules.half_duration)
      reader_.refuse("remaining must be at most " + short_text(params_.rules.half_duration) +
                     " [s] by these rules, got " + short_text(clock.remaining));
    if (clock.remaining >= 0 && json.contains("clock")) reader_.refuse("expected clock or remaining, got both");
    if (clock.remaining >= 0) clock.clock = std::max(0.f, params_.rules.half_duration - clock.remaining);
    Score score;
    if (const auto found = json.find("score"); found != json.end()) reader_.read(*found, "score", Fields::some, score);

    set_phase(json);
    book.half = static_cast<std::uint8_t>(clock.half);
    book.clock = ticks(clock.clock);
    book.score[0] = static_cast<std::uint8_t>(score.home);
    book.score[1] = static_cast<std::uint8_t>(score.away);
    state_.world.home_attacks = clock.half % 2 == 1 ? 1.f : -1.f;
  }

  void set_phase(const Json& json) {
    referee::Book& book = state_.book;
    book.phase = name_at(reader_, json, "", "phase", agent::kPhaseWords, Phase::playing);
    book.set_play = name_at(reader_, json, "", "set_play", kSetPlayWords, SetPlay::none);
    book.kicking = name_at(reader_, json, "", "kicking", kSides, Side::home);
    if (turned_) book.kicking = other(book.kicking);
    book.last_touch = book.kicking;
    book.ball_free = book.set_play == SetPlay::none;
  }

  /// Reads the present fields of `into` from an object that may have others.
  template <class Struct>
  void read_some(const Json& object, const std::string& path, Struct& into, const std::vector<const char*>& keys,
                 Fields fields = Fields::some) {
    if (!reader_.is_object(object, path)) return;
    Json own = Json::object();
    for (const char* key : keys)
      if (const auto found = object.find(key); found != object.end()) own[key] = *found;
    reader_.read(own, path, fields, into);
  }

  void read_ball(const Json& json) {
    PlaceOnField place;
    Velocity velocity;
    read_some(json, "ball", place, {"x", "y"}, Fields::all);
    read_some(json, "ball", velocity, {"velocity_x", "velocity_y"});
    read_some(json, "ball", ball_doubt_, {"deviation", "velocity_deviation"});
    reader_.refuse_unknown(json, "ball", {"x", "y", "velocity_x", "velocity_y", "deviation", "velocity_deviation"});

    sim::place(state_.world.ball, {place.x, place.y});
    state_.world.ball.velocity = {velocity.velocity_x, velocity.velocity_y};
  }

  void read_robots(const Json& json) {
    if (!json.is_array()) return reader_.refuse("robots must be a list, got " + shown(json));
    for_each_robot(state_.world.players, [&](int robot) { take_away(robot, kNever); });
    for (std::size_t i = 0; i < json.size() && reader_.good(); ++i)
      read_robot(json[i], "robots[" + std::to_string(i) + "]");
  }

  void read_robot(const Json& json, const std::string& path) {
    if (!reader_.is_object(json, path)) return;
    PlaceOnField place;
    Standing standing;
    RobotDoubt doubt;
    read_some(json, path, place, {"x", "y"}, Fields::all);
    read_some(json, path, standing, {"player", "heading", "penalised"});
    read_some(json, path, doubt, {"deviation", "heading_deviation"});
    for (const char* key : {"side", "player"})
      if (!json.contains(key)) reader_.refuse(path + "." + key + " is missing");
    const Side side = name_at(reader_, json, path, "side", kSides, Side::home);
    reader_.refuse_unknown(json, path,
                           {"side", "player", "x", "y", "heading", "penalised", "deviation", "heading_deviation"});
    if (standing.player > state_.world.players)
      reader_.refuse(path + ".player must be at most " + std::to_string(state_.world.players) + " in this game, got " +
                     std::to_string(standing.player));
    if (!reader_.good()) return;

    const int robot = robot_of(side, standing.player);
    if (named_[robot]) return reader_.refuse(path + " names the same robot as one before it");
    named_[robot] = true;
    robot_doubts_[robot] = doubt;
    Body& body = state_.world.bodies[robot];
    body = {};
    body.position = {place.x, place.y};
    body.heading = standing.heading;
    body.facing = direction(standing.heading);
    state_.book.penalised_until[robot] = 0;
    if (standing.penalised > 0) take_away(robot, std::max<Tick>(ticks(standing.penalised), 1));
  }

  void take_away(int robot, Tick until) {
    state_.world.bodies[robot].doing = Body::Doing::removed;
    state_.book.penalised_until[robot] = until;
  }

  /// Gives each side the other's moment: half a turn round the middle of the field, with exchanged robots and score.
  void turn() {
    World& world = state_.world;
    turn_round(world);
    std::swap(state_.book.score[0], state_.book.score[1]);
    for (int robot = 0; robot < kMaxPlayers; ++robot) {
      std::swap(world.bodies[robot], world.bodies[robot + kMaxPlayers]);
      std::swap(state_.book.penalised_until[robot], state_.book.penalised_until[robot + kMaxPlayers]);
      std::swap(robot_doubts_[robot], robot_doubts_[robot + kMaxPlayers]);
    }
  }

  /// Moves each to the first free place drawn near its own.
  void shake() {
    World& world = state_.world;
    shake_ball();
    for_each_robot(world.players, [&](int robot) {
      Body& body = world.bodies[robot];
      if (!on_field(body)) return;
      const Vec2 place = body.position;
      for (std::uint32_t number = 0; number < kTries; ++number) {
        const Pose2 by = offset(robot, number, robot_doubts_[robot]);
        body.position = place + by.position;
        if (!is_free(robot)) continue;
        body.heading = normalized(body.heading + by.heading);
        body.facing = direction(body.heading);
        return;
      }
      body.position = place;
    });
  }

  void shake_ball() {
    Ball& ball = state_.world.ball;
    const Vec2 place = ball.position;
    if (ball_doubt_.deviation < 0) return sim::place(ball, place + offset(kNobody, 0, {}).position);
    for (std::uint32_t number = 0; number < kTries; ++number) {
      const auto drawn = normals(words_of(kNobody, number));
      const Vec2 to = place + ball_doubt_.deviation * Vec2{drawn[0], drawn[1]};
      if (foresight::beyond_lines(params_.rules.field, to)) continue;
      const Vec2 velocity = ball.velocity;
      sim::place(ball, to);
      ball.velocity = velocity + std::max(0.f, ball_doubt_.velocity_deviation) * Vec2{drawn[2], drawn[3]};
      return;
    }
  }

  std::array<std::uint32_t, 4> words_of(int robot, std::uint32_t number) const {
    return draw(*shaken_, static_cast<std::uint32_t>(robot), Draw::situation, kShakes + number);
  }

  /// Draws a random displacement.
  Pose2 offset(int robot, std::uint32_t number, const RobotDoubt& doubt) const {
    const auto words = words_of(robot, number);
    const auto one = [&](std::size_t i) { return 2 * uniform(words[i]) - 1; };
    Pose2 by{{kShaken * one(0), kShaken * one(1)}, kTurned * one(2)};
    const auto drawn = normals(words);
    if (doubt.deviation >= 0) by.position = doubt.deviation * Vec2{drawn[0], drawn[1]};
    if (doubt.heading_deviation >= 0) by.heading = doubt.heading_deviation * drawn[2];
    return by;
  }

  bool is_free(int robot) const {
    const World& world = state_.world;
    const Vec2 place = world.bodies[robot].position;
    bool free = squared_length(place - world.ball.position) > kRoomToBall * kRoomToBall;
    for_each_robot(world.players, [&](int other) {
      const Body& body = world.bodies[other];
      if (other == robot || !on_field(body)) return;
      if (squared_length(place - body.position) < kRoomToRobot * kRoomToRobot) free = false;
    });
    return free;
  }

  Reader& reader_;
  const Params& params_;
  const RandomKey* const shaken_;
  const bool turned_;
  State state_;
  bool named_[kMaxRobots] = {};
  BallDoubt ball_doubt_;
  RobotDoubt robot_doubts_[kMaxRobots];
};

/// Returns the description of a moment as JSON.
Json description_of(const State& state, const std::string& about) {
  const World& world = state.world;
  const referee::Book& book = state.book;
  const auto name = [](const auto& names, auto enumerator) { return names[static_cast<std::size_t>(enumerator)]; };
  Json json = Json::object();
  if (!about.empty()) json["about"] = about;
  json.update({{"seed", world.key.seed},
               {"phase", name(agent::kPhaseWords, book.phase)},
               {"set_play", name(kSetPlayWords, book.set_play)},
               {"kicking", name(kSides, book.kicking)},
               {"half", book.half},
               {"clock", short_number(static_cast<float>(book.clock) * kTickDuration)},
               {"score", {{"home", book.score[0]}, {"away", book.score[1]}}},
               {"ball",
                {{"x", short_number(world.ball.position.x)},
                 {"y", short_number(world.ball.position.y)},
                 {"velocity_x", short_number(world.ball.velocity.x)},
                 {"velocity_y", short_number(world.ball.velocity.y)}}},
               {"robots", Json::array()}});
  for_each_robot(world.players, [&](int robot) {
    const Body& body = world.bodies[robot];
    const Tick until = book.penalised_until[robot];
    if (until == kNever) return;
    Json said = {{"side", name(kSides, side_of(robot))},
                 {"player", player_of(robot)},
                 {"x", short_number(body.position.x)},
                 {"y", short_number(body.position.y)},
                 {"heading", short_number(body.heading)}};
    if (until > world.tick) said["penalised"] = short_number(age(until, world.tick));
    json["robots"].push_back(std::move(said));
  });
  return json;
}

int robot_in(const Json& entry) {
  return robot_of(entry["side"] == kSides[0] ? Side::home : Side::away, entry["player"].get<int>());
}

}  // namespace

SituationTeams read_teams(Reader& reader, const Json& situation) {
  Teams teams;
  const auto found = situation.find("teams");
  if (found == situation.end()) return {};
  reader.read(*found, "teams", Fields::all, teams);
  if (reader.good() && teams.home == teams.away)
    reader.refuse("teams must have different numbers, got " + std::to_string(teams.home) + " twice");
  return teams;
}

Result<State> parse_situation(std::string_view text, const std::string& called, const Params& params,
                              const RandomKey* shaken, bool turned) {
  const Result<Json> json = parse_object(text, called);
  if (!json) return json.failure();
  Reader reader(called);
  const State state = Scene(reader, params, shaken, turned).build(*json);
  if (!reader.good()) return reader.error();
  return state;
}

Result<State> load_situation(const std::string& name, const Params& params) {
  const Result<Source> source = find_source("situations", "situation", name);
  if (!source) return source.failure();
  return parse_situation(source->text, source->called, params);
}

std::string save_situation(const State& state, const std::string& about) {
  return printed(description_of(state, about));
}

std::string save_situation(const foresight::Situation& believed, SituationTeams teams, const std::string& about) {
  State state = believed.state;
  const float home_attacks = state.book.half % 2 == 1 ? 1.f : -1.f;  // in the field's frame of that half
  if (state.world.home_attacks != home_attacks) turn_round(state.world);
  Json json = description_of(state, about);
  if (teams.home > 0 && teams.away > 0 && teams.home != teams.away)
    json["teams"] = {{"home", teams.home}, {"away", teams.away}};
  // with the pose of the robot that saw it
  const foresight::Doubt& doubt = believed.doubt;
  const float seen_from = doubt.ball_by_own_eyes ? doubt.position[doubt.whose] : 0;
  json["ball"]["deviation"] = short_number(std::sqrt(doubt.ball * doubt.ball + seen_from * seen_from));
  json["ball"]["velocity_deviation"] = short_number(doubt.ball_velocity);
  for (Json& robot : json["robots"]) {
    robot["deviation"] = short_number(doubt.position[robot_in(robot)]);
    robot["heading_deviation"] = short_number(doubt.heading[robot_in(robot)]);
  }
  return printed(json);
}

}  // namespace sim::io
