#include "sim/learn/arena.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "robot/core/json_library.h"
#include "sim/drills/trials.h"
#include "sim/io/matchup.h"
#include "sim/io/strategy.h"
#include "sim/learn/layer.h"
#include "sim/match/hash.h"
#include "sim/match/play.h"

namespace sim::learn {
namespace {

using io::Json;
using robot::Result;

constexpr int kAttemptsAGame = 4;  // seeds of a drill for each whole game
constexpr int kChunk = 64;         // attempts, or games, of one task

/// Returns the conditions of a world: always the models as they are.
std::vector<contest::Conditions> conditions_of(const World& world) {
  std::vector<contest::Conditions> all;
  if (world.robust) all = contest::robust_conditions(false);
  all.insert(all.begin(), contest::Conditions{});
  return all;
}

/// Adds the parameters of a game under each condition.
Result<void> add_params(const io::Matchup& game, const World& world, Arena::Exercise& exercise) {
  const auto prepared = io::prepare(game);
  if (!prepared) return prepared.failure();
  for (const auto& behaviour : prepared->behaviours) exercise.held.push_back(behaviour);
  for (const contest::Conditions& conditions : conditions_of(world)) {
    Params params = prepared->params;
    contest::put_upon(conditions, nullptr, params);
    exercise.params.push_back(std::move(params));
  }
  return {};
}

Result<Arena::Exercise> game_of(const World& world) {
  Arena::Exercise exercise{.name = kGame, .is_game = true, .drill = nullptr, .starts = {}, .params = {}, .held = {}};
  for (const std::string& opponent : world.opponents) {
    const io::Matchup game{
        .rules = world.rules, .strategies = {opponent, opponent}, .models = {world.models, world.models}};
    if (auto added = add_params(game, world, exercise); !added) return added.failure();
  }
  return exercise;
}

Result<Arena::Exercise> drill_of(const std::string& name, const World& world) {
  auto drill = drills::load_drill(name);
  if (!drill) return drill.failure();
  Arena::Exercise exercise{.name = name,
                           .drill = std::make_shared<const drills::Drill>(*std::move(drill)),
                           .starts = {},
                           .params = {},
                           .held = {}};
  if (auto added = add_params(exercise.drill->game, world, exercise); !added) return added.failure();
  auto starts = drills::Starts::prepare(*exercise.drill, exercise.params.front());
  if (!starts) return starts.failure();
  exercise.starts = *std::move(starts);
  return exercise;
}

/// Plays the attempts of a task, those with the same parameters side by side.
void play_drill(const Arena::Exercise& exercise, const agent::Behaviour& strategy, Arena::Task& task) {
  const std::size_t variants = exercise.params.size();
  for (std::size_t variant = 0; variant < variants; ++variant) {
    Params params = exercise.params[variant];
    params.teams[0].behaviour = &strategy;
    const std::size_t from = begin_of_part(task.scores.size(), variant, variants),
                      to = begin_of_part(task.scores.size(), variant + 1, variants);
    std::vector<drills::Ended> ended(to - from);
    drills::play_attempts(*exercise.drill, *exercise.starts, params, task.seed + from, ended);
    for (std::size_t i = from; i < to; ++i) task.scores[i] = {ended[i - from].score, ended[i - from].succeeded};
  }
}

/// Plays whole games: half of them at home, half away.
void play_matches(const Arena::Exercise& exercise, const agent::Behaviour& strategy, Arena::Task& task) {
  const std::size_t variants = 2 * exercise.params.size();
  for (std::size_t variant = 0; variant < variants; ++variant) {
    const auto own = variant % 2;
    Params params = exercise.params[variant / 2];
    params.teams[own].behaviour = &strategy;
    std::vector<RandomKey> keys;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < task.scores.size(); ++i)
      if ((task.seed + i) % variants == variant) keys.push_back({task.seed + i}), places.push_back(i);
    const std::vector<sim::Result> results = play_games(params, keys);
    for (std::size_t i = 0; i < results.size(); ++i) {
      const int difference = results[i].score[own] - results[i].score[1 - own];
      task.scores[places[i]] = {static_cast<float>(difference), difference > 0};
    }
  }
}

}  // namespace

std::size_t variant_of(int attempt, int attempts, std::size_t variants) {
  const auto place = static_cast<std::size_t>(attempt % kChunk);
  const auto size = static_cast<std::size_t>(std::min(kChunk, attempts - (attempt - attempt % kChunk)));
  std::size_t variant = 0;
  while (begin_of_part(size, variant + 1, variants) <= place) ++variant;
  return variant;
}

Result<Arena> Arena::prepare(const std::vector<std::pair<std::string, double>>& exercises, const World& world,
                             Ledger& ledger) {
  Arena arena(ledger, world.threads);
  Hash hash;
  for (const auto& [name, weight] : exercises) {
    auto exercise = name == kGame ? game_of(world) : drill_of(name, world);
    if (!exercise) return exercise.failure();
    exercise->weight = weight;
    arena.exercises_.push_back(*std::move(exercise));
  }
  hash.add(hash_of_text(world.rules + "\n" + world.models + (world.robust ? "\nrobust" : "")));
  for (const std::string& opponent : world.opponents) hash.add(hash_of_text(opponent));
  arena.world_hash_ = hash.value();
  return arena;
}

int Arena::attempts_of(std::size_t exercise, int count) const {
  return exercises_[exercise].is_game ? (count + kAttemptsAGame - 1) / kAttemptsAGame : count;
}

float Arena::diagonal() const {
  float longest = 0;
  for (const Exercise& exercise : exercises_) {
    const field::Field& field = exercise.params.front().rules.field;
    longest = std::max(longest, std::sqrt(field.length * field.length + field.width * field.width));
  }
  return longest;
}

double Arena::cost_of(int count) const {
  double seconds = 0;
  for (std::size_t i = 0; i < exercises_.size(); ++i) {
    const Exercise& exercise = exercises_[i];
    const double longest =
        exercise.is_game ? 1500 : 0.6 * kTickDuration * static_cast<double>(exercise.drill->duration);
    seconds += longest * attempts_of(i, count);
  }
  return seconds;
}

Result<std::vector<Scores>> Arena::play(std::span<const Json> strategies, std::uint64_t first_seed, int count) {
  std::vector<std::unique_ptr<agent::TreeBehaviour>> trees;
  std::vector<Scores> all;
  std::vector<Task> tasks;
  for (const Json& strategy : strategies) {
    const std::string text = strategy.dump();
    auto tree = io::parse_strategy(text, "learned strategy");
    if (!tree) return tree.failure();
    trees.push_back(std::make_unique<agent::TreeBehaviour>(*std::move(tree)));
    add_tasks(trees.size() - 1, hash_of_text(text), first_seed, count, tasks);
    Scores& scores = all.emplace_back();
    for (std::size_t e = 0; e < exercises_.size(); ++e)
      scores.emplace_back(static_cast<std::size_t>(attempts_of(e, count)));
  }
  if (auto played = play_tasks(trees, tasks); !played) return played.failure();
  for (const Task& task : tasks) std::ranges::copy(task.scores, all[task.strategy][task.exercise].begin() + task.from);
  return all;
}

void Arena::add_tasks(std::size_t strategy, std::uint64_t hash, std::uint64_t first_seed, int count,
                      std::vector<Task>& tasks) const {
  for (std::size_t e = 0; e < exercises_.size(); ++e) {
    const int attempts = attempts_of(e, count);
    for (int from = 0; from < attempts; from += kChunk) {
      Task task{.strategy = strategy,
                .exercise = e,
                .from = from,
                .seed = first_seed + static_cast<std::uint64_t>(from),
                .scores = std::vector<Score>(static_cast<std::size_t>(std::min(kChunk, attempts - from)))};
      Hash key;
      for (const std::uint64_t part : {world_hash_, hash, hash_of_text(exercises_[e].name), task.seed,
                                       static_cast<std::uint64_t>(task.scores.size())})
        key.add(part);
      task.key = key.value();
      tasks.push_back(std::move(task));
    }
  }
}

bool Arena::take_known(Task& task) const {
  const std::vector<Score>* const known = ledger_->find(task.key);
  if (!known || known->size() != task.scores.size()) return false;
  task.scores = *known;
  return true;
}

Result<void> Arena::play_tasks(const std::vector<std::unique_ptr<agent::TreeBehaviour>>& trees,
                               std::vector<Task>& tasks) {
  std::vector<Task*> open;
  for (const std::size_t place : order_of(tasks.size(), ledger_->share()))
    if (!take_known(tasks[place])) open.push_back(&tasks[place]);
  std::mutex lock;  // of the ledger
  contest::Problem problem;
  contest::for_each_game(static_cast<int>(open.size()), threads_, [&](int index) {
    Task& task = *open[static_cast<std::size_t>(index)];
    if (problem.is_known()) return;
    {
      const std::lock_guard guard(lock);
      if (auto read = ledger_->refresh(); !read) return problem.tell(read.error());
      if (take_known(task)) return;  // another process was quicker
    }
    const agent::Behaviour& strategy = *trees[task.strategy];
    const Exercise& exercise = exercises_[task.exercise];
    exercise.is_game ? play_matches(exercise, strategy, task) : play_drill(exercise, strategy, task);
    // at once, so that a kill loses no more than the tasks that are played
    const std::lock_guard guard(lock);
    if (auto added = ledger_->add(task.key, task.scores); !added) problem.tell(added.error());
  });
  if (problem.is_known()) return robot::Error{problem.text()};
  return {};
}

template <class Value>
contest::Mean Arena::weighted(Value&& value) const {
  contest::Mean sum;
  double weights = 0, variance = 0;
  for (std::size_t e = 0; e < exercises_.size(); ++e) {
    const double weight = exercises_[e].weight;
    const contest::Mean mean = contest::mean_of(value(e));
    sum.mean += weight * mean.mean;
    variance += weight * weight * mean.error * mean.error;
    weights += weight;
  }
  return {.mean = sum.mean / weights, .error = std::sqrt(variance) / weights};
}

double Arena::value_of(const Scores& scores) const {
  return weighted([&](std::size_t e) {
           std::vector<double> points;
           for (const Score& score : scores[e]) points.push_back(static_cast<double>(score.points));
           return points;
         })
      .mean;
}

contest::Mean Arena::gain_of(const Scores& a, const Scores& b) const {
  return weighted([&](std::size_t e) {
    std::vector<double> gains;
    for (std::size_t i = 0; i < a[e].size(); ++i)
      gains.push_back(static_cast<double>(b[e][i].points) - static_cast<double>(a[e][i].points));
    return gains;
  });
}

int successes_in(const std::vector<Score>& scores) {
  return static_cast<int>(std::ranges::count_if(scores, &Score::won));
}

contest::Mean success_gain(const std::vector<Score>& a, const std::vector<Score>& b) {
  std::vector<double> gains;
  for (std::size_t i = 0; i < a.size(); ++i) gains.push_back((b[i].won ? 1. : 0.) - (a[i].won ? 1. : 0.));
  return contest::mean_of(gains);
}

}  // namespace sim::learn
