#include "sim/guest/moment.h"

#include <cmath>
#include <cstring>

#include "sim/agent/head.h"
#include "sim/agent/roles.h"
#include "sim/agent/tree.h"

namespace sim::guest {
namespace {

using Body = motion::Command::Body;
using Head = motion::Command::Head;

static_assert(FORESIGHT_NEVER == kNever);
static_assert(FORESIGHT_MAX_PLAYERS == kMaxPlayers);
static_assert(FORESIGHT_MAX_KICKS == motion::kMaxKicks);
static_assert(FORESIGHT_FINISHED == static_cast<int>(agent::Game::Phase::finished));
static_assert(FORESIGHT_CORNER_KICK == static_cast<int>(agent::Game::SetPlay::corner_kick));
static_assert(FORESIGHT_DEFENDER == static_cast<int>(agent::Role::defender));

constexpr float kMostMetres = 100, kMostSeconds = 1e7f;
constexpr std::uint16_t kDecided = 0;  // Mind.leaf of a guest that has decided since it entered

ForesightKick kick_of(const motion::Kick& kick) {
  ForesightKick told{};
  std::memcpy(told.name, kick.name, sizeof told.name);
  told.ball_x = kick.ball_x, told.ball_y = kick.ball_y;
  told.gate_x = kick.gate_x, told.gate_y = kick.gate_y;
  told.delay = kick.delay, told.duration = kick.duration;
  told.range = kick.range, told.direction = kick.direction;
  return told;
}

ForesightMate mate_of(const agent::Mate& mate) {
  return {.sent = mate.sent,
          .x = mate.pose.position.x,
          .y = mate.pose.position.y,
          .heading = mate.pose.heading,
          .ball_x = mate.ball.x,
          .ball_y = mate.ball.y,
          .ball_age = mate.ball_age == 0xffff ? FORESIGHT_NEVER : mate.ball_age,
          .time_to_ball = mate.time_to_ball(),
          .role = mate.role,
          .active = mate.active};
}

std::string outside(const char* name, double least, double most, double value) {
  char text[120];
  std::snprintf(text, sizeof text, "%s must be %g .. %g, got %g", name, least, most, value);
  return text;
}

}  // namespace

ForesightPlayer player_of(const agent::Surroundings& surroundings, const agent::Game& game, std::uint64_t seed) {
  const motion::Model& body = *surroundings.motion;
  ForesightPlayer player{};
  player.seed = seed;
  player.player = game.player, player.players = game.players;
  player.field_length = surroundings.rules->field.length, player.field_width = surroundings.rules->field.width;
  player.goal_width = surroundings.rules->field.goal_width;
  player.walk_forward = body.walk.forward, player.walk_backward = body.walk.backward;
  player.walk_sideward = body.walk.sideward, player.walk_turn = body.walk.turn_rate;
  player.kick_count = body.kick_count;
  for (int i = 0; i < body.kick_count; ++i) player.kicks[i] = kick_of(body.kicks[i]);
  return player;
}

ForesightMoment moment_of(const agent::Game& game, const agent::Beliefs& beliefs, Tick now, bool entered) {
  ForesightMoment moment{};
  moment.now = now, moment.entered = entered;
  moment.phase = static_cast<int>(game.phase), moment.set_play = static_cast<int>(game.set_play);
  moment.own_kick = game.own_kick, moment.penalised = game.penalised;
  moment.half = game.half, moment.own_score = game.own_score, moment.opponent_score = game.opponent_score;
  moment.remaining = game.remaining, moment.since_phase = game.since_phase;

  const agent::Ball& ball = beliefs.ball;
  moment.ball_seen = ball.seen, moment.ball_visible = ball.visible;
  moment.ball_x = ball.position.x, moment.ball_y = ball.position.y;
  moment.ball_vx = ball.velocity.x, moment.ball_vy = ball.velocity.y;
  moment.ball_deviation = std::sqrt(ball.variance);
  const agent::Pose& own = beliefs.pose;
  moment.x = own.pose.position.x, moment.y = own.pose.position.y, moment.heading = own.pose.heading;
  moment.deviation = own.deviation, moment.deviation_heading = own.deviation_heading;

  for (ForesightMate& mate : moment.mates) mate.sent = FORESIGHT_NEVER;
  for (int i = 0; i + 1 < game.players; ++i)
    moment.mates[agent::player_of_mate(game.player, i) - 1] = mate_of(beliefs.mates[i]);
  for (int i = 0; i < kMaxPlayers; ++i) {
    const agent::Opponent& opponent = beliefs.opponents[i];
    moment.opponents[i] = {.seen = opponent.seen, .x = opponent.position.x, .y = opponent.position.y};
  }
  return moment;
}

ForesightCommand usual_command(const agent::Mind& mind) {
  ForesightCommand command{};
  command.gain = 1;
  command.role = static_cast<int>(mind.role);
  command.time_to_ball = mind.time_to_ball();
  return command;
}

std::string problem_of(const ForesightCommand& command, int kicks) {
  const auto check = [](const char* name, double value, double least, double most) {
    // written so that NaN is outside, too
    return value >= least && value <= most ? std::string() : outside(name, least, most, value);
  };
  const auto first = [](std::initializer_list<std::string> problems) {
    for (const std::string& problem : problems)
      if (!problem.empty()) return problem;
    return std::string();
  };
  return first({check("body", command.body, FORESIGHT_USUAL, FORESIGHT_SQUAT),
                check("head", command.head, FORESIGHT_LOOK_USUAL, FORESIGHT_LOOK_TO),
                check("x", command.x, -kMostMetres, kMostMetres), check("y", command.y, -kMostMetres, kMostMetres),
                check("turn", command.turn, -kMostMetres, kMostMetres), check("gain", command.gain, 0, 1),
                check("kick", command.kick, 0, command.body == FORESIGHT_KICK ? kicks - 1 : motion::kMaxKicks - 1),
                check("look", command.look[0], -kMostMetres, kMostMetres),
                check("look", command.look[1], -kMostMetres, kMostMetres),
                check("look", command.look[2], -kMostMetres, kMostMetres),
                check("role", command.role, FORESIGHT_KEEPER, FORESIGHT_DEFENDER),
                check("time_to_ball", command.time_to_ball, 0, kMostSeconds)});
}

motion::Command command_of(const ForesightCommand& told, const agent::Surroundings& surroundings,
                           const agent::Game& game, const agent::Beliefs& beliefs, Tick now, agent::Mind& mind) {
  const agent::Settings settings;
  const agent::View view(surroundings, settings, game, beliefs, now, mind);
  // the head looks first to the side of the last ball
  if (view.ball_known && view.ball_distance > 0.6f) mind.search_side = agent::left_or_right(view.ball.y);

  motion::Command command = agent::wait(view, mind, nullptr);
  if (told.body != FORESIGHT_USUAL) {
    command.body = static_cast<Body>(told.body - FORESIGHT_STAND);
    command.walk = {told.x, told.y};
    command.turn = told.turn, command.gain = told.gain;
    command.kick = static_cast<std::uint8_t>(told.kick), command.kick_left = told.kick_left != 0;
  }
  if (told.head != FORESIGHT_LOOK_USUAL) {
    command.head = told.head == FORESIGHT_LOOK_ANGLES ? Head::angles : Head::look_to;
    for (int i = 0; i < 3; ++i) command.look[i] = told.look[i];
  }
  if (static_cast<int>(mind.role) != told.role) mind.role_since = now;
  mind.role = static_cast<agent::Role>(told.role);
  mind.time_to_ball_cs = agent::centiseconds(told.time_to_ball);
  mind.leaf = kDecided;
  return command;
}

}  // namespace sim::guest
