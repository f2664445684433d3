#include "robot/body/sim/sim_body.h"

#include <algorithm>
#include <initializer_list>
#include <mutex>
#include <string>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"
#include "sim/match/step.h"
#include "sim/math/tick.h"
#include "sim/referee/event.h"

namespace robot::body {
namespace {

constexpr double kEachTickShownUpTo = 2;               // [game seconds per second]; at higher speeds some are skipped
constexpr std::uint64_t kShowPeriodNs = kSecond / 60;  // between two shown ticks at higher speeds
constexpr std::uint64_t kBreathNs = kMillisecond;      // others get the lock even if the machine is too slow

constexpr const char* kOver = "simulation: the game is over; a reset begins another one";

Result<void> check_speed(double speed) {
  if (speed >= Pacer::kSlowest && speed <= Pacer::kFastest) return {};
  return Error{"simulation: 'speed' must be 0.1 .. 100, got " + std::to_string(speed)};
}

Result<void> check_seed(std::uint64_t seed) {
  if (seed <= SimBody::kGreatestSeed) return {};
  return Error{"simulation: 'seed' must be 0 .. " + std::to_string(SimBody::kGreatestSeed) + ", got " +
               std::to_string(seed)};
}

sim::State kick_off(const sim::Params& params, std::uint64_t seed) {
  sim::referee::Events events;
  return sim::begin(params, {seed}, events);
}

}  // namespace

Result<std::unique_ptr<SimBody>> SimBody::open(GameSetup setup, SimOptions options, const SessionClock& clock) {
  if (Result<void> speed = check_speed(options.speed); !speed) return speed.failure();
  if (Result<void> seed = check_seed(options.seed); !seed) return seed.failure();
  const int player = sim::player_of(options.robot);
  if (player > setup.params().rules.players)
    return Error{"simulation: in " + setup.names.rules + " 'player' must be 1 .. " +
                 std::to_string(setup.params().rules.players) + ", got " + std::to_string(player)};
  if (setup.names.teams.home == setup.names.teams.away)
    return Error{"simulation: the two teams need different numbers, both have " +
                 std::to_string(setup.names.teams.home)};
  return std::unique_ptr<SimBody>(new SimBody(std::move(setup), options, clock));
}

SimBody::SimBody(GameSetup setup, SimOptions options, const SessionClock& clock)
    : setup_(std::move(setup)),
      options_(options),
      clock_(clock),
      game_(setup_.params(), setup_.names, kick_off(setup_.params(), options.seed)),
      narrator_(game_, options.robot, clock) {
  past_.begin(game_);
  pacer_.restart(options_.speed, monotonic_ns());
  go_on();
}

SimBody::~SimBody() { stop(); }

Result<void> SimBody::list(memory::Channels& channels) const {
  memory::Memory& own = *memory();
  Result<void> listed = narrator_.list(channels);
  for (memory::Channel* object : std::initializer_list<memory::Channel*>{
           &own.clock, &own.runtime, &own.log, &own.what_if, &own.forecast, &own.strategy, &own.forecast_score})
    if (listed) listed = channels.add(std::shared_ptr<memory::Channel>(memory(), object));
  return listed;
}

Result<void> SimBody::start() {
  const std::lock_guard guard(lock_);
  running_ = true;
  go_on();
  return start_thread(thread_, "simulation", [this] { run(); });
}

void SimBody::stop() {
  {
    const std::lock_guard guard(lock_);
    running_ = false;
    changed_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

void SimBody::run() {
  name_thread("simulation");
  const std::lock_guard guard(lock_);
  while (running_) {
    const bool over = game_.finished();
    if (paused_ || (over && !options_.loop)) {
      changed_.wait(lock_);
    } else if (monotonic_ns() < wake_ns_) {
      changed_.wait_until(lock_, wake_ns_);
    } else if (const Result<void> played = attempt("simulation", [&] { over ? begin_next() : play_due_ticks(); });
               !played) {
      report(Level::error, "simulation", played.error());
    }
  }
}

void SimBody::play_due_ticks() {
  const std::uint64_t now_ns = monotonic_ns();
  while (pacer_.next_ns() <= now_ns && !game_.finished()) {
    const std::uint64_t due_ns = pacer_.take(now_ns);
    tick();
    const bool last = pacer_.next_ns() > now_ns || game_.finished();
    if (last || pacer_.speed() <= kEachTickShownUpTo) show(due_ns);
  }
  const bool each = pacer_.speed() <= kEachTickShownUpTo;
  // also when the machine is too slow for the speed: others need the lock, to pause the game for instance
  wake_ns_ = std::max(pacer_.next_ns(), monotonic_ns() + kBreathNs);
  if (!each) wake_ns_ = std::max(wake_ns_, now_ns + kShowPeriodNs);
  if (game_.finished()) wake_ns_ = monotonic_ns() + options_.rest_ns;
}

/// Plays one tick. The own robot follows the strategy in its memory, which its process chose as the captain or heard
/// from the captain.
void SimBody::tick() {
  past_.note(game_);
  if (const auto version = memory()->strategy.read()) {
    const foresight::Strategy& strategy = version->value();
    const auto number = static_cast<std::uint8_t>(strategy.chosen() ? strategy.number() : sim::agent::kNoStrategy);
    const sim::agent::Choice choice{.strategy = number, .epoch = static_cast<std::uint8_t>(strategy.epoch())};
    past_.note_choice(game_.state().world.tick, options_.robot, choice);
    game_.follow(options_.robot, choice);
  }
  sim::referee::Events events;
  game_.tick(events);
}

void SimBody::begin(const sim::State& state) {
  game_.begin(state);
  past_.begin(game_);
  narrator_.forget();
  go_on();
}

void SimBody::begin_next() {
  const std::uint64_t seed = game_.state().world.key.seed;
  begin(kick_off(setup_.params(), seed < kGreatestSeed ? seed + 1 : 0));
}

/// Writes the results of the last tick, which was due at `monotonic_ns`.
void SimBody::show(std::uint64_t monotonic_ns) {
  const std::uint64_t capture_ns = monotonic_ns + clock_.epoch_offset_ns();
  const sim::Tick tick = game_.state().world.tick;
  // at a constant pace the time line stays the same, so that times of the past do not change by rounding
  constexpr std::uint64_t kRoundingNs = 100;
  const std::uint64_t as_before_ns = timeline_.at(tick);
  const std::uint64_t off_ns = std::max(as_before_ns, capture_ns) - std::min(as_before_ns, capture_ns);
  if (timeline_.speed != pacer_.speed() || off_ns > kRoundingNs) {
    timeline_ = {.epoch_ns = 0, .speed = pacer_.speed()};
    timeline_.epoch_ns = capture_ns - timeline_.since_start_ns(tick);
  }
  narrator_.write(game_, timeline_);
  show_status();
}

void SimBody::show_status() {
  narrator_.write_status(game_, {.paused = paused_, .speed = pacer_.speed(), .ticks_behind = pacer_.ticks_behind()},
                         timeline_);
}

/// Restarts the pace after an order, and writes the state of the game.
void SimBody::go_on() {
  const std::uint64_t now_ns = monotonic_ns();
  pacer_.restart(pacer_.speed(), now_ns);
  wake_ns_ = game_.finished() ? now_ns + options_.rest_ns : pacer_.next_ns();
  show(now_ns);
  changed_.notify_all();
}

void SimBody::pause() {
  const std::lock_guard guard(lock_);
  paused_ = true;
  show_status();
}

Result<void> SimBody::resume() {
  const std::lock_guard guard(lock_);
  if (game_.finished()) return Error{kOver};
  if (std::exchange(paused_, false)) go_on();
  return {};
}

Result<void> SimBody::step(std::int64_t ticks) {
  if (ticks < 1 || ticks > kMostSteps)
    return Error{"simulation: 'ticks' must be 1 .. " + std::to_string(kMostSteps) + ", got " + std::to_string(ticks)};
  const std::lock_guard guard(lock_);
  if (game_.finished()) return Error{kOver};
  paused_ = true;
  for (; ticks > 0 && !game_.finished(); --ticks) {
    tick();
    show(monotonic_ns());
  }
  return {};
}

Result<void> SimBody::back(std::int64_t ticks) {
  if (ticks < 1 || ticks > kMostBack)
    return Error{"simulation: 'ticks' must be 1 .. " + std::to_string(kMostBack) + ", got " + std::to_string(ticks)};
  const std::lock_guard guard(lock_);
  const sim::Tick now = game_.state().world.tick, played = now - past_.first();
  past_.go_to(now - std::min(static_cast<sim::Tick>(ticks), played), game_);
  paused_ = true;
  narrator_.forget();
  go_on();
  return {};
}

Result<sim::State> SimBody::state_at(std::optional<std::uint64_t> seed, std::optional<sim::Tick> tick) const {
  std::optional<bridge::SimulatedGame> game;
  {
    const std::lock_guard guard(lock_);
    const std::uint64_t played = game_.state().world.key.seed;
    if (seed.value_or(played) != played)
      return Error{"simulation: that moment is of the game with seed " + std::to_string(*seed) + ", and now seed " +
                   std::to_string(played) + " is played"};
    const sim::Tick now = game_.state().world.tick, wanted = tick.value_or(now);
    if (wanted < past_.first() || wanted > now)
      return Error{"simulation: 'tick' must be " + std::to_string(past_.first()) + " .. " + std::to_string(now) +
                   ", got " + std::to_string(wanted)};
    game.emplace(game_);
    if (wanted != now) past_.go_to(wanted, *game);
  }
  return game->state();
}

Result<void> SimBody::edit(const sim::State& state) {
  const std::lock_guard guard(lock_);
  if (game_.finished()) return Error{kOver};
  if (state.world.tick != game_.state().world.tick) return Error{"simulation: the game has moved on: pause it first"};
  bridge::SimulatedGame::Moment edited = game_.moment();
  edited.state = state;
  if (!past_.note_edit(edited))
    return Error{"simulation: a game takes " + std::to_string(bridge::GamePast::kEdits) + " edits at most"};
  game_.change([&](sim::State& now) { now = state; });
  paused_ = true;
  narrator_.forget();
  go_on();
  return {};
}

Result<void> SimBody::set_speed(double speed) {
  if (Result<void> checked = check_speed(speed); !checked) return checked;
  const std::lock_guard guard(lock_);
  pacer_.restart(speed, monotonic_ns());
  go_on();
  return {};
}

Result<void> SimBody::reset(std::uint64_t seed) {
  if (Result<void> checked = check_seed(seed); !checked) return checked;
  const std::lock_guard guard(lock_);
  begin(kick_off(setup_.params(), seed));
  return {};
}

void SimBody::reset(const sim::State& situation) {
  const std::lock_guard guard(lock_);
  begin(situation);
}

foresight::Simulation SimBody::state() const { return memory()->simulation.read()->value(); }

}  // namespace robot::body
