// bench_runtime: the runtime of a robot under the load of a game, which reports the fate of every written message.
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdio>
#include <thread>

#include "robot/app/runtime.h"
#include "robot/app/signals.h"
#include "robot/core/json_library.h"
#include "robot/foresight/foreseer.h"
#include "robot/logging/sessions/recorder.h"
#include "robot/logging/sessions/session.h"
#include "tests/bench/load.h"
#include "tests/bench/slow_disk.h"

namespace bench {
namespace {

using nlohmann::json;
using robot::Error;
using robot::monotonic_ns;
using robot::Result;

struct Options {
  Load::Options load;
  bool no_objects = false, no_costs = false, no_recent = false;
  double seconds = 10, warm_up = 0, cool_down = 0;
  robot::app::ServerSettings server;
  std::filesystem::path log_folder = "logs";
  std::uint64_t log_mb = 100'000;
  std::string profile;         // empty: no recording
  double session_seconds = 0;  // a new session each time this has passed; 0: one for all
  double disk_mb_per_second = 0, disk_stall_ms = 0, disk_stall_every = 0;
  double memory_every = 0;  // [s] between two measurements of the resident memory
  bool foresight = false;   // asks one what-if question after the other
};

/// A clock that runs `speed` times as fast.
class FastClock final : public robot::Clock {
 public:
  explicit FastClock(double speed) : speed_(speed) {}
  std::uint64_t now_ns() const override {
    const auto passed = static_cast<double>(monotonic_ns() - started_ns_);
    return epoch_ns_ + (speed_ == 1 ? monotonic_ns() - started_ns_ : static_cast<std::uint64_t>(passed * speed_));
  }

 private:
  const double speed_;
  const std::uint64_t started_ns_ = monotonic_ns(), epoch_ns_ = robot::system_ns();
};

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

json costs_json(const std::vector<WriteCost>& costs) {
  std::vector<std::uint32_t> cpu, wall;
  for (const WriteCost& cost : costs) cpu.push_back(cost.cpu_ns), wall.push_back(cost.wall_ns);
  return {{"count", costs.size()},
          {"cpu_p50_us", percentile(cpu, 0.5) * 1e-3},
          {"cpu_p99_us", percentile(cpu, 0.99) * 1e-3},
          {"cpu_p999_us", percentile(cpu, 0.999) * 1e-3},
          {"wall_p50_us", percentile(wall, 0.5) * 1e-3},
          {"wall_p99_us", percentile(wall, 0.99) * 1e-3},
          {"wall_p999_us", percentile(wall, 0.999) * 1e-3}};
}

/// Records while it runs, in one session or in many, and adds up the statistics.
class Sessions {
 public:
  Sessions(robot::app::Runtime& runtime, const robot::Clock& clock, const Options& options)
      : options_(options),
        clock_(clock),
        store_(options.log_folder, options.log_mb * 1'000'000),
        recorder_(runtime.channels(), runtime.board(), store_, clock, {.info = {.robot = "14/2", .build = "bench"}}) {}

  Result<void> begin() {
    next_ns_ = options_.session_seconds > 0
                   ? monotonic_ns() + static_cast<std::uint64_t>(options_.session_seconds * 1e9)
                   : UINT64_MAX;
    const auto started = recorder_.start("bench", options_.profile);
    return started ? Result<void>() : Result<void>(Error{started.error()});
  }

  Result<void> next() {
    if (monotonic_ns() < next_ns_) return {};
    if (auto ended = end(); !ended) return ended;
    store_.make_room(0, clock_.now_ns());
    return begin();
  }

  Result<void> end() {
    last_ = recorder_.status();
    const auto session = recorder_.stop();
    if (!session) return Error{session.error()};
    dropped_ += recorder_.status().dropped;  // also those of the end
    const auto read = robot::logging::read_session(options_.log_folder / *session);
    if (!read) return Error{read.error()};
    ++sessions_;
    size_bytes_ += read->size_bytes;
    damaged_ += read->state == robot::logging::SessionState::complete ? 0 : 1;
    for (const auto& stream : read->streams) {
      messages_[stream.topic] += stream.messages;
      bytes_[stream.topic] += stream.size_bytes;
    }
    return {};
  }

  json report() const {
    return {{"sessions", sessions_},
            {"damaged", damaged_},
            {"dropped", dropped_},
            {"size_bytes", size_bytes_},
            {"disk_bytes", store_.size_bytes()},
            {"state", name(last_.state)},
            {"announced_mb_per_minute", last_.mb_per_minute},
            {"messages", messages_},
            {"bytes", bytes_}};
  }

 private:
  const Options& options_;
  const robot::Clock& clock_;
  robot::logging::SessionStore store_;
  robot::logging::Recorder recorder_;
  robot::logging::RecordingStatus last_;
  std::uint64_t next_ns_ = UINT64_MAX, sessions_ = 0, damaged_ = 0, dropped_ = 0, size_bytes_ = 0;
  std::map<std::string, std::uint64_t> messages_, bytes_;
};

/// Asks one question after the other about a moment of a game, without a pause.
class Asker {
 public:
  static Result<std::unique_ptr<Asker>> open() {
    auto foreseer = robot::foreseeing::Foreseer::open({.strategies = {"baseline", "passing", "kick_now"}});
    if (!foreseer) return Error{foreseer.error()};
    return std::unique_ptr<Asker>(new Asker(std::move(*foreseer)));
  }
  ~Asker() { futures(); }

  /// Ends it, and returns the number of answers.
  std::uint64_t futures() {
    asking_ = false;
    foreseer_->hurry();
    if (thread_.joinable()) thread_.join();
    return futures_;
  }

 private:
  explicit Asker(std::unique_ptr<robot::foreseeing::Foreseer> foreseer)
      : foreseer_(std::move(foreseer)), thread_([this] { ask(); }) {}

  void ask() {
    robot::bridge::Recollection moment{.now_ns = robot::system_ns()};
    foresight::GameState& game = moment.game.emplace().value;
    game.set_state(foresight::GameState::STATE_PLAYING);
    game.set_own_player(2);
    game.set_players_per_team(5);
    game.set_half(1);
    game.set_seconds_remaining(600);
    moment.pose.emplace().capture_ns = moment.now_ns;
    foresight::Ball& ball = moment.ball.emplace().value;
    ball.set_x(0.5f);
    ball.set_seen_ns(moment.now_ns);
    foresight::WhatIf question;
    question.set_budget_ms(1000);
    while (asking_) {
      const auto forecast = foreseer_->ask_and_wait(question, moment);
      if (!forecast) continue;
      for (const auto& strategy : forecast->strategies()) futures_ += strategy.rollouts();
    }
  }

  const std::unique_ptr<robot::foreseeing::Foreseer> foreseer_;
  std::atomic<bool> asking_{true};
  std::uint64_t futures_ = 0;  // CPU time of the asking thread
  std::thread thread_;
};

json written_json(const robot::memory::Channels& channels) {
  json written = json::object();
  for (const auto& channel : channels.all())
    if (const auto newest = channel->newest()) written[channel->info().topic] = newest->sequence();
  return written;
}

Result<json> run(const Options& options) {
  if (options.disk_mb_per_second > 0 || options.disk_stall_ms > 0)
    use_slow_disk({.bytes_per_second = options.disk_mb_per_second * 1e6,
                   .stall_ns = static_cast<std::uint64_t>(options.disk_stall_ms * 1e6),
                   .stall_every_ns = static_cast<std::uint64_t>(options.disk_stall_every * 1e9)});
  const FastClock clock(options.load.speed);
  const auto memory = std::make_shared<robot::memory::Memory>("14/2", clock);
  robot::app::Runtime runtime(
      {.program = "bench",
       .body = "bench",
       .robot = "14/2",
       .team = 14,
       .player = 2,
       .server = options.server,
       .log_folder = options.log_folder,
       .log_bytes = options.log_mb * 1'000'000,
       .records = false,
       .recent = options.no_recent ? std::nullopt : std::optional<robot::logging::RecentPastLimits>{std::in_place}},
      clock, {.runtime = memory->runtime, .clock = memory->clock, .log = memory->log});
  if (auto listed = list(memory, runtime.channels()); !listed) return Error{listed.error()};
  if (auto started = runtime.start(); !started) return Error{started.error()};
  const bool records = !options.profile.empty();
  Sessions sessions(runtime, clock, options);
  if (records)
    if (auto begun = sessions.begin(); !begun) return Error{begun.error()};

  std::unique_ptr<Asker> asker;
  if (options.foresight) {
    auto opened = Asker::open();
    if (!opened) return Error{opened.error()};
    asker = std::move(*opened);
  }

  // clients connect before it begins
  const auto until = [](double seconds) { return monotonic_ns() + static_cast<std::uint64_t>(seconds * 1e9); };
  const std::uint64_t begins_ns = until(options.warm_up);
  runtime.run([&] { return monotonic_ns() < begins_ns; });
  Load load(*memory, clock, options.load);
  const double cpu_before = cpu_seconds();
  const std::uint64_t started_ns = monotonic_ns(), ends_ns = until(options.seconds);
  load.start();
  Result<void> going;
  json memory_mb = json::array();
  double next_memory = options.memory_every;
  runtime.run([&] {
    const double passed = static_cast<double>(monotonic_ns() - started_ns) * 1e-9;
    if (options.memory_every > 0 && passed >= next_memory) {
      next_memory += options.memory_every;
      memory_mb.push_back(static_cast<double>(robot::app::process_usage().resident_bytes) * 1e-6);
    }
    if (records) going = sessions.next();
    return going && monotonic_ns() < ends_ns;
  });
  if (!going) return Error{going.error()};
  load.stop();
  const double seconds = static_cast<double>(monotonic_ns() - started_ns) * 1e-9;
  const double cores = (cpu_seconds() - cpu_before) / seconds;
  const std::uint64_t closes_ns = until(options.cool_down);
  runtime.run([&] { return monotonic_ns() < closes_ns; });
  json report{{"seconds", seconds},
              {"frames", load.frames()},
              {"cpu_cores", cores},
              {"resident_mb", static_cast<double>(robot::app::process_usage().resident_bytes) * 1e-6},
              {"memory_mb", memory_mb},
              {"period_p50_ms", percentile(load.periods_us(), 0.5) * 1e-3},
              {"period_p99_ms", percentile(load.periods_us(), 0.99) * 1e-3},
              {"period_max_ms", percentile(load.periods_us(), 1) * 1e-3},
              {"write", costs_json(load.costs())},
              {"control", costs_json(load.control_costs())},
              {"image_write", costs_json(load.image_costs())},
              {"written", written_json(runtime.channels())}};
  if (asker) report["futures"] = asker->futures();
  if (!records) return report;
  if (auto ended = sessions.end(); !ended) return Error{ended.error()};
  report["recorded"] = sessions.report();
  return report;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  CLI::App app{"The runtime under the load of a game; prints its address first, a report in JSON at the end"};
  bench::Options options;
  add_server_options(app, options.server);
  app.add_option("--cameras", options.load.cameras, "0, 1 or 2, raw 640x480 YUYV at 30 Hz");
  app.add_flag("--no-objects", options.no_objects, "nothing but images");
  app.add_flag("--no-costs", options.no_costs, "do not measure what each write costs");
  app.add_flag("--no-recent", options.no_recent, "do not keep the last minutes, as a robot does");
  app.add_option("--truth-hz", options.load.truth_hz, "ground truth");
  app.add_option("--work", options.load.work, "[cores] that cognition computes, such as 0.7");
  app.add_option("--speed", options.load.speed, "everything, time itself too, so many times as fast");
  app.add_option("--seconds", options.seconds, "how long, after the warm-up");
  app.add_option("--warm-up", options.warm_up, "[s] in which clients may connect before anything is written");
  app.add_option("--cool-down", options.cool_down, "[s] in which clients may read what was written last");
  app.add_option("--log-dir", options.log_folder, "where sessions are recorded");
  app.add_option("--log-mb", options.log_mb, "what all sessions together may take [MB]");
  app.add_option("--profile", options.profile, "records: game, vision or full");
  app.add_option("--session-seconds", options.session_seconds, "a new session so often");
  app.add_option("--disk-mb-per-second", options.disk_mb_per_second, "a disk made slow");
  app.add_option("--disk-stall-ms", options.disk_stall_ms, "that takes nothing for so long");
  app.add_option("--disk-stall-every", options.disk_stall_every, "[s] so often");
  app.add_option("--memory-every", options.memory_every, "[s] note the resident set so often");
  app.add_flag("--foresight", options.foresight, "ask what if all the time");
  CLI11_PARSE(app, argc, argv);
  options.load.objects = !options.no_objects;
  options.load.measure = !options.no_costs;
  robot::app::block_end_signals();
  const auto report = bench::run(options);
  if (!report) return std::fprintf(stderr, "bench_runtime: %s\n", report.error().c_str()), 2;
  std::printf("%s\n", report->dump().c_str());
  return 0;
}
