#include "sim/environment/environment.h"

#include <algorithm>
#include <numeric>

#include "sim/environment/description.h"
#include "sim/match/snapshot.h"
#include "sim/match/step.h"
#include "sim/referee/referee.h"

namespace sim::environment {

using robot::Error;
using robot::Result;

namespace {

/// Returns whether the robot takes part in the game, now or when its penalty is over.
bool takes_part(const State& state, int robot) {
  return on_field(state.world.bodies[robot]) || state.book.penalised_until[robot] != kNever;
}

}  // namespace

/// The behaviour of a side whose robots obey actions, except those that are no agents.
class Environment::Puppets final : public agent::Behaviour {
 public:
  Puppets(Environment& games, Side side, const agent::Behaviour& strategy)
      : games_(games), side_(side), strategy_(strategy) {}

  const std::string& name() const override { return strategy_.name(); }

  motion::Command decide(const agent::Surroundings& surroundings, const agent::Game& game,
                         const agent::Beliefs& beliefs, Tick now, agent::Mind& mind,
                         agent::Trace* trace) const override {
    const int robot = robot_of(side_, game.player);
    if (!games_.is_agent(robot)) return strategy_.decide(surroundings, game, beliefs, now, mind, trace);
    const agent::Tree& tree = games_.options_.frame.tree;
    const agent::View view(surroundings, tree.settings, game, beliefs, now, mind);
    const std::size_t row = row_of(robot, mind);
    const bool plays = agent::plays(game);
    if (plays) agent::prepare(view, mind);
    games_.options_.frame.columns.observe(view, games_.observation(row));
    if (!plays) return agent::wait(view, mind, trace);
    return obey(games_.options_.actions, tree, games_.action(row), view, mind);
  }

 private:
  /// Finds the game by the address of its memory: no other argument of a decision differs between games.
  std::size_t row_of(int robot, const agent::Mind& mind) const {
    const auto* const first = reinterpret_cast<const char*>(games_.states_.data());
    const auto game = static_cast<std::size_t>(reinterpret_cast<const char*>(&mind) - first) / sizeof(State);
    return game * games_.agents_.size() + static_cast<std::size_t>(games_.agent_of_[robot]);
  }

  Environment& games_;
  const Side side_;
  const agent::Behaviour& strategy_;
};

Result<std::unique_ptr<Environment>> Environment::open(std::string_view text) {
  Result<Options> options = read_options(text);
  if (!options) return options.failure();
  Result<io::PreparedGame> game = io::prepare(options->drill.game);
  if (!game) return game.failure();
  std::unique_ptr<Environment> made(new Environment(*std::move(options), *std::move(game)));
  if (const auto prepared = made->prepare(); !prepared) return prepared.failure();
  return made;
}

Environment::Environment(Options options, io::PreparedGame game)
    : options_(std::move(options)),
      game_(std::move(game)),
      states_(static_cast<std::size_t>(options_.games)),
      begun_(states_.size()),
      attempts_(states_.size()),
      episodes_(states_.size()) {}

Environment::~Environment() = default;

Result<void> Environment::prepare() {
  Params& params = game_.params;
  if (options_.has_start) {
    auto starts = drills::Starts::prepare(options_.drill, params);
    if (!starts) return starts.failure();
    starts_ = *std::move(starts);
  }
  begin(0, 0);
  std::ranges::fill(agent_of_, -1);
  for_each_robot(params.rules.players, [&](int robot) {
    if (!options_.controlled[static_cast<int>(side_of(robot))] || !takes_part(states_[0], robot)) return;
    agent_of_[robot] = agents();
    agents_.push_back(robot);
  });
  if (agents_.empty()) return Error{"environment: no robot of the controlled side takes part in this drill"};
  for (const Side side : {Side::home, Side::away}) {
    const auto index = static_cast<std::size_t>(side);
    if (!options_.controlled[index]) continue;
    puppets_[index] = std::make_unique<Puppets>(*this, side, *game_.behaviours[index]);
    params.teams[index].behaviour = puppets_[index].get();
  }

  const std::size_t rows = states_.size() * agents_.size();
  arrays_.observations.resize(rows * static_cast<std::size_t>(columns()));
  arrays_.actions.resize(rows * static_cast<std::size_t>(width()));
  arrays_.rewards.resize(rows);
  arrays_.terminated.resize(rows);
  arrays_.truncated.resize(rows);
  arrays_.active.resize(rows);
  arrays_.succeeded.resize(states_.size());
  arrays_.seeds.resize(states_.size());
  std::vector<std::uint64_t> seeds(states_.size());
  std::iota(seeds.begin(), seeds.end(), 0);
  reset(seeds);
  about_ = description_of(options_, agents_);
  return {};
}

void Environment::begin(int game, std::uint64_t seed) {
  const auto index = static_cast<std::size_t>(game);
  referee::Events events;
  State& state = states_[index];
  state = starts_ ? starts_->draw(game_.params, {seed}) : sim::begin(game_.params, {seed}, events);
  begun_[index] = state;
  attempts_[index].emplace(options_.drill, begun_[index]);
  episodes_[index].ended = false;
  if (!arrays_.seeds.empty()) arrays_.seeds[index] = seed;
}

void Environment::reset(std::span<const std::uint64_t> seeds, std::span<const std::uint8_t> which) {
  for (int game = 0; game < games(); ++game) {
    const auto index = static_cast<std::size_t>(game);
    if (!which.empty() && which[index] == 0) continue;
    episodes_[index] = {.first = seeds[index]};
    show_start(game, seeds[index]);
  }
}

/// Begins the episode with that seed, and fills the game's rows.
void Environment::show_start(int game, std::uint64_t seed) {
  const auto index = static_cast<std::size_t>(game), row = index * agents_.size();
  begin(game, seed);
  std::fill_n(arrays_.rewards.data() + row, agents_.size(), 0.f);
  std::fill_n(arrays_.terminated.data() + row, agents_.size(), std::uint8_t{0});
  std::fill_n(arrays_.truncated.data() + row, agents_.size(), std::uint8_t{0});
  arrays_.succeeded[index] = 0;
  observe(game);
  note_active(game);
}

/// Begins the next episode of a game that has ended.
void Environment::restart(int game) {
  Episode& episode = episodes_[static_cast<std::size_t>(game)];
  const auto words = draw({episode.first}, kNobody, Draw::episode, ++episode.number);
  show_start(game, std::uint64_t{words[0]} << 32 | words[1]);
}

Result<void> Environment::check_actions() const {
  const auto wide = static_cast<std::size_t>(width());
  for (std::size_t row = 0; row < arrays_.rewards.size(); ++row) {
    // a game that has ended plays without actions
    if (episodes_[row / agents_.size()].ended) continue;
    const std::string problem = problem_of(options_.actions, options_.frame.tree, arrays_.actions.data() + row * wide);
    if (!problem.empty())
      return Error{"environment: the action of " + name_of_agent(agents_[row % agents_.size()]) + " in game " +
                   std::to_string(row / agents_.size()) + " " + problem};
  }
  return {};
}

Result<void> Environment::step() {
  if (auto checked = check_actions(); !checked) return checked;
  std::ranges::fill(arrays_.rewards, 0.f);
  constexpr int kMost = static_cast<int>(kTogether);
  for (int first = 0; first < games(); first += kMost) play(first, std::min(kMost, games() - first));
  return {};
}

/// Plays one step of some games that follow one another.
void Environment::play(int first, int count) {
  State* running[kTogether];
  int number[kTogether], played[kTogether], left = 0;
  for (int game = first; game < first + count; ++game) {
    const auto index = static_cast<std::size_t>(game);
    if (!episodes_[index].ended)
      running[left] = &states_[index], number[left++] = game;
    else if (options_.restarts)
      restart(game);
  }
  const int* const end = std::copy_n(number, left, played);

  referee::Events events[kTogether];
  for (int tick = 0; tick < options_.ticks && left > 0; ++tick) {
    const auto games_left = static_cast<std::size_t>(left);
    step_many(game_.params, std::span(running, games_left), std::span(events, games_left));
    // a game that has ended leaves the others
    int still = 0;
    for (int i = 0; i < left; ++i) {
      judge(number[i], events[i]);
      if (!episodes_[static_cast<std::size_t>(number[i])].ended)
        running[still] = running[i], number[still++] = number[i];
    }
    left = still;
  }
  std::for_each(static_cast<const int*>(played), end, [&](int game) { note_active(game); });
}

/// Adds the points of the last tick, and notes the end of the episode.
void Environment::judge(int game, const referee::Events& events) {
  const auto index = static_cast<std::size_t>(game);
  drills::Attempt& attempt = *attempts_[index];
  const drills::Outcome outcome = attempt.see(states_[index], events);
  const bool ended = outcome != drills::Outcome::running, late = outcome == drills::Outcome::time_over;
  for (std::size_t agent = 0; agent < agents_.size(); ++agent) {
    const std::size_t row = index * agents_.size() + agent;
    arrays_.rewards[row] += side_of(agents_[agent]) == Side::home ? attempt.points() : -attempt.points();
    arrays_.terminated[row] = ended && !late;
    arrays_.truncated[row] = late;
  }
  arrays_.succeeded[index] = attempt.succeeded(outcome);
  episodes_[index].ended = ended;
}

/// Writes the observations of agents that have had no turn yet.
void Environment::observe(int game) {
  const auto index = static_cast<std::size_t>(game);
  const State& state = states_[index];
  const agent::Frame& frame = options_.frame;
  for (std::size_t agent = 0; agent < agents_.size(); ++agent) {
    const int robot = agents_[agent];
    const agent::Surroundings around{&game_.params.rules, &models_of(game_.params, robot).motion};
    const agent::Game told = referee::game_for(game_.params.rules, state.world, state.book, robot);
    const Robot& self = state.robots[robot];
    const agent::View view(around, frame.tree.settings, told, self.beliefs, state.world.tick, self.mind);
    frame.columns.observe(view, observation(index * agents_.size() + agent));
  }
}

/// Notes which agents are in play.
void Environment::note_active(int game) {
  const auto index = static_cast<std::size_t>(game);
  const State& state = states_[index];
  for (std::size_t agent = 0; agent < agents_.size(); ++agent) {
    const int robot = agents_[agent];
    const agent::Game told = referee::game_for(game_.params.rules, state.world, state.book, robot);
    arrays_.active[index * agents_.size() + agent] =
        agent::plays(told) && on_field(state.world.bodies[robot]) && !episodes_[index].ended;
  }
}

Result<void> Environment::check() const {
  for (int game = 0; game < games(); ++game) {
    const Restored restored = restore(snapshot_of(state(game)));
    if (!restored.state) return Error{"environment: game " + std::to_string(game) + ": " + restored.refusal};
  }
  return {};
}

}  // namespace sim::environment
