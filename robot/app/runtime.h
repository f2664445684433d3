// Everything that one process runs: the threads, their owners, tasks and rates.
//
//   thread            from      does                                                          how often
//   main              run()     statistics, clock samples, room on the disk, files of the      once a second; 10 Hz
//                             session; the body's tick, sessions of a game
//   end               signals.h takes SIGINT and SIGTERM; ends a process whose end takes too long  once
//   net               Server    sockets: HTTP, WebSocket                                       on each event
//   net status        Server    answers /api/status                                            on request
//   net files         Server    answers about sessions and recordings                          on request
//   net checksums     Server    computes checksums of recordings                               on request
//   net downloads     Server    reads pieces of downloads                                      on request
//   net <helper>      Server    starts and stops loggers; control                              on request
//   net questions     Server    asks foresight for clients and waits for the answer            on request
//   log <object>      board     carries one memory object to a file                            each version
//   log recent        RecentPast  keeps the last minutes of all small objects                  five times a second
//   log watched       board     three threads carry the watched memory objects to the server   each version
//   log bell          board     wakes these threads when versions wait                         250 Hz
//   parser            board     carries one stream of a recording into memory (replay)         each message
//   playhead          ClientPlayhead  plays a recording for one page with its own time (play)  each message
//   door              Door      accepts processes of the team, removes those that have ended   on connect; 10 Hz
//   parser            board     carries one object that such a process writes into memory      each message
//   log <object>      board     carries one object to such a process that reads it             each version
//   game              GameService  receives the GameController (--game-controller)             each packet
//   team              GameService  answers it (--return-packets), sends team messages          1 Hz; within budget
//                                  (--team-messages)
//   nao               NaoBody   writes LoLA's sensor data, commands the guardian (nao)         each cycle, 83 Hz
//   camera top        NaoCameras  writes images and camera matrices (nao)                      30 Hz
//   camera bottom     NaoCameras  the same
//   relay             RobotLink  carries one robot's channels into memory (foresight-lab relay) each message
//   truth <number>    SensorWatch  reads a depth sensor, finds robots and ball (foresight-lab truth)  30 Hz
//   truth feed        FeedWatch   receives SSL-Vision (foresight-lab truth)                      each packet
//   agent             AgentThread  decides with our behaviour (--behaviour)                    30 Hz
//   simulation        SimBody   plays the game and writes all robots' memories (sim)           30 Hz x speed
//   advisor           Advisor   reads questions in memory, asks as the captain, follows the    each question; 10 Hz
//                               captain's choice, scores forecasts
//   advice            Foreseer  answers each question at its deadline                          each question
//   foresee           Foreseer  plays the rollouts of a question                               during a question
//
// Loggers, parsers, the advisor and the net threads run at nice 10, so that behaviour and motion have priority. On a
// robot rollouts run at idle priority; on the lab machine they run at the priority of the loggers. The deadline of a
// question is kept by a thread of normal priority.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "proto/foresight/sim.pb.h"
#include "robot/app/application.h"
#include "robot/app/server_settings.h"
#include "robot/app/services/clock_service.h"
#include "robot/app/services/game_service.h"
#include "robot/app/services/statistics_service.h"
#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/report.h"
#include "robot/core/result.h"
#include "robot/logging/recent/recent_past.h"
#include "robot/logging/sessions/recorder.h"
#include "robot/logging/sessions/session_store.h"
#include "robot/logging/streams/board.h"
#include "robot/memory/channels.h"
#include "robot/memory/memory.h"
#include "robot/net/foxglove/parameters.h"
#include "robot/net/foxglove/services.h"
#include "robot/net/scene/scene_channels.h"
#include "robot/net/serve/board_streams.h"
#include "robot/net/serve/server.h"

namespace robot::app {

/// The names and the parts of a process.
struct RuntimeOptions {
  std::string program;  // "foresight-robot"
  std::string body;     // "replay", …
  std::string robot;    // "14/2"
  int team = 0, player = 0;
  std::string rules;    // of the game, which give its field: for viewers and sessions; empty: unknown
  std::string session;  // name of the played session, for viewers; empty: none, or several
  ServerSettings server;
  std::filesystem::path log_folder = "logs";
  std::uint64_t log_bytes = 4'000'000'000;                             // all sessions together
  bool records = true;                                                 // false: there is no recorder
  std::optional<logging::RecentPastLimits> recent;                     // of the last minutes; absent: they are not kept
  net::Playback* playback = nullptr;                                   // of the played recording; outlives the runtime
  std::function<net::HttpResponse(const net::PlayedRequest&)> played;  // serves parts of that recording; may be empty
  FoxgloveFile foxglove_file;                                          // makes downloads with ?foxglove; may be empty
  std::function<net::HttpResponse(const net::Target&, const net::ClientLeft&)>
      whole;                                                          // answers about all of it; likewise
  std::optional<GameOptions> game;                                    // follow a real game; needs `records`
  std::function<void(foresight::RuntimeStatistics&)> add_statistics;  // adds the program's own entries; may be empty
};

/// The objects that a process writes about itself.
struct OwnObjects {
  memory::MemoryObject<foresight::RuntimeStatistics>& runtime;
  memory::MemoryObject<foresight::ClockSample>& clock;
  memory::MemoryObject<foresight::LogText>& log;
  memory::Memory* robot = nullptr;  // the whole memory of our robot; null on the lab machine, which follows no game
};

/// Returns these objects of `memory`, which outlives them.
OwnObjects own_objects(memory::Memory& memory);

/// The recorder, the server and the services of one process. Used by the main thread.
class Runtime {
 public:
  /// `clock` is the time base of all channels; it and `own` outlive the runtime.
  Runtime(RuntimeOptions options, const Clock& clock, OwnObjects own);
  ~Runtime();

  memory::Channels& channels() { return channels_; }
  logging::LoggingBoard& board() { return board_; }
  const logging::Recorder& recorder() const { return recorder_; }
  const logging::SessionStore& store() const { return store_; }
  net::Parameters& parameters() { return parameters_; }
  net::Server& server() { return *server_; }
  net::Services& services() { return services_; }  // complete before start()

  /// Opens the ports, starts the server and prints its address. Returns an Error if a port is taken.
  Result<void> start();

  /// Begins a session now, or as soon as the disk permits it. Returns an Error for a wrong name or profile.
  Result<void> record(std::string_view name, std::string_view profile);

  /// Sets the objects that recordings contain, "ball,pose"; empty: all. Returns an Error for an unknown object. Call it
  /// when all objects are listed.
  Result<void> record_only(const std::string& objects);

  /// Sets the rules of the game, for viewers and sessions, unless they are known already. Any thread, after start().
  void know_rules(const std::string& rules);

  /// Does the housekeeping and calls `tick` ten times a second, until `tick` returns false or SIGINT or SIGTERM
  /// arrives.
  void run(const std::function<bool()>& tick);

  /// Stops the server. After it has returned, no service runs or is called. A second call has no effect.
  void stop();

 private:
  void every_second();
  void write_log(const Report& report);
  std::vector<net::Derived> derived_from(const memory::ChannelInfo& source) const;

  const RuntimeOptions options_;
  const Clock& clock_;
  OwnObjects own_;
  std::uint64_t next_room_ns_ = 0;  // [monotonic]

  memory::Channels channels_;
  logging::LoggingBoard board_;
  logging::SessionStore store_;
  logging::Recorder recorder_;
  net::BoardStreams streams_{board_};
  net::Parameters parameters_;
  net::Services services_;
  Application application_;
  StatisticsService statistics_;
  ClockService clock_service_;
  Mutex rules_lock_;  // guards the next two
  std::string rules_;
  foresight::Field field_;
  net::SceneSources scenes_;
  std::optional<GameService> game_;
  std::optional<logging::RecentPast> recent_;
  std::unique_ptr<net::Server> server_;
};

}  // namespace robot::app
