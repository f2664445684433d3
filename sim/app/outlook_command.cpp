// foresight-sim outlook: fits the value of the ball's place to games of equal teams.
#include <cstdio>

#include "sim/app/commands.h"
#include "sim/app/progress.h"
#include "sim/contest/series.h"
#include "sim/foresight/outlook.h"
#include "sim/io/outlook.h"
#include "sim/match/play.h"
#include "sim/referee/referee.h"

namespace sim::app {
namespace {

using foresight::Outlook;

constexpr Tick kApart = ticks(5);                       // time between two counted moments
constexpr Tick kReach = ticks(60);                      // goals count this long after a moment
constexpr std::uint64_t kFirstOutlookSeed = 1'000'001;  // seeds that comparisons do not begin with

/// The moments of games by the ball's place, and the goals after them.
struct Moments {
  double counts[Outlook::kZones][2] = {};
  double goals[Outlook::kZones][2] = {};

  void add(foresight::Place place, int difference) {
    ++counts[place.zone][place.touch];
    goals[place.zone][place.touch] += difference;
  }
  void add(const Moments& other) {
    for (int zone = 0; zone < Outlook::kZones; ++zone)
      for (const int touch : {0, 1}) {
        counts[zone][touch] += other.counts[zone][touch];
        goals[zone][touch] += other.goals[zone][touch];
      }
  }
};

/// A moment whose time for goals has not passed yet.
struct Open {
  Tick tick;
  foresight::Place home;
  foresight::Place away;
  int difference;  // goals of home minus away, at the moment
};

Moments moments_of(const Params& params, std::uint64_t seed) {
  Moments moments;
  std::vector<Open> open;
  referee::Events events;
  State state = begin(params, {.seed = seed}, events);
  const auto difference = [&] { return state.book.score[0] - state.book.score[1]; };
  play(
      params, state,
      [&](const State& now) {
        while (!open.empty() && now.world.tick - open.front().tick >= kReach) {
          const Open& moment = open.front();
          moments.add(moment.home, difference() - moment.difference);
          moments.add(moment.away, moment.difference - difference());
          open.erase(open.begin());
        }
        const float left = referee::left_of_half(params.rules, now.book);
        if (now.world.tick % kApart == 0 && referee::in_play(now.book) && left > age(kReach, 0))
          open.push_back({now.world.tick, foresight::place_of(params.rules.field, now, Side::home),
                          foresight::place_of(params.rules.field, now, Side::away), difference()});
        return false;
      },
      [](const referee::Event&) {});
  return moments;
}

/// Returns the means of both sides together: a gain of one side is a loss of the other.
Outlook outlook_of(const Moments& moments) {
  Outlook outlook;
  for (int zone = 0; zone < Outlook::kZones; ++zone) {
    const int across = Outlook::kZones - 1 - zone;
    const double count = moments.counts[zone][0] + moments.counts[across][1];
    if (count == 0) continue;
    const auto worth = static_cast<float>((moments.goals[zone][0] - moments.goals[across][1]) / count);
    outlook.worth[zone][0] = worth;
    outlook.worth[across][1] = -worth;
  }
  return outlook;
}

class OutlookCommand final : public Command {
 public:
  explicit OutlookCommand(CLI::App& app)
      : Command(app.add_subcommand("outlook", "fit the value of the ball's place, for sim/data/outlooks")) {
    choice_.add_to(options());
    options().add_option("--games", games_, "number of games")->check(CLI::Range(1, 1'000'000))->capture_default_str();
  }

  int run() override {
    const io::Matchup choice = choice_.choice();
    const auto prepared = io::prepare(choice);
    if (!prepared) return fail(prepared.error());
    std::vector<Moments> games(static_cast<std::size_t>(games_));
    {
      ProgressBar progress("playing", static_cast<std::uint64_t>(games_));
      contest::for_each_game(
          games_, contest::threads_for(games_),
          [&](int game) {
            games[static_cast<std::size_t>(game)] =
                moments_of(prepared->params, kFirstOutlookSeed + static_cast<std::uint64_t>(game));
          },
          [&](int done) { progress.at(static_cast<std::uint64_t>(done)); });
    }
    Moments all;
    for (const Moments& game : games) all.add(game);
    const std::string about =
        "[goals] scored less conceded in the next 60 s, by the eighth of the field's length that the "
        "ball is in, from the own goal line, and whose touch was the last: own, others'. Means over " +
        std::to_string(games_) + " games of " + choice.strategies[0] + " against " + choice.strategies[1] +
        ", models " + choice.models[0] + ": foresight-sim outlook";
    std::fputs(io::print_outlook(outlook_of(all), choice.rules, about).c_str(), stdout);
    return kDone;
  }

 private:
  ChoiceOptions choice_;
  int games_ = 1000;
};

}  // namespace

std::unique_ptr<Command> outlook_command(CLI::App& app) { return std::make_unique<OutlookCommand>(app); }

}  // namespace sim::app
