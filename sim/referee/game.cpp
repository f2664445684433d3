#include "sim/referee/referee.h"

namespace sim::referee {

float left_of_half(const field::Rules& rules, const Book& book) {
  return rules.half_duration - static_cast<float>(book.clock) * kTickDuration;
}

float countdown_of(const field::Rules& rules, agent::Game::Phase phase, agent::Game::SetPlay set_play) {
  if (phase == agent::Game::Phase::ready) return rules.ready_duration;
  if (phase != agent::Game::Phase::playing || set_play == agent::Game::SetPlay::none) return 0;
  return set_play == agent::Game::SetPlay::kick_off ? rules.kick_off_duration : rules.set_play_duration;
}

agent::Game game_for(const field::Rules& rules, const World& world, const Book& book, int robot) {
  const Side side = side_of(robot);
  agent::Game game;
  game.penalised = book.penalised_until[robot] != 0;
  game.player = static_cast<std::uint8_t>(player_of(robot));
  game.players = static_cast<std::uint8_t>(rules.players);
  game.half = book.half;
  game.own_score = book.score[static_cast<int>(side)];
  game.opponent_score = book.score[static_cast<int>(other(side))];
  game.remaining = left_of_half(rules, book);

  // the last goal is not reported to the robots yet: for them play goes on
  if (world.tick < book.told_phase_since) {
    game.phase = agent::Game::Phase::playing;
    game.since_phase = age(world.tick, book.playing_since);
    --(side == book.kicking ? game.opponent_score : game.own_score);
    return game;
  }
  game.phase = book.phase;
  game.set_play = book.set_play;
  game.own_kick = book.set_play != agent::Game::SetPlay::none && book.kicking == side;
  game.since_phase = age(world.tick, book.phase_since);
  return game;
}

}  // namespace sim::referee
