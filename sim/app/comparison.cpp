#include "sim/app/comparison.h"

#include <filesystem>
#include <utility>

#include "robot/core/files.h"
#include "sim/app/game_report.h"
#include "sim/io/situation.h"
#include "sim/io/source.h"
#include "sim/match/hash.h"
#include "sim/match/play.h"

namespace sim::app {
namespace {

using Kind = referee::Event::Kind;

constexpr Side kSides[] = {Side::home, Side::away};

/// A number for the text of the file that a name means; 0 where it means none.
std::uint64_t content_of(const std::string& name) {
  const std::string path = name.substr(0, name.find_first_of(",:"));
  if (!io::is_path(path)) return 0;
  const auto text = robot::read_file(path, io::kMaxFileBytes);
  Hash hash;
  if (text)
    for (const char c : *text) hash.add(static_cast<unsigned char>(c));
  return hash.value();
}

const char* name(Metric metric) {
  switch (metric) {
    case Metric::goals: return "goals";
    case Metric::first_goal: return "first_goal";
    case Metric::conceded: return "conceded";
    case Metric::score_within: return "score_within";
  }
  return "";
}

}  // namespace

robot::Result<void> Comparison::seat(std::vector<Seat>& seats, const std::string& home, const std::string& away,
                                     Side judged) {
  auto setup = io::prepare({.rules = choice_.rules,
                            .strategies = {home, away},
                            .models = {choice_.models, choice_.models},
                            .players = choice_.players,
                            .pace = choice_.pace});
  if (!setup) return robot::Error{setup.error()};
  Seat seat{.params = setup->params, .side = judged, .start = {}};
  if (!choice_.situation.empty()) {
    auto start = io::load_situation(choice_.situation, setup->params);
    if (!start) return robot::Error{start.error()};
    seat.start = *start;
  }
  for (const auto& behaviour : setup->behaviours) behaviours_.push_back(behaviour);
  seats.push_back(std::move(seat));
  return {};
}

robot::Result<Comparison> Comparison::prepare(const ComparisonChoice& choice) {
  if (choice.metric == Metric::conceded && choice.opponent.empty())
    return robot::Error{"metric 'conceded' needs --vs: against each other it is what 'goals' says"};
  if (choice.metric == Metric::score_within && choice.seconds <= 0)
    return robot::Error{"metric 'score_within' needs a time, such as score_within:30s"};
  Comparison made;
  made.choice_ = choice;
  // the first game of a pair has B away, the second at home
  for (const Side side : {Side::away, Side::home}) {
    const auto seat = [&](std::vector<Seat>& seats, const std::string& judged, const std::string& against) {
      return made.seat(seats, side == Side::home ? judged : against, side == Side::home ? against : judged, side);
    };
    if (!choice.opponent.empty())
      if (auto seated = seat(made.a_, choice.a, choice.opponent); !seated) return robot::Error{seated.error()};
    const std::string& against = choice.opponent.empty() ? choice.a : choice.opponent;
    if (auto seated = seat(made.b_, choice.b, against); !seated) return robot::Error{seated.error()};
  }

  Hash probe;
  for (const std::vector<Seat>* seats : {&made.a_, &made.b_})
    for (const Seat& seat : *seats) {
      referee::Events events;
      State state = begin(seat.params, {.seed = choice.seed}, events);
      for (int i = 0; i < 3000; ++i) step(seat.params, state, events);
      probe.add(hash_of(state));
    }
  Json json = {{"a", choice.a},
               {"b", choice.b},
               {"vs", choice.opponent},
               {"rules", choice.rules},
               {"models", choice.models},
               {"players", choice.players},
               {"every_tick", choice.pace == Pace::every_tick},
               {"situation", choice.situation},
               {"seconds", choice.seconds},
               {"metric", name(choice.metric)},
               {"seed", choice.seed},
               {"build", hex(probe.value())}};
  for (const std::string* file :
       {&choice.a, &choice.b, &choice.opponent, &choice.rules, &choice.models, &choice.situation})
    if (const std::uint64_t content = content_of(*file)) json["files"][*file] = hex(content);
  made.specification_ = json.dump();
  return made;
}

Comparison::Score Comparison::play(const Seat& seat, std::uint64_t seed) const {
  State state;
  referee::Events opening;
  if (seat.start) {
    state = *seat.start;
    state.world.key.seed += seed;
  } else {
    state = begin(seat.params, {.seed = seed}, opening);
  }
  const int before[2] = {state.book.score[0], state.book.score[1]};
  const Tick end = choice_.seconds > 0 ? state.world.tick + ticks(static_cast<float>(choice_.seconds)) : kNever;
  std::optional<Side> first;
  int goals[2] = {0, 0};
  sim::play(
      seat.params, state,
      [&](const State& now) { return now.world.tick >= end || (first && choice_.metric == Metric::first_goal); },
      [&](const referee::Event& event) {
        if (event.kind == Kind::goal && !first) first = event.side;
      });
  for (const Side side : kSides)
    goals[static_cast<int>(side)] = state.book.score[static_cast<int>(side)] - before[static_cast<int>(side)];
  Score score{.own = goals[static_cast<int>(seat.side)], .other = goals[static_cast<int>(other(seat.side))]};
  switch (choice_.metric) {
    case Metric::goals: score.value = score.own - score.other; break;
    case Metric::first_goal: score.value = !first ? 0 : *first == seat.side ? 1 : -1; break;
    case Metric::conceded: score.value = -score.other; break;
    case Metric::score_within: score.value = score.own > 0 ? 1 : 0; break;
  }
  return score;
}

compare::Pair Comparison::play(std::int64_t number) const {
  const std::uint64_t seed = seed_of(number);
  compare::Pair pair;
  for (const int place : {0, 1}) {
    const auto index = static_cast<std::size_t>(place);
    const Score b = play(b_[index], seed);
    Score a{.own = b.other, .other = b.own};  // against each other: the same game from the other side
    int gain = b.value;
    if (!a_.empty()) {
      a = play(a_[index], seed);
      gain = b.value - a.value;
    } else if (choice_.metric == Metric::score_within) {
      gain = b.value - (b.other > 0 ? 1 : 0);
    }
    pair.games[place] = {.gain = gain, .goals = {a.own, b.own}, .conceded = {a.other, b.other}};
  }
  return pair;
}

}  // namespace sim::app
