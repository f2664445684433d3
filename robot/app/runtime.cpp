#include "robot/app/runtime.h"

#include <cstdio>
#include <mutex>
#include <utility>

#include "robot/app/build_id.h"
#include "robot/app/rules_field.h"
#include "robot/app/services/recording_service.h"
#include "robot/app/signals.h"
#include "robot/core/attempt.h"
#include "robot/core/report.h"
#include "robot/net/foxglove/derived_channels.h"

namespace robot::app {
namespace {

constexpr std::uint64_t kTickNs = kSecond / 10;
constexpr std::uint64_t kRoomNs = 10 * kSecond;  // between two attempts to delete old sessions

std::string run_id() { return std::to_string(system_ns() / kMillisecond); }

/// Returns a function that adds up the steps of the system clock since this call [ns].
std::function<std::int64_t()> steps_since_now() {
  return [begin_ns = system_ns() - monotonic_ns()] {
    return static_cast<std::int64_t>(system_ns() - monotonic_ns() - begin_ns);
  };
}

foresight::LogText::Level level_of(Level level) {
  switch (level) {
    case Level::debug: return foresight::LogText::LEVEL_DEBUG;
    case Level::info: return foresight::LogText::LEVEL_INFO;
    case Level::warning: return foresight::LogText::LEVEL_WARNING;
    case Level::error: return foresight::LogText::LEVEL_ERROR;
  }
  return foresight::LogText::LEVEL_UNSPECIFIED;
}

net::ServerOptions server_options(const RuntimeOptions& options, net::AccessOptions access) {
  std::map<std::string, std::string> metadata{
      {"build", std::string(kBuildId)}, {"body", options.body}, {"robots", options.robot}};
  if (!options.rules.empty()) metadata["rules"] = options.rules;
  if (!options.session.empty()) metadata["session"] = options.session;
  if (options.recent) metadata["recent"] = "/api/recent";
  if (options.playback) metadata["own_playheads"] = "yes";
  return {.bind = options.server.bind,
          .port = options.server.port,
          .hub = {.name = options.program + " " + options.robot,
                  .metadata = std::move(metadata),
                  .queues = {},
                  .playback = options.playback},
          .access = std::move(access),
          .wireless = options.server.wireless};
}

}  // namespace

OwnObjects own_objects(memory::Memory& memory) {
  return {.runtime = memory.runtime, .clock = memory.clock, .log = memory.log, .robot = &memory};
}

Runtime::Runtime(RuntimeOptions options, const Clock& clock, OwnObjects own)
    : options_(std::move(options)),
      clock_(clock),
      own_(own),
      store_(options_.log_folder, options_.log_bytes),
      recorder_(channels_, board_, store_, clock_,
                {.info = {.robot = options_.robot,
                          .team = options_.team,
                          .player = options_.player,
                          .build = std::string(kBuildId),
                          .rules = options_.rules},
                 .behind_ns = steps_since_now()}),
      application_(
          {.name = options_.program, .body = options_.body, .robots = {options_.robot}, .session_id = run_id()}, clock_,
          store_, options_.records ? &recorder_ : nullptr),
      statistics_(channels_, clock_, board_, store_, options_.records ? &recorder_ : nullptr),
      clock_service_(system_ns() - monotonic_ns()),
      rules_(options_.rules),
      field_(field_of(options_.rules)),
      scenes_{.channels = channels_, .each_second = own.runtime.info().topic, .field = [this] {
                const std::lock_guard guard(rules_lock_);
                return field_;
              }} {
  application_.play_by(options_.played);
  application_.draw_downloads_by(options_.foxglove_file);
  application_.know_whole_by(options_.whole);
  net::declare_image_parameters(parameters_);
  if (options_.records) add_recording_service(recorder_, store_, parameters_, services_);
  net::add_clock_sync(services_, clock_, [this](const net::PeerClock& peer) {
    foresight::ClockSample sample;
    sample.set_source(foresight::ClockSample::SOURCE_PEER);
    sample.set_monotonic_ns(monotonic_ns());
    sample.set_system_ns(system_ns());
    sample.set_peer(peer.peer);
    sample.set_offset_ns(peer.offset_ns);
    if (peer.round_trip_ns) sample.set_round_trip_ns(*peer.round_trip_ns);
    own_.clock.write(sample, clock_.now_ns());
  });
  if (options_.recent) {
    recent_.emplace(channels_, *options_.recent);
    application_.recall_from(*recent_);
  }
  if (options_.game) {
    game_.emplace(*options_.game, *own_.robot, clock_, recorder_, parameters_);
    application_.tell_game_by([this] { return game_->status(); });
  }
  set_report_listener([this](const Report& report) { write_log(report); });
}

Runtime::~Runtime() {
  set_report_listener({});
  stop();
}

void Runtime::stop() {
  if (server_) server_->stop();
}

void Runtime::write_log(const Report& report) {
  foresight::LogText text;
  text.set_level(level_of(report.level));
  text.set_source(report.source);
  text.set_text(report.sentence);
  own_.log.write(text, clock_.now_ns());
}

Result<void> Runtime::start() {
  Result<net::AccessOptions> access = access_options(options_.server);
  if (!access) return access.failure();
  server_ = std::make_unique<net::Server>(
      server_options(options_, std::move(*access)), channels_,
      [this](const memory::ChannelInfo& source) { return derived_from(source); }, streams_, clock_, parameters_,
      services_, application_);
  if (game_)  // before the first client can ask for its status
    if (Result<void> listening = game_->start(); !listening) return listening;
  application_.count_clients_by([this] { return server_->statistics().clients.size(); });
  if (Result<void> started = server_->start(); !started) return started;
  const std::string& address = options_.server.bind.front();
  const bool by_name = address == "127.0.0.1" || address == "0.0.0.0" || address == "::" || address == "::1";
  std::printf("http://%s:%u/\n", by_name ? "localhost" : address.c_str(), server_->port());
  std::fflush(stdout);
  return {};
}

std::vector<net::Derived> Runtime::derived_from(const memory::ChannelInfo& source) const {
  std::vector<net::Derived> derived = net::derived_channels(source, parameters_);
  for (net::Derived& scene : net::scene_channels(source, scenes_)) derived.push_back(std::move(scene));
  return derived;
}

Result<void> Runtime::record(std::string_view name, std::string_view profile) {
  const Result<std::uint64_t> request = recorder_.want(name, profile, recorded_objects(parameters_));
  if (!request) return request.failure();
  parameters_.update("recording", true);
  return {};
}

Result<void> Runtime::record_only(const std::string& objects) { return parameters_.set("recording_objects", objects); }

void Runtime::know_rules(const std::string& rules) {
  {
    const std::lock_guard guard(rules_lock_);
    if (!rules_.empty()) return;
    rules_ = rules;
    field_ = field_of(rules);
  }
  recorder_.know_rules(rules);
  server_->set_metadata("rules", rules);
}

void Runtime::run(const std::function<bool()>& tick) {
  std::uint64_t next_second = monotonic_ns();
  bool goes_on = true;
  while (goes_on) {
    const Result<void> done = attempt("housekeeping", [&] {
      goes_on = tick();
      if (game_) game_->follow();
      if (monotonic_ns() < next_second) return;
      next_second += kSecond;
      every_second();
    });
    if (!done) report(Level::error, "runtime", done.error());
    if (goes_on && wait_for_end(kTickNs)) break;
  }
  // the files of a recording are closed when the process ends
  if (recorder_.status().state != logging::RecordingStatus::State::off) end_within(kEndOfRecordingNs);
}

void Runtime::every_second() {
  board_.start_missing_threads();
  own_.clock.write(clock_service_.sample(monotonic_ns(), system_ns()), clock_.now_ns());
  foresight::RuntimeStatistics statistics = statistics_.collect(server_->statistics());
  if (options_.add_statistics) options_.add_statistics(statistics);
  own_.runtime.write(statistics, clock_.now_ns());
  if (!options_.records) return;
  recorder_.tend();
  // this reads all sessions, and is of no use while all of them are young or kept
  if (monotonic_ns() < next_room_ns_ || store_.size_bytes() <= store_.max_bytes()) return;
  (void)store_.make_room(0, clock_.now_ns());
  next_room_ns_ = monotonic_ns() + kRoomNs;
}

}  // namespace robot::app
