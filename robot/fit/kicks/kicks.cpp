#include "robot/fit/kicks/kicks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/kicks/kick_habits.h"
#include "robot/fit/math/resampling.h"
#include "robot/fit/text_plot.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestKicks = 15, kKickSamples = 200, kFolds = 5, kDrawn = 1000;
constexpr double kRegion = 0.9;

/// A figure of a kind, as the models have it.
struct Part {
  const char* name;
  const char* unit;
  double widest;  // see Figure; of the range as its share
  double least;   // possible value
};
constexpr std::array<Part, 4> kParts{{{"range", "m", 0.3, 0},
                                      {"range_deviation", "", 0.1, 0},
                                      {"direction", "rad", 0.1, -4},
                                      {"direction_deviation", "rad", 0.06, 0}}};
constexpr double kFewestFull = 8;                           // full hits that show a deviation
constexpr double kWidestDelay = 0.1, kWidestPartial = 0.2;  // [s], [probability]
constexpr double kExactDelay = 0.0002;                      // [s] deviation of the delays of a truth without errors

double range_of(double speed, double deceleration) { return speed * speed / (2 * deceleration); }

/// Returns the values of kParts, and the probability of a partial hit.
Vector parts_of(const KickModel& model, double deceleration) {
  return {range_of(model.speed, deceleration), model.range_deviation, model.direction, model.direction_deviation,
          model.partial};
}

/// Draws kicks of a model that are faster than `slowest`, with the errors of observation of a kick.
class Drawn {
 public:
  Drawn(const KickModel& model, const KickSight& sight) : model_(model), sight_(sight) {}

  TrackedKick next(const TrackedKick& like) {
    TrackedKick kick = like;
    do {
      const bool is_partial = uniform_(random_) < model_.partial;
      const double share = is_partial ? uniform_(random_) : 1;
      const double spread = sight_.spread - (sight_.spread - 1) * share;
      const double range = std::max(0., 1 + model_.range_deviation * normal_(random_));
      kick.speed = share * model_.speed * std::sqrt(range) + like.speed_deviation * normal_(random_);
      kick.direction = model_.direction + spread * model_.direction_deviation * normal_(random_) +
                       like.direction_deviation * normal_(random_);
    } while (kick.speed < sight_.slowest);
    return kick;
  }

 private:
  const KickModel& model_;
  const KickSight& sight_;
  std::mt19937_64 random_{1};
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
};

/// The scores of a model on kicks that it was not fitted to.
struct Scores {
  std::size_t kicks = 0, covered = 0;
  double crps = 0, constant = 0;  // [m] sums
};

/// Adds the scores of one kick. `constant` [m] is the landing distance that a constant says.
void score(const KickModel& model, const KickSight& sight, const TrackedKick& kick, double deceleration,
           double constant, Scores& scores) {
  Drawn drawn(model, sight);
  std::vector<double> densities, ranges;
  for (std::size_t i = 0; i < kDrawn; ++i) {
    const TrackedKick one = drawn.next(kick);
    densities.push_back(model.density(one, sight.spread, sight.slowest));
    ranges.push_back(range_of(one.speed, deceleration));
  }
  std::ranges::sort(densities);
  std::ranges::sort(ranges);
  const double least = densities[static_cast<std::size_t>((1 - kRegion) * kDrawn)];
  const double landed = range_of(kick.speed, deceleration);
  // Gneiting and Raftery 2007: E|X - y| - E|X - X'| / 2, the second mean by the ranks of the sorted values
  double to_landed = 0, apart = 0;
  for (std::size_t i = 0; i < kDrawn; ++i) {
    to_landed += std::abs(ranges[i] - landed) / kDrawn;
    apart += ranges[i] * (2 * static_cast<double>(i) + 1 - kDrawn) / (static_cast<double>(kDrawn) * kDrawn);
  }
  ++scores.kicks;
  scores.covered += model.density(kick, sight.spread, sight.slowest) >= least ? 1 : 0;
  scores.crps += to_landed - apart;
  scores.constant += std::abs(constant - landed);
}

Scores held_out_scores(const std::vector<TrackedKick>& kicks, const KickSight& sight, double deceleration) {
  Scores scores;
  for (std::size_t fold = 0; fold < kFolds; ++fold) {
    std::vector<std::size_t> others;
    std::vector<double> ranges;
    for (std::size_t i = 0; i < kicks.size(); ++i) {
      if (i % kFolds == fold) continue;
      others.push_back(i);
      ranges.push_back(range_of(kicks[i].speed, deceleration));
    }
    const KickModel model = fit_kick(kicks, others, sight);
    const double constant = lab::median_of(std::move(ranges));
    for (std::size_t i = fold; i < kicks.size(); i += kFolds)
      score(model, sight, kicks[i], deceleration, constant, scores);
  }
  return scores;
}

Figure figure_of(const KickFit& fit, const Part& part, double value, double half) {
  const auto [slowest, fastest] = std::ranges::minmax_element(fit.kicks, {}, &TrackedKick::speed);
  return {.name = "kicks." + fit.kind + "." + part.name,
          .unit = part.unit,
          .value = value,
          .low = std::max(part.least, value - half),
          .high = value + half,
          .events = fit.kicks.size(),
          .kind = "kicks",
          .recordings = {},
          .domain = {.quantity = "speed", .unit = "m/s", .from = slowest->speed, .to = fastest->speed},
          .widest = part.widest};
}

Figure delay_of(const KickFit& fit) {
  std::vector<double> delays;
  for (const TrackedKick& kick : fit.kicks) delays.push_back(kick.delay);
  const double middle = lab::median_of(delays);
  for (double& delay : delays) delay = std::abs(delay - middle);
  const double deviation = deviation_of_median(lab::median_of(delays), delays.size());
  return figure_of(fit, {"delay", "s", kWidestDelay, 0}, middle,
                   two_sided(delays.size() - 1) * std::max(deviation, kExactDelay));
}

/// The fits of all kinds while kicks are added.
class Collection {
 public:
  explicit Collection(const KickFacts& facts) : facts_(facts) {}

  void add(const WatchedRobot& robot) {
    const lab::TruthRecord& truth = robot.game->record;
    const std::size_t recording = names_.size();
    bool any = false;
    for (const KickRun& run : read_kick_runs(robot)) {
      const auto kind = std::ranges::find(facts_.kinds, run.kind, &KickKind::name);
      if (kind == facts_.kinds.end()) continue;
      any = true;
      KickFit& fit = fit_of(run.kind);
      if (run.step > 0) {
        fit.durations.push_back(run.end - run.begin);
        fit.status_step = std::max(fit.status_step, run.step);
      }
      add(tracked(truth, robot.path, run, *kind, facts_.deceleration), run.left, recording, fit);
    }
    if (any) names_.push_back(robot.name);
  }

  std::vector<KickFit>& fits() { return fits_; }
  const std::vector<std::string>& names() const { return names_; }

 private:
  KickFit& fit_of(const std::string& kind) {
    const auto known = std::ranges::find(fits_, kind, &KickFit::kind);
    if (known != fits_.end()) return *known;
    fits_.push_back({.kind = kind, .kicks = {}, .durations = {}, .model = {}, .figures = {}, .partial = {}});
    return fits_.back();
  }

  static void add(const std::variant<TrackedKick, Untold>& kick, bool left, std::size_t recording, KickFit& fit) {
    if (const auto* good = std::get_if<TrackedKick>(&kick)) {
      fit.kicks.push_back(*good);
      fit.kicks.back().recording = recording;
      fit.kicks.back().left = left;
      return;
    }
    switch (std::get<Untold>(kick)) {
      case Untold::out_of_place: ++fit.out_of_place; return;
      case Untold::disturbed: ++fit.disturbed; return;
      case Untold::missed: ++fit.missed; return;
    }
  }

  const KickFacts& facts_;
  std::vector<std::string> names_;
  std::vector<KickFit> fits_;
};

/// Returns the figures of several kinds as one: their mean, by the width of their intervals.
Figure pooled(const std::vector<KickFit>& fits) {
  Figure all = fits.front().partial;
  double weights = 0, sum = 0;
  all.events = 0;
  for (const KickFit& fit : fits) {
    const double half = std::max(0.01, (fit.partial.high - fit.partial.low) / 2);
    weights += 1 / (half * half);
    sum += fit.partial.value / (half * half);
    all.events += fit.partial.events;
    all.domain.from = std::min(all.domain.from, fit.partial.domain.from);
    all.domain.to = std::max(all.domain.to, fit.partial.domain.to);
  }
  const double half = 1 / std::sqrt(weights);
  all.value = sum / weights;
  all.low = std::max(0., all.value - half);
  all.high = std::min(1., all.value + half);
  return all;
}

double greatest_deviation(const Evidence& evidence) {
  double deviation = 0;
  for (const WatchedRobot& robot : evidence.robots) deviation = std::max(deviation, robot.game->record.ball_deviation);
  return deviation;
}

}  // namespace

KickFacts kick_facts_of(const sim::Models& models) {
  KickFacts facts{.kinds = {}, .deceleration = models.ball.deceleration, .spread = models.motion.hits.spread};
  for (int i = 0; i < models.motion.kick_count; ++i) {
    const sim::motion::Kick& kick = models.motion.kicks[i];
    facts.kinds.push_back({.name = kick.name,
                           .ball_x = kick.ball_x,
                           .ball_y = kick.ball_y,
                           .gate_x = kick.gate_x,
                           .gate_y = kick.gate_y});
  }
  return facts;
}

Result<KickFit> fit_kind(KickFit seen, const std::vector<std::string>& recordings, const KickFacts& facts) {
  std::erase_if(seen.kicks, [&](const TrackedKick& kick) { return kick.speed < seen.slowest; });
  if (seen.kicks.size() < kFewestKicks)
    return Error{
        formatted("expected at least %zu kicks in place that nobody disturbs, got %zu (%zu out of place, %zu "
                  "disturbed, %zu missed)",
                  kFewestKicks, seen.kicks.size(), seen.out_of_place, seen.disturbed, seen.missed)};
  const KickSight sight{.spread = facts.spread, .slowest = seen.slowest};
  const Group all = all_of(seen.kicks.size());
  seen.model = fit_kick(seen.kicks, all, sight);
  const Vector values = parts_of(seen.model, facts.deceleration);
  const Vector around =
      deviations_of(resampled(single_groups(all.size()), kKickSamples, [&](const std::vector<std::size_t>& chosen) {
        return parts_of(refit_kick(seen.kicks, chosen, sight, seen.model), facts.deceleration);
      }));
  const double half = two_sided(all.size() - 1);
  for (std::size_t i = 0; i < kParts.size(); ++i)
    seen.figures.push_back(figure_of(seen, kParts[i], values[i], half * around[i]));
  seen.figures.front().widest *= values.front();
  // only full hits show how ranges deviate; resampled kicks without them would all agree by chance
  if (static_cast<double>(all.size()) * (1 - seen.model.partial) < kFewestFull)
    seen.figures[1].low = 0, seen.figures[1].high = kMostRangeDeviation;
  seen.figures.push_back(delay_of(seen));
  for (Figure& figure : habits_of(seen)) seen.figures.push_back(std::move(figure));
  for (Figure& figure : seen.figures) figure.recordings = recordings;
  seen.partial = figure_of(seen, {"", "", kWidestPartial, 0}, values[4], 0);
  seen.partial.name = "hits.partial";
  const PartialInterval partial = partial_interval(seen.kicks, all, sight, seen.model);
  seen.partial.low = partial.low;
  seen.partial.high = partial.high;
  seen.partial.recordings = recordings;
  const Scores scores = held_out_scores(seen.kicks, sight, facts.deceleration);
  const auto count = static_cast<double>(scores.kicks);
  seen.covered = static_cast<double>(scores.covered) / count;
  seen.crps = scores.crps / count;
  seen.constant_error = scores.constant / count;
  return seen;
}

std::vector<KickFit> seen_kicks(const Evidence& evidence, const KickFacts& facts,
                                std::vector<std::string>& recordings) {
  Collection collection(facts);
  for (const WatchedRobot& robot : evidence.robots) collection.add(robot);
  recordings = collection.names();
  // a ball that rolls three errors of the truth is told from one that lies
  const double slowest = std::sqrt(2 * facts.deceleration * 3 * greatest_deviation(evidence));
  for (KickFit& seen : collection.fits()) seen.slowest = slowest;
  return std::move(collection.fits());
}

Result<Kicks> fit_kicks(const Evidence& evidence, const KickFacts& facts) {
  Kicks kicks;
  for (KickFit& seen : seen_kicks(evidence, facts, kicks.recordings)) {
    const std::string kind = seen.kind;
    auto fit = fit_kind(std::move(seen), kicks.recordings, facts);
    if (fit)
      kicks.fits.push_back(std::move(*fit));
    else
      kicks.kept.push_back("kicks." + kind + ": " + fit.error());
  }
  if (!kicks.fits.empty()) {
    kicks.partial = pooled(kicks.fits);
    return kicks;
  }
  return Error{kicks.kept.empty() ? "no robot recorded a kick beside the truth" : joined(kicks.kept, "; ")};
}

Table table_of(const KickFit& fit, const std::vector<std::string>& recordings) {
  Table table{.columns = {"time [s]", "delay [s]", "speed [m/s]", "deviation of the speed [m/s]", "direction [rad]",
                          "deviation of the direction [rad]"},
              .names = recordings,
              .rows = {}};
  for (const TrackedKick& kick : fit.kicks)
    table.rows.push_back(
        {.recording = kick.recording,
         .values = {kick.at, kick.delay, kick.speed, kick.speed_deviation, kick.direction, kick.direction_deviation}});
  return table;
}

std::string to_text(const Kicks& kicks) {
  std::string text;
  for (const KickFit& fit : kicks.fits) {
    double most = 0;
    for (const TrackedKick& kick : fit.kicks) most = std::max(most, kick.speed);
    TextPlot plot({.left = 0, .right = most, .bottom = -1, .top = 1});
    for (const TrackedKick& kick : fit.kicks) plot.dot('.', kick.speed, kick.direction - fit.model.direction);
    text += "kick " + fit.kind + ": direction beside its mean [rad] over the speed of the ball [m/s]\n" + plot.text();
    for (const Figure& figure : fit.figures) text += formatted("%-38s ", figure.name.c_str()) + to_text(figure) + "\n";
    text += formatted(
        "held out: %.0f %% land in the region of 90 %%; CRPS of the landing distance %.2f m, of a constant %.2f m\n",
        100 * fit.covered, fit.crps, fit.constant_error);
    text += formatted("left out: %zu out of place, %zu disturbed, %zu missed\n", fit.out_of_place, fit.disturbed,
                      fit.missed);
  }
  return text + formatted("%-38s ", kicks.partial.name.c_str()) + to_text(kicks.partial) + "\n";
}

}  // namespace robot::fit
