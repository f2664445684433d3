#include "robot/app/play.h"

#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "robot/app/clock_option.h"
#include "robot/app/foxglove_download.h"
#include "robot/app/lab_foresight.h"
#include "robot/app/lab_objects.h"
#include "robot/app/played_range.h"
#include "robot/app/recording_playback.h"
#include "robot/app/runtime.h"
#include "robot/app/services/futures_service.h"
#include "robot/app/services/reasons_service.h"
#include "robot/app/services/step_service.h"
#include "robot/app/services/watch_service.h"
#include "robot/app/services/what_if_service.h"
#include "robot/app/signals.h"
#include "robot/app/whole_answers.h"
#include "robot/body/replay/replay.h"
#include "robot/core/report.h"
#include "robot/lab/clocks/session_times.h"
#include "robot/lab/mapping/mapping.h"
#include "robot/lab/whole/whole_recording.h"

namespace robot::app {
namespace {

/// Returns the shift of the times of each session, and prints the reasons. Empty for a single session.
Result<std::vector<ClockShift>> shifts_between(const PlayOptions& options) {
  std::vector<ClockShift> shifts;
  const auto most_ns = clock_offset_ns(options.max_clock_offset);
  if (!most_ns) return most_ns.failure();
  if (options.sessions.size() < 2) return shifts;
  std::vector<logging::Session> sessions;
  for (const std::filesystem::path& path : options.sessions) {
    auto session = logging::open_session(path);
    if (!session) return session.failure();
    sessions.push_back(std::move(*session));
  }
  const auto times = lab::session_times(sessions, *most_ns);
  if (!times) return times.failure("play");
  for (const lab::Agreement& agreement : times->agreements) {
    shifts.push_back(agreement.shift());
    if (!agreement.sentence.empty()) std::printf("%s\n", agreement.sentence.c_str());
  }
  return shifts;
}

std::vector<body::MadeStream> made_by(const lab::Mapping& mapping) {
  std::vector<body::MadeStream> made;
  for (const lab::TopicRule& rule : mapping.topics)
    made.push_back(
        {.from = rule.from, .to = rule.info.topic, .make = [rule](std::unique_ptr<logging::InProvider> stream) {
           return std::make_unique<lab::MappedInProvider>(std::move(stream), rule);
         }});
  return made;
}

/// Returns the name of the session that is played, or an empty string for several.
std::string name_of(const std::vector<std::filesystem::path>& sessions) {
  return sessions.size() == 1 ? logging::plain_path(sessions.front()).filename().string() : std::string();
}

/// Plays until the end of the program, or until a client wants to watch another session, which it returns. Stores the
/// port in `options`, so that the next session is served at the same address.
Result<std::optional<std::filesystem::path>> play_one(PlayOptions& options) {
  // until a thread starts, the signals end the process at once, also while it reads a large file
  const auto shifts = shifts_between(options);
  if (!shifts) return shifts.failure();
  std::optional<lab::Mapping> mapping;
  if (!options.map.empty()) {
    auto read = lab::read_mapping(options.map);
    if (!read) return read.failure();
    mapping = std::move(*read);
  }
  auto replay =
      body::Replay::open(options.sessions, {.speed = options.speed,
                                            .loop = options.loop,
                                            .robot = "",
                                            .shifts = *shifts,
                                            .made = mapping ? made_by(*mapping) : std::vector<body::MadeStream>(),
                                            .skipped_objects = {"lab/1/runtime", "lab/1/clock"}});
  if (!replay) return Error{(mapping ? mapping->name + ": " : "") + replay.error()};
  block_end_signals();
  const std::string robot = mapping ? mapping->robot : (*replay)->robots().front();
  const Clock& clock = (*replay)->clock();
  const auto own = std::make_shared<LabObjects>(clock);
  RecordingPlayback playback(**replay, options.speed, options.loop);
  // these outlive the server, which calls them
  lab::WholeRecording whole(**replay);
  LabForesight seer(options.foresight);
  WatchWish wish;
  Runtime runtime({.program = "foresight-lab",
                   .body = "recording",
                   .robot = robot,
                   .rules = (*replay)->rules(),
                   .session = name_of(options.sessions),
                   .server = options.server,
                   .log_folder = logging::log_folder_of(options.sessions.front()),
                   .log_bytes = std::numeric_limits<std::uint64_t>::max(),
                   .records = false,
                   .playback = &playback,
                   .played = [&replay](const net::PlayedRequest& asked) { return played_range(**replay, asked); },
                   .foxglove_file = foxglove_file,
                   .whole = [&whole](const net::Target& target,
                                     const net::ClientLeft& left) { return whole_answer(whole, target, left); }},
                  clock, {.runtime = own->runtime, .clock = own->clock_sample, .log = own->log});
  if (Result<void> listed = list(own, runtime.channels()); !listed) return listed.failure();
  // viewers see the last of them in the log
  for (const std::string& note : (*replay)->notes()) report(Level::warning, "recording", note);
  const auto stream_of = [&replay](const std::string& topic) { return (*replay)->stream_of(topic); };
  add_what_if_service(
      runtime.services(), robot, seer.strategies(),
      [&](const std::string& whose, const foresight::WhatIf& question, std::optional<std::uint64_t> playhead_ns) {
        return seer.ask(stream_of, whose, question, playhead_ns.value_or(clock.now_ns()));
      });
  add_reasons_service(runtime.services(), runtime.channels(),
                      {.strategies = options.foresight.strategies, .rules = options.foresight.rules});
  add_futures_service(runtime.services(), runtime.channels(),
                      {.strategies = options.foresight.strategies, .rules = options.foresight.rules});
  add_step_service(runtime.services(), stream_of);
  // a mapping fits the recordings of one program
  if (!mapping) add_watch_service(runtime.services(), runtime.store(), wish);
  if (Result<void> started = runtime.start(); !started) return started.failure();
  options.server.port = runtime.server().port();
  if (Result<void> started = (*replay)->start(runtime.channels(), runtime.board()); !started) return started.failure();
  bool answered = false;  // the client of a wish has its answer
  runtime.run([&] {
    if ((*replay)->tick() == body::Replay::Tick::began_again) runtime.server().restart_time();
    return !(wish.get() && std::exchange(answered, true));  // a recording that has ended still shows its last moment
  });
  (*replay)->stop();
  seer.hurry();
  return wish.get();
}

}  // namespace

Result<void> play(PlayOptions options) {
  while (true) {
    const auto next = play_one(options);
    if (!next) return next.failure();
    if (!*next) return {};
    options.sessions = {**next};
  }
}

}  // namespace robot::app
