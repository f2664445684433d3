#include "sim/foresight/situation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "sim/foresight/guess.h"
#include "sim/match/situation.h"
#include "sim/match/step.h"
#include "sim/perception/localisation.h"
#include "sim/referee/placed_back.h"
#include "sim/referee/referee.h"

namespace sim::foresight {
namespace {

using Phase = agent::Game::Phase;
using SetPlay = agent::Game::SetPlay;
using Doing = Body::Doing;

constexpr float kBorder = 0.3f;      // [m] beyond the lines where a robot may still be
constexpr std::uint32_t kTries = 8;  // tries for a place of the ball on the field near the believed one
// Share of balls at the place for balls that were out. Source: 500 balls that lay elsewhere than a robot believed, in
// games in which such a ball is placed back.
constexpr float kPlacedBack = 0.65f;

std::string sentence(const char* format, double value) {
  char text[160];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

const char* why_no_game(Phase phase) {
  if (phase == Phase::initial) return "the game has not begun";
  return phase == Phase::finished ? "the game is over" : nullptr;
}

/// Sets a body to its believed place and action.
void put(Body& body, const Pose2& pose) {
  body.position = pose.position;
  body.heading = normalized(pose.heading);
  body.facing = direction(body.heading);
}

/// Makes the most likely state and the uncertainty of each part.
class Guesswork {
 public:
  Guesswork(const Params& params, const Knowledge& knowledge)
      : params_(params), knowledge_(knowledge), own_(robot_of(Side::home, knowledge.game.player)) {}

  Believed believe() {
    Believed believed;
    believed.refusal = why_not();
    if (!believed.refusal.empty()) return believed;
    referee::Events opening;
    state_ = begin(params_, {}, opening);
    state_.world.tick = knowledge_.now;
    state_.world.home_attacks = 1;
    doubt_.whose = static_cast<std::uint8_t>(own_);
    place_ball();
    for_each_robot(state_.world.players, [&](int robot) { place_robot(robot); });
    start_play(params_, state_);
    take_over_game();
    know_ball(state_, ball_.seen, std::max(doubt_.ball, kKnownBall));
    take_over_mind();
    believed.situation = {state_, doubt_};
    return believed;
  }

 private:
  static constexpr float kKnownBall = 0.1f;  // [m] and [m/s]

  std::string why_not() {
    const agent::Pose& pose = knowledge_.beliefs.pose;
    if (const char* no_game = why_no_game(knowledge_.game.phase)) return no_game;
    if (knowledge_.game.player < 1 || knowledge_.game.player > params_.rules.players)
      return sentence("player %g does not play in such a game", knowledge_.game.player);
    if (!std::isfinite(pose.deviation) || pose.deviation > kLost)
      return sentence("the robot does not know where it is: its position is off by %.1f m", double{pose.deviation});
    ball_ = guess_ball(params_.rules.field, knowledge_);
    if (ball_.seen == kNever) return "nobody has seen the ball yet";
    if (age(knowledge_.now, ball_.seen) > kBallLost)
      return sentence("nobody has seen the ball for %.0f s", double{age(knowledge_.now, ball_.seen)});
    return {};
  }

  void place_ball() {
    place(state_.world.ball, ball_.position);
    state_.world.ball.velocity = ball_.velocity;
    doubt_.ball = ball_.deviation;
    doubt_.ball_velocity = ball_.velocity_deviation;
    doubt_.ball_elsewhere = ball_.elsewhere;
    doubt_.ball_by_own_eyes = ball_.by_own_eyes;
  }

  void place_robot(int robot) {
    Body& body = state_.world.bodies[robot];
    const int side = static_cast<int>(side_of(robot));
    const Tick away = knowledge_.away[side][player_of(robot) - 1];
    const RobotGuess guess = guess_robot(params_, knowledge_, ball_.position, robot);
    body = robot == own_ ? knowledge_.body : body_of_other(robot);
    put(body, guess.pose);
    doubt_.position[robot] = guess.deviation;
    doubt_.heading[robot] = guess.deviation_heading;
    if (away == 0) {
      // a body that has just returned to the field stands
      if (!on_field(body)) body.doing = Doing::standing;
      state_.book.penalised_until[robot] = 0;
      return;
    }
    body.doing = Doing::removed;
    state_.book.penalised_until[robot] = away == kNever ? kNever : knowledge_.now + away;
  }

  /// Lets a robot stand, or lie when that was reported too recently for it to be up again.
  Body body_of_other(int robot) const {
    const auto side = static_cast<int>(side_of(robot));
    const Tick down = knowledge_.down[side][player_of(robot) - 1];
    const motion::Falls& falls = models_of(params_, robot).motion.falls;
    if (down == 0 || knowledge_.now - down >= ticks(falls.usual_time())) return {};
    return {.doing = Doing::fallen, .since = down};
  }

  void take_over_game() {
    const agent::Game& game = knowledge_.game;
    referee::Book& book = state_.book;
    book.phase = game.phase;
    book.set_play = game.set_play;
    book.kicking = book.last_touch = game.own_kick ? Side::home : Side::away;
    book.ball_free = game.set_play == SetPlay::none;
    book.half = game.half;
    book.first_kick_off = game.half % 2 == 1 ? book.kicking : other(book.kicking);
    const float played = std::clamp(params_.rules.half_duration - game.remaining, 0.f, params_.rules.half_duration);
    book.clock = ticks(played);
    book.score[0] = game.own_score;
    book.score[1] = game.opponent_score;
    const Tick since = std::min(ticks(std::clamp(game.since_phase, 0.f, 3600.f)), knowledge_.now);
    book.phase_since = book.told_phase_since = knowledge_.now - since;
  }

  /// Gives the robot its own knowledge, and the others the beliefs that they reported.
  void take_over_mind() {
    for_each_robot(state_.world.players, [&](int robot) {
      state_.robots[robot].beliefs.pose.pose = perception::true_pose(state_.world, robot);
    });
    Robot& self = state_.robots[own_];
    self.beliefs = knowledge_.beliefs;
    self.mind = knowledge_.mind;
  }

  const Params& params_;
  const Knowledge& knowledge_;
  const int own_;
  BallGuess ball_;
  State state_;
  Doubt doubt_;
};

/// Returns four draws of the standard normal distribution.
std::array<float, 4> normals_of(RandomKey key, int who, std::uint32_t number = 0) {
  return normals(draw(key, static_cast<std::uint32_t>(who), Draw::belief, number));
}

/// Returns the nearest point where a robot may be.
Vec2 within_border(const field::Field& field, Vec2 point) {
  const Vec2 reach{field.length / 2 + kBorder, field.width / 2 + kBorder};
  return {std::clamp(point.x, -reach.x, reach.x), std::clamp(point.y, -reach.y, reach.y)};
}

/// Draws a ball near the believed place. A ball seen by the own eyes moves with the drawn pose of the robot, which was
/// believed at `seen_from`. Returns nothing when the ball would be out: the referee has then placed it elsewhere.
std::optional<Ball> ball_nearby(const field::Field& field, const World& world, const Doubt& doubt,
                                const Pose2& seen_from, RandomKey key) {
  Ball ball = world.ball;
  for (std::uint32_t number = 0; number < kTries; ++number) {
    const auto drawn = normals_of(key, kNobody, number);
    Vec2 position = world.ball.position + doubt.ball * Vec2{drawn[0], drawn[1]};
    Vec2 velocity = world.ball.velocity + doubt.ball_velocity * Vec2{drawn[2], drawn[3]};
    if (doubt.ball_by_own_eyes) {
      const Body& body = world.bodies[doubt.whose];
      const Vec2 turn = direction(normalized(body.heading - seen_from.heading));
      position = body.position + turned(position - seen_from.position, turn);
      velocity = turned(velocity, turn);
    }
    if (beyond_lines(field, position)) continue;
    place(ball, position);
    ball.velocity = velocity;
    return ball;
  }
  return {};
}

/// Returns a place where an assistant may have put a ball that was believed at `believed`. `along`,
/// `across`: uniform in [-0.5, 0.5).
Vec2 placed_back(const field::Rules& rules, Vec2 believed, float along, float across) {
  const field::Field& field = rules.field;
  const float corner = field.length / 2 - referee::placed_back::kEnd;
  const bool over_goal_line = std::abs(believed.x) > field.length / 2;
  const bool over_touch_line = !over_goal_line && std::abs(believed.y) > field.width / 2;
  // the side of the last touch is unknown
  float x = 2 * along * corner;
  if (over_goal_line) x = along < 0 ? std::copysign(corner, believed.x) : 0;
  if (over_touch_line) x = std::clamp(believed.x + std::copysign(rules.out_set_back, along), -corner, corner);
  const float line = over_goal_line || over_touch_line ? believed.y : across;
  return {x, std::copysign(field.width / 2 - rules.out_inset, line)};
}

/// Draws a lying ball that is not near the believed place. `words`: random numbers; the first is not used.
Ball ball_elsewhere(const field::Rules& rules, const Ball& believed, const std::array<std::uint32_t, 4>& words) {
  const field::Field& field = rules.field;
  const float along = uniform(words[1]) - 0.5f, across = uniform(words[2]) - 0.5f;
  const bool out = beyond_lines(field, believed.position);
  const bool back = rules.ball_out == field::BallOut::placed_back && (out || uniform(words[3]) < kPlacedBack);
  Ball ball = believed;
  place(ball,
        back ? placed_back(rules, believed.position, along, across) : Vec2{field.length * along, field.width * across});
  ball.velocity = {};
  return ball;
}

/// Gives every robot but `whose` its true place. The team keeps its belief about the ball; the opponents get the true
/// one.
void let_others_know(Vec2 supposed_ball, int whose, State& state) {
  const World& world = state.world;
  for_each_robot(world.players, [&](int robot) {
    const Body& body = world.bodies[robot];
    if (robot == whose || !on_field(body)) return;
    agent::Beliefs& beliefs = state.robots[robot].beliefs;
    beliefs.pose.pose = perception::true_pose(world, robot);
    const Vec2 ball = side_of(robot) == side_of(whose) ? supposed_ball : world.ball.position;
    beliefs.ball.position = turned_back(ball - body.position, body.facing);
  });
}

}  // namespace

Knowledge knowledge_of(const Params& params, const State& state, int robot) {
  const World& world = state.world;
  const Robot& self = state.robots[robot];
  Knowledge knowledge{.now = world.tick,
                      .game = referee::game_for(params.rules, world, state.book, robot),
                      .beliefs = self.beliefs,
                      .mind = self.mind,
                      .body = world.bodies[robot]};
  for_each_robot(world.players, [&](int other) {
    const Tick until = state.book.penalised_until[other];
    if (until == 0) return;
    const int side = side_of(other) == side_of(robot) ? 0 : 1;
    knowledge.away[side][player_of(other) - 1] =
        until == kNever ? kNever : std::max<Tick>(until, world.tick + 1) - world.tick;
  });
  return knowledge;
}

Believed believe(const Params& params, const Knowledge& knowledge) { return Guesswork(params, knowledge).believe(); }

void tell(const World& truth, Side own, Insight insight, Situation& situation) {
  World& world = situation.state.world;
  Doubt& doubt = situation.doubt;
  const float sign = attack_sign(truth, own);  // from field to team_field
  if (insight.ball) {
    place(world.ball, sign * truth.ball.position);
    world.ball.velocity = sign * truth.ball.velocity;
    doubt.ball = doubt.ball_velocity = doubt.ball_elsewhere = 0;
    doubt.ball_by_own_eyes = false;
  }
  for_each_robot(world.players, [&](int robot) {
    const bool is_own = side_of(robot) == Side::home;  // in a situation the own side is home
    const Body& body = truth.bodies[robot_of(is_own ? own : other(own), player_of(robot))];
    if (!(is_own ? insight.own_side : insight.opponents)) return;
    if (!on_field(body) || !on_field(world.bodies[robot])) return;
    world.bodies[robot] = body;
    put(world.bodies[robot], {sign * body.position, sign > 0 ? body.heading : body.heading + kPi});
    doubt.position[robot] = doubt.heading[robot] = 0;
  });
}

State sample(const Params& params, const Situation& situation, RandomKey key) {
  const Doubt& doubt = situation.doubt;
  State state = situation.state;
  World& world = state.world;
  world.key = key;
  Pose2 seen_from;  // believed pose of the robot that saw the ball
  if (doubt.ball_by_own_eyes) {
    const Body& body = world.bodies[doubt.whose];
    seen_from = {body.position, body.heading};
  }
  for_each_robot(world.players, [&](int robot) {
    Body& body = world.bodies[robot];
    if (!on_field(body)) return;
    const auto drawn = normals_of(key, robot);
    const Vec2 off = doubt.position[robot] * Vec2{drawn[0], drawn[1]};
    put(body, {within_border(params.rules.field, body.position + off), body.heading + doubt.heading[robot] * drawn[2]});
    state.robots[robot].cognition.last = {body.position, body.heading};
  });

  const field::Field& field = params.rules.field;
  const auto words = draw(key, kNobody, Draw::belief, kTries);  // the numbers before it belong to the tries
  const bool stays = uniform(words[0]) >= doubt.ball_elsewhere;
  const auto near = stays ? ball_nearby(field, world, doubt, seen_from, key) : std::nullopt;
  world.ball = near ? *near : ball_elsewhere(params.rules, world.ball, words);
  if (doubt.whose != kNobody) let_others_know(situation.state.world.ball.position, doubt.whose, state);
  return state;
}

}  // namespace sim::foresight
