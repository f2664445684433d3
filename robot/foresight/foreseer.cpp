#include "robot/foresight/foreseer.h"

#include <algorithm>
#include <future>
#include <mutex>
#include <optional>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/clock.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"
#include "robot/foresight/edit.h"
#include "robot/foresight/question.h"
#include "sim/foresight/forecast.h"
#include "sim/match/hash.h"
#include "sim/referee/referee.h"

namespace robot::foreseeing {
namespace {

namespace pf = sim::foresight;

constexpr std::size_t kMostJobs = 2;       // one runs, one waits
constexpr std::size_t kMostPlaybooks = 8;  // kept ready
constexpr std::uint64_t kMillion = 1'000'000;

void add_paths(const pf::StrategyStatistics& account, const bridge::PlayerMap& lineup,
               pb::Forecast::StrategyForecast& told) {
  for (const pf::Path& path : account.paths) {
    if (path.points == 0) continue;
    pb::Forecast::Path& shown = *told.add_paths();
    shown.set_spacing(path.spacing);
    for (int i = 0; i < path.points; ++i) shown.add_ball(path.ball[i].x), shown.add_ball(path.ball[i].y);
    for (int place = 1; place <= sim::kMaxPlayers; ++place) {
      if (lineup.player_at(place) == 0) continue;
      pb::Forecast::RobotPath& robot = *shown.add_robots();
      robot.set_player(lineup.player_at(place));
      for (int i = 0; i < path.points; ++i) {
        robot.add_points(path.robots[i][place - 1].x);
        robot.add_points(path.robots[i][place - 1].y);
      }
    }
  }
  told.set_heat_columns(pf::HeatMap::kColumns);
  for (const auto& row : account.heat.counts)
    for (const std::uint32_t count : row) told.add_heat(count);
}

void fill(const pf::Standing& standing, const pf::StrategyStatistics& account, const bridge::PlayerMap& lineup,
          pb::Forecast::StrategyForecast& told) {
  told.set_rollouts(static_cast<std::uint32_t>(standing.rollouts));
  told.set_mean(static_cast<float>(standing.mean));
  told.set_error(static_cast<float>(standing.error));
  told.set_score(static_cast<float>(standing.score));
  told.set_concede(static_cast<float>(standing.concede));
  told.set_gain(static_cast<float>(standing.gain));
  told.set_gain_low(static_cast<float>(standing.gain_low));
  told.set_gain_high(static_cast<float>(standing.gain_high));
  told.set_best(static_cast<float>(standing.best));
  told.set_raced_on(standing.raced_on);
  add_paths(account, lineup, told);
}

void fill(const pf::Situation& situation, const sim::field::Rules& rules, const bridge::PlayerMaps& lineups,
          pb::Forecast::Situation& told) {
  const sim::World& world = situation.state.world;
  const sim::referee::Book& book = situation.state.book;
  told.set_ball_x(world.ball.position.x);
  told.set_ball_y(world.ball.position.y);
  told.set_ball_deviation(situation.doubt.ball);
  told.set_ball_elsewhere(situation.doubt.ball_elsewhere);
  told.set_own_score(book.score[0]);
  told.set_opponent_score(book.score[1]);
  told.set_seconds_remaining(std::max(0.f, sim::referee::left_of_half(rules, book)));
  sim::for_each_robot(world.players, [&](int robot) {
    const sim::Body& body = world.bodies[robot];
    if (body.doing == sim::Body::Doing::removed) return;
    pb::Forecast::Situation::Body& shown = *told.add_bodies();
    shown.set_opponent(sim::side_of(robot) == sim::Side::away);
    shown.set_player(lineups.of(sim::side_of(robot)).player_at(sim::player_of(robot)));
    shown.set_x(body.position.x);
    shown.set_y(body.position.y);
    shown.set_heading(body.heading);
    shown.set_deviation(situation.doubt.position[robot]);
  });
}

/// Returns the longest simulated time of a rollout [s].
float horizon_of(const pb::WhatIf& question, const sim::field::Rules& rules, const sim::referee::Book& book) {
  const bool is_half = question.until() == pb::WhatIf::UNTIL_HALF;
  if (!is_half && question.until() != pb::WhatIf::UNTIL_GAME) return question.horizon();
  // the clock of a half does not run before its kick-off
  using Phase = sim::agent::Game::Phase;
  const float before = rules.ready_duration + rules.set_duration;
  const bool stands = book.clock == 0 && book.phase != Phase::playing;
  const float still = stands ? (book.phase == Phase::set ? rules.set_duration : before) : 0;
  const float left = still + std::max(0.f, sim::referee::left_of_half(rules, book));
  const int halves = is_half ? 0 : std::max(rules.halves - int{book.half}, 0);
  return left + static_cast<float>(halves) * (before + rules.half_duration);
}

/// Fills the fields that every answer has.
pb::Forecast began(const pb::WhatIf& question, std::uint64_t asked_ns, double speed,
                   const sim::io::PlaybookChoice& choice) {
  pb::Forecast forecast;
  *forecast.mutable_question() = question;
  forecast.set_asked_ns(asked_ns);
  forecast.set_choice(question.strategies(0));
  forecast.set_models(choice.models);
  forecast.set_opponent_models(choice.opponent_models);
  forecast.set_rules(choice.rules);
  forecast.set_speed(static_cast<float>(speed));
  return forecast;
}

/// Returns the seed of a question: the same for the same question about the same moment.
sim::RandomKey key_of(const pb::WhatIf& question, const pf::Situation& situation) {
  sim::Hash hash;
  hash.add(sim::hash_of(situation.state));
  hash.add(question.id());
  return {.seed = hash.value()};
}

}  // namespace

Whose whose(const std::string& robot, const std::string& own) {
  return robot.substr(0, robot.find('/')) == own.substr(0, own.find('/')) ? Whose::own : Whose::others;
}

Result<std::unique_ptr<Foreseer>> Foreseer::open(ForeseerOptions options) {
  if (options.strategies.empty()) return Error{"foresight: there are no strategies to choose from"};
  auto made = std::unique_ptr<Foreseer>(new Foreseer(std::move(options)));
  // everything is read once, so that a wrong file is reported now
  if (const auto playbook = made->playbook_for(made->options_.strategies.front(), 0, Whose::own); !playbook)
    return playbook.failure("foresight");
  else
    made->rules_ = (*playbook)->params.front().rules;
  if (Result<void> started = made->rollouts_.start(); !started) return started.failure("foresight");
  if (Result<void> started = start_thread(made->answering_, "advice", [foreseer = made.get()] { foreseer->answer(); });
      !started)
    return started.failure("foresight");
  return made;
}

Foreseer::Foreseer(ForeseerOptions options) : options_(std::move(options)), rollouts_(options_.share) {}

Foreseer::~Foreseer() {
  hurry();
  {
    const std::lock_guard guard(lock_);
    ending_ = true;
    changed_.notify_all();
  }
  if (answering_.joinable()) answering_.join();
}

/// Returns the playbook of all strategies against that opponent, in the order of the
/// options. 0 players: as in the rules.
Result<std::shared_ptr<const sim::io::Playbook>> Foreseer::playbook_for(const std::string& opponent, int players,
                                                                        Whose robot) {
  const std::lock_guard guard(preparing_);
  const std::tuple key(opponent, players, robot);
  if (const auto kept = playbooks_.find(key); kept != playbooks_.end()) return kept->second;
  const bool is_own = robot == Whose::own;
  auto playbook = sim::io::prepare_playbook({.strategies = options_.strategies,
                                             .opponent = opponent,
                                             .rules = options_.rules,
                                             .models = is_own ? options_.models : options_.opponent_models,
                                             .opponent_models = is_own ? options_.opponent_models : options_.models,
                                             .players = players});
  if (!playbook) return playbook.failure();
  if (playbooks_.size() == kMostPlaybooks) playbooks_.clear();
  return playbooks_[key] = std::make_shared<const sim::io::Playbook>(std::move(*playbook));
}

void Foreseer::hurry() {
  const std::lock_guard guard(lock_);
  hurries_ = true;
  changed_.notify_all();
}

bool Foreseer::idle() {
  const std::lock_guard guard(lock_);
  return jobs_.empty();
}

Result<void> Foreseer::ask(const pb::WhatIf& asked, const bridge::Recollection& recollection, Answered answered,
                           Whose robot) {
  Result<pb::WhatIf> question = complete(asked, options_.strategies);
  if (!question) return question.failure();
  const std::uint32_t told = recollection.game ? recollection.game->value.players_per_team() : 0;
  const int players = told >= 1 && told <= sim::kMaxPlayers ? static_cast<int>(told) : 0;
  const auto playbook = playbook_for(question->opponent(), players, robot);
  if (!playbook) return playbook.failure();
  const sim::Params& params = (*playbook)->params.front();

  const bridge::PlayerMaps lineups(recollection.game ? recollection.game->value : pb::GameState(),
                                   params.rules.players);
  auto job = std::make_unique<Job>(Job{.lineups = lineups});
  job->asked_ns = recollection.now_ns;
  job->speed = recollection.speed;
  job->arrived_ns = monotonic_ns();
  auto knowledge = bridge::knowledge_of(recollection, params);
  if (knowledge && question->has_edit()) tell(question->edit(), lineups, *knowledge);
  const pf::Believed believed =
      knowledge ? pf::believe(params, *knowledge) : pf::Believed{.situation = {}, .refusal = knowledge.error()};
  if (!believed.refusal.empty()) {
    pb::Forecast forecast = began(*question, job->asked_ns, job->speed, (*playbook)->choice);
    forecast.set_refusal(believed.refusal);
    forecast.set_reason("cannot tell, because " + believed.refusal);
    answered(forecast);
    return {};
  }
  job->futures.situation = believed.situation;
  if (question->has_edit())
    if (Result<void> applied = apply(question->edit(), lineups, params, job->futures.situation); !applied)
      return applied;
  for (const std::string& name : question->strategies())
    job->futures.strategies.push_back(static_cast<int>(
        std::find((*playbook)->names().begin(), (*playbook)->names().end(), name) - (*playbook)->names().begin()));
  job->futures.playbook = *playbook;
  job->futures.question = question_of(*question);
  job->futures.key = key_of(*question, job->futures.situation);
  job->question = std::move(*question);
  job->answered = std::move(answered);

  const std::lock_guard guard(lock_);
  if (jobs_.size() >= kMostJobs) return Error{kBusy};
  jobs_.push_back(std::move(job));
  changed_.notify_all();
  return {};
}

Result<pb::Forecast> Foreseer::ask_and_wait(const pb::WhatIf& question, const bridge::Recollection& recollection,
                                            Whose robot) {
  const auto answer = std::make_shared<std::promise<pb::Forecast>>();
  auto coming = answer->get_future();
  if (Result<void> asked = ask(
          question, recollection, [answer](const pb::Forecast& forecast) { answer->set_value(forecast); }, robot);
      !asked)
    return asked.failure();
  std::optional<pb::Forecast> forecast;
  // a question whose answer failed for lack of memory leaves a broken promise
  if (Result<void> got = attempt("foresight", [&] { forecast = coming.get(); }); !got) return got.failure();
  return std::move(*forecast);
}

/// Runs the answering thread.
void Foreseer::answer() {
  name_thread("advice");
  while (true) {
    const Job* job;
    {
      const std::lock_guard guard(lock_);
      while (!ending_ && jobs_.empty()) changed_.wait(lock_);
      if (jobs_.empty()) return;
      job = jobs_.front().get();
    }
    if (const Result<void> answered = attempt("answering a question", [&] { answer(*job); }); !answered)
      report(Level::error, "foresight", answered.error());
    const std::lock_guard guard(lock_);
    jobs_.pop_front();
  }
}

void Foreseer::answer(const Job& job) {
  const std::uint64_t deadline_ns = monotonic_ns() + job.question.budget_ms() * kMillion;
  rollouts_.begin(job.futures, deadline_ns);
  {
    const std::lock_guard guard(lock_);
    while (!hurries_ && monotonic_ns() < deadline_ns) changed_.wait_until(lock_, deadline_ns);
  }
  const Progress progress = rollouts_.progress();
  rollouts_.end();
  job.answered(forecast_of(job, progress));
}

pb::Forecast Foreseer::forecast_of(const Job& job, const Progress& progress) {
  const auto& [playbook, strategies, situation, question, key] = job.futures;
  const pf::Forecast known = pf::forecast(progress.statistics, question, key);
  const std::vector<std::string> names(job.question.strategies().begin(), job.question.strategies().end());
  pb::Forecast forecast = began(job.question, job.asked_ns, job.speed, playbook->choice);
  const sim::field::Rules& rules = playbook->params.front().rules;
  forecast.set_horizon(horizon_of(job.question, rules, situation.state.book));
  forecast.set_advice(static_cast<pb::Forecast::Advice>(known.advice));
  forecast.set_choice(names[static_cast<std::size_t>(known.choice)]);
  forecast.set_reason(pf::reason(known, question, names.data()));
  for (int i = 0; i < known.strategies; ++i) {
    pb::Forecast::StrategyForecast& strategy = *forecast.add_strategies();
    strategy.set_strategy(names[static_cast<std::size_t>(i)]);
    fill(known.standings[i], progress.statistics.by_strategy[i], job.lineups.own, strategy);
  }
  forecast.set_answered_ms(static_cast<float>(monotonic_ns() - job.arrived_ns) / 1e6f);
  forecast.set_computed_ms(static_cast<float>(progress.computed_ns) / 1e6f);
  forecast.set_simulated(static_cast<float>(progress.statistics.ticks) * sim::kTickDuration);
  fill(situation, rules, job.lineups, *forecast.mutable_situation());
  return forecast;
}

}  // namespace robot::foreseeing
