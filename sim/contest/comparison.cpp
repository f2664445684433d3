#include "sim/contest/comparison.h"

#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "sim/contest/run_folder.h"
#include "sim/io/models.h"
#include "sim/io/source.h"
#include "sim/match/hash.h"
#include "sim/match/play.h"

namespace sim::contest {
namespace {

using robot::Error;
using robot::Result;
using Kind = referee::Event::Kind;

constexpr int kProbeSteps = 3000;
constexpr std::uint64_t kOtherLuck = std::uint64_t{1} << 40;  // offset to seeds that no pair uses

/// Returns a hash of the text of the file that a name refers to, or 0 if the name is no file.
std::uint64_t content_of(const std::string& name) {
  if (guest::is_guest(name)) return guest::content_of(name);
  const std::string path = name.substr(0, name.find_first_of(",:"));
  if (!io::is_path(path)) return 0;
  const auto text = robot::read_file(path, io::kMaxFileBytes);
  Hash hash;
  if (text)
    for (const char c : *text) hash.add(static_cast<unsigned char>(c));
  return hash.value();
}

}  // namespace

const char* name_of(Metric metric) {
  switch (metric) {
    case Metric::goals: return "goals";
    case Metric::first_goal: return "first_goal";
    case Metric::conceded: return "conceded";
    case Metric::score_within: return "score_within";
    case Metric::ball_advance: return "ball_advance";
  }
  return "";
}

Result<void> Comparison::seat(std::vector<Seat>& seats, const std::string& judged, const std::string& against,
                              Side side, bool changed) {
  const bool home = side == Side::home;
  LineupChoice choice{.game = {.rules = choice_.rules,
                               .strategies = {home ? judged : against, home ? against : judged},
                               .models = {choice_.models, choice_.models},
                               .players = choice_.players,
                               .pace = choice_.pace}};
  if (changed) choice.changed = choice_.changed, choice.rest[static_cast<int>(side)] = choice_.a;
  auto lineup = Lineup::prepare(choice);
  if (!lineup) return lineup.failure();
  const Side opponent = other(side);
  put_upon(choice_.conditions, choice_.opponent.empty() ? nullptr : &opponent, lineup->params());
  auto openings = Openings::read(choice_.situation, choice_.fuzz, lineup->params());
  if (!openings) return openings.failure();
  seats.push_back({*std::move(lineup), side, *std::move(openings)});
  return {};
}

Result<std::string> Comparison::probe() const {
  Hash hash;
  for (const std::vector<Seat>* seats : {&a_, &b_})
    for (const Seat& seat : *seats) {
      referee::Events events;
      const Cast cast(seat.lineup, choice_.seed);
      State state = begin(cast.params(), {.seed = choice_.seed}, events);
      for (int i = 0; i < kProbeSteps && !cast.failed(); ++i) step(cast.params(), state, events);
      if (cast.failed()) return Error{cast.problem()};
      hash.add(hash_of(state));
    }
  return hex(hash.value());
}

Result<Comparison> Comparison::prepare(const ComparisonChoice& choice) {
  if (choice.metric == Metric::conceded && choice.opponent.empty())
    return Error{"metric 'conceded' needs --vs: between A and B alone it equals 'goals'"};
  if ((choice.metric == Metric::score_within || choice.metric == Metric::ball_advance) && choice.seconds <= 0)
    return Error{"metric '" + std::string(name_of(choice.metric)) + "' needs a time, such as score_within:30s"};
  if (choice.fuzz && choice.situation.empty()) return Error{"--fuzz needs --from, the situation that is varied"};
  Comparison made;
  made.choice_ = choice;
  // the first game of a pair has B away, the second at home
  for (const Side side : {Side::away, Side::home}) {
    if (!choice.opponent.empty())
      if (auto seated = made.seat(made.a_, choice.a, choice.opponent, side, false); !seated) return seated.failure();
    const std::string& against = choice.opponent.empty() ? choice.a : choice.opponent;
    if (auto seated = made.seat(made.b_, choice.b, against, side, choice.changed > 0); !seated) return seated.failure();
  }
  const auto build = made.probe();
  if (!build) return build.failure();

  nlohmann::ordered_json json = {{"format", RunFolder::kFormat},
                                 {"a", choice.a},
                                 {"b", choice.b},
                                 {"vs", choice.opponent},
                                 {"rules", choice.rules},
                                 {"models", choice.models},
                                 {"players", choice.players},
                                 {"changed", choice.changed},
                                 {"every_tick", choice.pace == Pace::every_tick},
                                 {"situation", choice.situation},
                                 {"fuzz", choice.fuzz},
                                 {"seconds", choice.seconds},
                                 {"metric", name_of(choice.metric)},
                                 {"conditions", choice.conditions.name},
                                 {"seed", choice.seed},
                                 {"unpaired", choice.unpaired},
                                 {"version", FORESIGHT_VERSION},
                                 {"build", *build}};
  std::vector<std::string> files = io::names_of_models(choice.models);
  const std::vector<std::string> falls = io::names_of_falls(choice.models);
  files.insert(files.end(), falls.begin(), falls.end());
  files.insert(files.end(), {choice.a, choice.b, choice.opponent, choice.rules});
  for (const std::string& file : files)
    if (const std::uint64_t content = content_of(file)) json["files"][file] = hex(content);
  if (!choice.situation.empty()) json["files"][choice.situation] = hex(made.b_[0].openings.content());
  made.specification_ = json.dump();
  return made;
}

/// One game of a pair, from its opening to its score.
class Comparison::Game {
 public:
  State state;

  Game(const ComparisonChoice& choice, const Seat& seat, const Start& start, const Cast& cast)
      : choice_(&choice), side_(seat.side), cast_(&cast) {
    referee::Events events;
    state = seat.openings.begin(cast.params(), start, events);
    for (const int index : {0, 1}) before_[index] = state.book.score[index];
    if (choice.seconds > 0) end_ = state.world.tick + ticks(static_cast<float>(choice.seconds));
    sign_ = attack_sign(state.world, side_);
    ball_from_ = sign_ * state.world.ball.position.x;
  }

  bool goes_on() const {
    const bool first_ends = choice_->metric == Metric::first_goal || choice_->metric == Metric::ball_advance;
    return state.world.tick < end_ && !(first_ && first_ends) && !cast_->failed();
  }

  void see(const referee::Events& events) {
    for (const referee::Event& event : events) {
      happened_.add(static_cast<std::uint64_t>(event.kind)), happened_.add(event.tick);
      if (event.kind == Kind::goal && !first_) first_ = event.side;
    }
  }

  Score score() {
    happened_.add(hash_of_game(state));
    Score score{.own = scored(side_), .other = scored(other(side_)), .hash = happened_.value()};
    const int winner = !first_ ? 0 : *first_ == side_ ? 1 : -1;
    switch (choice_->metric) {
      case Metric::goals: score.value = score.own - score.other; break;
      case Metric::first_goal: score.value = winner; break;
      case Metric::conceded: score.value = -score.other; break;
      case Metric::score_within: score.value = score.own > 0 ? 1 : 0; break;
      case Metric::ball_advance: {
        // after a goal the ball is back in the middle at once, so its way ends at the goal line
        const float line = static_cast<float>(winner) * cast_->params().rules.field.length / 2;
        const float ball_to = winner != 0 ? line : sign_ * state.world.ball.position.x;
        score.value = static_cast<int>(std::lround(100 * (ball_to - ball_from_)));
      }
    }
    return score;
  }

 private:
  int scored(Side side) const {
    const int index = static_cast<int>(side);
    return state.book.score[index] - before_[index];
  }

  const ComparisonChoice* choice_;
  Side side_;
  const Cast* cast_;
  Hash happened_;
  int before_[2] = {};
  Tick end_ = kNever;
  float sign_ = 1, ball_from_ = 0;
  std::optional<Side> first_;
};

Result<Comparison::Scores> Comparison::play(const Seat& seat, std::span<const Start> starts) const {
  // a behaviour from outside plays one game, trees play many
  const bool alone = seat.lineup.has_guest(Side::home) || seat.lineup.has_guest(Side::away);
  const std::size_t together = alone ? 1 : starts.size();
  Scores scores;
  for (std::size_t begin = 0; begin < starts.size(); begin += together) {
    const Cast cast(seat.lineup, starts[begin].seed);
    std::vector<Game> games;
    for (const Start& start : starts.subspan(begin, together)) games.emplace_back(choice_, seat, start, cast);
    std::size_t begun = 0;
    play_many<Game>(cast.params(), kTogether, [&](Game*) { return begun < games.size() ? &games[begun++] : nullptr; });
    if (cast.failed()) return Error{cast.problem()};
    for (Game& game : games) scores.games.push_back(game.score());
    scores.cost[0].add(cast.cost(seat.side));
    scores.cost[1].add(cast.cost(other(seat.side)));
  }
  return scores;
}

Start Comparison::start_of(std::int64_t number, int place) const {
  const bool other_luck = choice_.unpaired && place == 1;
  return {.seed = seed_of(number) + (other_luck ? kOtherLuck : 0), .moment = seed_of(number), .turned = other_luck};
}

compare::Pair Comparison::pair_of(const Scores (&a)[2], const Scores (&b)[2], std::size_t number) const {
  compare::Pair pair;
  Hash happened;
  std::uint64_t of_b[2] = {}, of_a[2] = {};
  for (const int place : {0, 1}) {
    const Score& of = b[place].games[number];
    Score against{.own = of.other, .other = of.own};  // against each other: the same game from A's side
    int gain = of.value;
    if (!a_.empty()) {
      against = a[place].games[number];
      gain = of.value - against.value;
    } else if (choice_.metric == Metric::score_within) {
      gain = of.value - (of.other > 0 ? 1 : 0);
    }
    // against each other: the game in which A has B's seat is the other one of the pair
    of_b[place] = of.hash, of_a[a_.empty() ? 1 - place : place] = a_.empty() ? of.hash : against.hash;
    happened.add(of.hash), happened.add(against.hash);
    pair.games[place] = {.gain = gain, .goals = {against.own, of.own}, .conceded = {against.other, of.other}};
  }
  pair.same = of_a[0] == of_b[0] && of_a[1] == of_b[1];
  pair.hash = happened.value();
  return pair;
}

Result<PlayedPairs> Comparison::play(std::int64_t first, std::int64_t count) const {
  PlayedPairs played;
  Scores a[2], b[2];  // by the game's place in the pair
  for (const int place : {0, 1}) {
    const auto index = static_cast<std::size_t>(place);
    std::vector<Start> starts;
    for (std::int64_t number = first; number < first + count; ++number) starts.push_back(start_of(number, place));
    auto of_b = play(b_[index], starts);
    if (!of_b) return of_b.failure();
    b[place] = *std::move(of_b);
    played.cost[1].add(b[place].cost[0]);
    if (a_.empty()) {
      played.cost[0].add(b[place].cost[1]);
      continue;
    }
    auto of_a = play(a_[index], starts);
    if (!of_a) return of_a.failure();
    a[place] = *std::move(of_a);
    played.cost[0].add(a[place].cost[0]);
  }
  for (std::int64_t i = 0; i < count; ++i) played.pairs.push_back(pair_of(a, b, static_cast<std::size_t>(i)));
  return played;
}

}  // namespace sim::contest
