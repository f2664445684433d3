#include "sim/learn/learning.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "robot/core/files.h"
#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/io/source.h"
#include "sim/io/strategy.h"
#include "sim/learn/edit.h"
#include "sim/learn/growing.h"
#include "sim/learn/tuning.h"
#include "sim/match/hash.h"

namespace sim::learn {
namespace {

using io::Json;
using robot::Error;
using robot::Result;

constexpr double kSimulatedASecond = 9000;  // [s] by one core, measured with runs of all layers
constexpr double kTuned = 0.5;              // of a layer's budget for its numbers
constexpr double kGrown = 0.3;              // for its structure
constexpr double kGuarded = 0.2;            // for whole games before and after
constexpr double kSeam = 0.5;               // budget of a seam, of a layer's
constexpr int kGenerations = 24;
constexpr std::int64_t kUnseenPairs = 300;
constexpr double kWorse = 0.2;  // [goals a game] against an unseen opponent, the tree is surely not worse by this

/// A folder for the files of a run: the one that was chosen, or one that goes with the run.
class Place {
 public:
  static Result<Place> open(const std::filesystem::path& chosen) {
    Place place;
    place.kept_ = !chosen.empty();
    std::error_code failed;
    place.path_ =
        place.kept_ ? chosen : std::filesystem::temp_directory_path(failed) / ("learn-" + std::to_string(::getpid()));
    if (!failed) std::filesystem::create_directories(place.path_, failed);
    if (failed) return Error{"run " + place.path_.string() + ": " + failed.message()};
    return place;
  }
  Place(Place&& other) noexcept : path_(std::exchange(other.path_, {})), kept_(other.kept_) {}
  Place& operator=(Place&&) = delete;
  ~Place() {
    std::error_code ignored;
    if (!kept_ && !path_.empty()) std::filesystem::remove_all(path_, ignored);
  }

  std::filesystem::path file(const std::string& name) const { return path_ / name; }
  /// Returns the folder if it is kept, or an empty path.
  std::filesystem::path kept() const { return kept_ ? path_ : std::filesystem::path(); }

 private:
  Place() = default;
  std::filesystem::path path_;
  bool kept_ = false;
};

/// Returns the hash of a description's text; of a name with changes behind commas, that of the name.
std::string hash_of_source(const char* kind, const std::string& name) {
  const Result<io::Source> source = io::find_source(kind, kind, name);
  return hex(hash_of_text(source ? source->text : name));
}

Json hashes_of(const char* kind, const std::vector<std::string>& names) {
  Json hashes = Json::object();
  for (const std::string& name : names) hashes[name] = hash_of_source(kind, name);
  return hashes;
}

/// Returns all that settles the run, as text: names, and hashes of what they stand for.
std::string specification_of(const LearnChoice& choice, const Json& start, const std::vector<Layer>& layers) {
  std::vector<std::string> drills;
  for (const Layer& layer : layers)
    for (const auto& [name, weight] : layer.exercises)
      if (name != kGame) drills.push_back(name);
  const Json json = {{"format", 4},
                     {"strategy", hex(hash_of_text(start.dump()))},
                     {"layers", hashes_of("layers", choice.layers)},
                     {"drills", hashes_of("drills", drills)},
                     {"minutes", choice.minutes},
                     {"seed", choice.seed},
                     {"rules", choice.world.rules},
                     {"models", choice.world.models},
                     {"opponents", hashes_of("strategies", choice.world.opponents)},
                     {"unseen", hashes_of("strategies", choice.unseen)},
                     {"robust", choice.world.robust},
                     {"shuffled", choice.shuffled},
                     {"wanted", choice.wanted},
                     {"most_pairs", choice.most_pairs}};
  return json.dump(2) + "\n";
}

/// Returns the sentence against an unseen opponent that the run meets, perhaps under another name; or "".
std::string met_before(const LearnChoice& choice) {
  for (const std::string& unseen : choice.unseen)
    for (const std::string& opponent : choice.world.opponents)
      if (hash_of_source("strategies", unseen) == hash_of_source("strategies", opponent))
        return robot::formatted("the gate's opponents must be others than those of practice, got '%s', which is '%s'",
                                unseen.c_str(), opponent.c_str());
  return "";
}

/// Begins the run in its folder, or goes on with it, perhaps beside other processes.
Result<void> claim(const std::filesystem::path& file, const std::string& specification) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return robot::replace_file(file, specification);
  const auto there = robot::read_file(file, 1 << 20);
  if (!there) return there.failure();
  if (*there == specification) return {};
  return Error{file.string() +
               ": expected the same strategy, layers, drills, budget, seed and opponents as before, got others"};
}

/// The run.
class Learning {
 public:
  Learning(const LearnChoice& choice, Json start, std::vector<Layer> layers, Ledger& ledger, const Tell& tell)
      : choice_(choice), layers_(std::move(layers)), ledger_(ledger), tell_(tell), seeds_(choice.seed) {
    course_.start = std::move(start);
    course_.learned = course_.start;
  }

  Result<Course> run(const Place& place) {
    std::vector<Layer> lessons = layers_;
    for (std::size_t i = 1; i < layers_.size(); ++i) lessons.push_back(seam_of(layers_[i - 1], layers_[i]));
    const double shares = static_cast<double>(layers_.size()) + kSeam * static_cast<double>(layers_.size() - 1);
    const double each = Budget::of_minutes(choice_.minutes).seconds / shares;
    count_ = lessons.size();
    for (number_ = 0; number_ < count_; ++number_)
      if (auto learned = lesson(lessons[number_], number_ < layers_.size() ? each : kSeam * each); !learned)
        return learned.failure();
    course_.learned = without_unused(std::move(course_.learned));
    course_.learned["name"] = choice_.name;
    course_.learned["about"] = robot::formatted("learned from %s by foresight-sim learn: budget %g min, seed %llu",
                                                course_.start.value("name", "a tree").c_str(), choice_.minutes,
                                                static_cast<unsigned long long>(choice_.seed));
    course_.changes = merged(course_.changes);
    course_.first_test_seed = seeds_.first_of(Purpose::test);
    if (course_.changes.empty()) return std::move(course_);
    if (auto passed = gate(place); !passed) return passed.failure();
    return std::move(course_);
  }

 private:
  Result<void> lesson(const Layer& layer, double seconds) {
    auto arena = Arena::prepare(layer.exercises, choice_.world, ledger_);
    if (!arena) return arena.failure();
    const Json before = course_.learned;
    Lesson lesson{.name = layer.name, .about = layer.about, .changes = {}, .notes = {}, .curve = {}, .successes = {}};
    const Practice practice{*arena, seeds_,
                            [&](const std::string& activity, double done) {
                              tell_(layer.name + ": " + activity,
                                    (static_cast<double>(number_) + done) / static_cast<double>(count_));
                            },
                            choice_.shuffled};
    if (auto tuned = take(tune(course_.learned, layer, tuning_plan(layer, *arena, seconds),
                               seeds_.first_of(Purpose::training) + number_, practice),
                          lesson);
        !tuned)
      return tuned;
    if (!layer.actions.empty())
      if (auto grown = take(grow(course_.learned, layer, growing_plan(layer, *arena, seconds), practice), lesson);
          !grown)
        return grown;
    if (auto kept = keep_if_games_allow(before, seconds, lesson); !kept) return kept;
    if (auto measured = measure(before, *arena, seconds, lesson); !measured) return measured;
    course_.lessons.push_back(std::move(lesson));
    return {};
  }

  Result<void> take(Result<Learned> step, Lesson& lesson) {
    if (!step) return step.failure();
    course_.learned = step->strategy;
    std::ranges::copy(step->changes, std::back_inserter(lesson.changes));
    std::ranges::copy(step->changes, std::back_inserter(course_.changes));
    std::ranges::copy(step->notes, std::back_inserter(lesson.notes));
    if (!step->curve.empty()) lesson.curve = std::move(step->curve);
    return {};
  }

  TuningPlan tuning_plan(const Layer& layer, const Arena& arena, double seconds) const {
    // a generation has about 12 candidates; the selection and its tests cost about as much as 20 generations
    const double share = layer.actions.empty() ? kTuned + kGrown : kTuned;
    const double candidates = kGenerations * 12 + 20 * 12;
    const int attempts = fitting(arena, share * seconds / candidates);
    return {.generations = kGenerations, .attempts = attempts, .selection = 4 * attempts, .test = 30 * attempts};
  }

  GrowingPlan growing_plan(const Layer& layer, const Arena& arena, double seconds) const {
    const double strategies = 6. * (1 + static_cast<double>(layer.actions.size())) + 2. * 2 * 8;
    const int attempts = fitting(arena, kGrown * seconds / strategies);
    return {.attempts = attempts, .selection = 2 * attempts, .most = 6};
  }

  /// Returns the number of seeds that a strategy can play in these simulated seconds, at least 24.
  static int fitting(const Arena& arena, double seconds) {
    return std::max(24, static_cast<int>(24 * std::floor(seconds / arena.cost_of(24))));
  }

  /// Takes the layer's changes back if whole games with them are worse on average: drills are a part of the game only.
  Result<void> keep_if_games_allow(const Json& before, double seconds, Lesson& lesson) {
    if (lesson.changes.empty()) return {};
    auto games = Arena::prepare({{kGame, 1}}, choice_.world, ledger_);
    if (!games) return games.failure();
    const Practice practice{*games, seeds_, tell_, choice_.shuffled};
    tell_(lesson.name + ": whole games", static_cast<double>(number_ + 1) / static_cast<double>(count_));
    const auto scores =
        practice.play({before, course_.learned}, Purpose::selection, fitting(*games, kGuarded * seconds / 2));
    if (!scores) return scores.failure();
    const contest::Mean gain = games->gain_of((*scores)[0], (*scores)[1]);
    const bool kept = gain.mean >= 0;
    lesson.notes.push_back(robot::formatted("in whole games: %+.3f ± %.3f goals%s", gain.mean, kSure * gain.error,
                                            kept ? "" : ": all changes of the layer are taken back"));
    if (kept) return {};
    course_.learned = before;
    course_.changes.resize(course_.changes.size() - lesson.changes.size());
    lesson.changes.clear();
    return {};
  }

  /// Measures the success before and after, on seeds that chose nothing.
  Result<void> measure(const Json& before, Arena& arena, double seconds, Lesson& lesson) {
    const int count = std::clamp(fitting(arena, 0.02 * seconds), 200, 2000);
    const std::uint64_t first = seeds_.take(Purpose::held_out, static_cast<std::uint64_t>(count));
    const auto scores = arena.play(std::vector<Json>{before, course_.learned}, first, count);
    if (!scores) return scores.failure();
    for (std::size_t e = 0; e < arena.size(); ++e) {
      const std::vector<Score>&a = (*scores)[0][e], &b = (*scores)[1][e];
      lesson.successes.push_back({.exercise = arena.exercise(e).name,
                                  .attempts = static_cast<int>(a.size()),
                                  .before = successes_in(a),
                                  .after = successes_in(b),
                                  .gain = success_gain(a, b)});
    }
    return {};
  }

  /// The learned tree must beat the start in a sequential test, and must not be worse against opponents that no game of
  /// the run met. Its seeds are the test's. The first process plays it; the others play what it will surely need.
  Result<void> gate(const Place& place) {
    const std::string a = place.file("start.json").string(), b = place.file("learned.json").string();
    if (auto written = robot::replace_file(a, io::printed(course_.start) + "\n"); !written) return written;
    if (auto written = robot::replace_file(b, io::printed(course_.learned) + "\n"); !written) return written;
    course_.better = true;
    contest::ComparisonChoice game{.a = a, .b = b};
    if (auto met = meet(place, game, "gate-start"); !met) return met;
    for (std::size_t i = 0; i < choice_.unseen.size(); ++i) {
      game.opponent = choice_.unseen[i];
      if (auto met = meet(place, game, "gate-unseen-" + std::to_string(i)); !met) return met;
    }
    return {};
  }

  /// Plays the gate's games against one opponent, or the start itself. `name` is that of their folder.
  Result<void> meet(const Place& place, contest::ComparisonChoice game, const std::string& name) {
    const std::string opponent = game.opponent;
    game.rules = choice_.world.rules, game.models = choice_.world.models, game.seed = course_.first_test_seed;
    const auto comparison = contest::Comparison::prepare(game);
    if (!comparison) return comparison.failure();
    contest::ContestOptions options{.question = {.h0 = 0, .h1 = choice_.wanted},
                                    .pairs = {},
                                    .most_pairs = choice_.most_pairs,
                                    .jobs = choice_.world.threads};
    if (!opponent.empty()) options.pairs = kUnseenPairs;
    tell_("the gate" + (opponent.empty() ? "" : ": against " + opponent), 1);
    std::optional<contest::RunFolder> folder;
    if (!place.kept().empty()) {
      auto opened =
          contest::RunFolder::open(place.file(name), comparison->specification(), contest::RunFolder::Use::share);
      if (!opened) return opened.failure();
      folder = *std::move(opened);
    }
    if (!choice_.share.is_first()) return options.pairs ? help(*comparison, options, *folder) : Result<void>();
    auto outcome = contest::play_contest(*comparison, options, folder ? &*folder : nullptr, [](const auto&, double) {});
    if (!outcome) return outcome.failure();
    Against against{.opponent = opponent, .outcome = *std::move(outcome)};
    against.passed = opponent.empty() ? against.outcome.verdict == compare::Verdict::better
                                      : compare::gain_per_game(against.outcome.tally).low > -kWorse;
    course_.better = course_.better && against.passed;
    course_.gate.push_back(std::move(against));
    return {};
  }

  /// Plays this process's part of a run whose length is known. The first process finds the blocks, and plays the rest.
  Result<void> help(const contest::Comparison& comparison, const contest::ContestOptions& options,
                    const contest::RunFolder& folder) const {
    const auto begin_of = [&](int number) {
      return static_cast<std::int64_t>(begin_of_part(static_cast<std::size_t>(options.most_blocks()),
                                                     static_cast<std::size_t>(number),
                                                     static_cast<std::size_t>(choice_.share.of)));
    };
    return contest::play_blocks(comparison, begin_of(choice_.share.number), begin_of(choice_.share.number + 1),
                                options.jobs, folder);
  }

  const LearnChoice& choice_;
  const std::vector<Layer> layers_;
  Ledger& ledger_;
  const Tell& tell_;
  Seeds seeds_;
  std::size_t number_ = 0, count_ = 1;
  Course course_;
};

}  // namespace

Budget Budget::of_minutes(double minutes) { return {.seconds = minutes * 60 * 2 * kSimulatedASecond}; }

Result<Course> learn(const LearnChoice& choice, const Tell& tell) {
  const Result<io::Source> source = io::find_source("strategies", "strategy", choice.strategy);
  if (!source) return source.failure();
  Result<Json> start = io::flattened(source->text, source->called);
  if (!start) return start.failure();
  std::vector<Layer> layers;
  for (const std::string& name : choice.layers) {
    auto layer = load_layer(name);
    if (!layer) return layer.failure();
    layers.push_back(*std::move(layer));
  }
  if (const std::string wrong = met_before(choice); !wrong.empty()) return Error{wrong};
  auto place = Place::open(choice.folder);
  if (!place) return place.failure();
  if (!choice.folder.empty())
    if (auto claimed = claim(place->file("run.json"), specification_of(choice, *start, layers)); !claimed)
      return claimed.failure();
  auto ledger = Ledger::open(place->kept(), choice.share);
  if (!ledger) return ledger.failure();
  return Learning(choice, *std::move(start), std::move(layers), *ledger, tell).run(*place);
}

}  // namespace sim::learn
