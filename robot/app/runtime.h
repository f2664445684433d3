// Everything one process runs: who runs what, and how often.
//
//   thread            from      does                                                          how often
//   main              run()     statistics, clock samples, room on the disk; the body's tick,  once a second; 10 Hz
//                             sessions of a game
//   net               Server    sockets: HTTP, WebSocket                                       when there is something
//   net <helper>      Server    reads downloads; starts and stops loggers; control             when asked
//   net questions     Server    asks foresight for people and waits for the answer             when asked
//   log <object>      board     carries one memory object to a file                            each version
//   log <object>      board     carries one memory object to the server, while it is watched   each version
//   parser            board     carries one stream of a recording into memory (replay)         each message
//   door              Door      takes in processes of the team, clears away those that went    when one comes; 10 Hz
//   parser            board     carries one object that such a process writes into memory      each message
//   log <object>      board     carries one object to such a process that reads it             each version
//   game              GameService  hears the GameController (--game-controller)                each packet
//   team              GameService  answers it (--return-packets), tells the teammates          1 Hz; as the budget allows
//                                  (--team-messages)
//   nao               NaoBody   writes what LoLA tells, gives the guardian its orders (nao)    each cycle, 83 Hz
//   camera top        NaoCameras  writes images, and where the camera was (nao)               30 Hz
//   camera bottom     NaoCameras  the same
//   relay             RobotLink  carries one robot's channels into memory (foresight-lab relay) when there is something
//   simulation        SimBody   plays the game and writes all robots' memories (sim)           30 Hz x speed
//   advisor           Advisor   hears questions in memory, asks as the captain, follows what   when there is one; 10 Hz
//                               the captain told, scores forecasts
//   advice            Foreseer  answers each question at its deadline                          each question
//   foresee           Foreseer  plays the futures of a question                                while one runs
//
// Loggers, parsers, the advisor and the net threads run at nice 10: whoever decides and moves comes first. The futures get
// what nobody else wants, on the lab machine as much as the loggers; their deadline is kept at normal priority.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "robot/app/application.h"
#include "robot/app/server_settings.h"
#include "robot/app/services/clock_service.h"
#include "robot/app/services/game_service.h"
#include "robot/app/services/statistics_service.h"
#include "robot/core/clock.h"
#include "robot/core/report.h"
#include "robot/core/result.h"
#include "robot/logging/sessions/recorder.h"
#include "robot/logging/sessions/session_store.h"
#include "robot/logging/streams/board.h"
#include "robot/memory/channels.h"
#include "robot/memory/memory.h"
#include "robot/net/foxglove/parameters.h"
#include "robot/net/foxglove/services.h"
#include "robot/net/serve/board_streams.h"
#include "robot/net/serve/server.h"

namespace robot::app {

struct RuntimeOptions {
  std::string program;  // "foresight-robot"
  std::string body;     // "replay", …
  std::string robot;    // "14/2"
  int team = 0, player = 0;
  ServerSettings server;
  std::filesystem::path log_folder = "logs";
  std::uint64_t log_bytes = 4'000'000'000;  // all sessions together
  bool records = true;                      // false where recordings are only shown
  net::Playback* playback = nullptr;        // of the recording that is played; outlives the runtime
  std::function<net::HttpResponse(const net::PlayedRequest&)> played;  // tells parts of that recording; may be empty
  std::optional<GameOptions> game;                                     // where a real game may be; needs `records`
  std::function<void(foresight::RuntimeStatistics&)> add_statistics;  // adds what only this program knows; may be empty
};

/// The objects a process writes about itself.
struct OwnObjects {
  memory::MemoryObject<foresight::RuntimeStatistics>& runtime;
  memory::MemoryObject<foresight::ClockSample>& clock;
  memory::MemoryObject<foresight::LogText>& log;
  memory::Memory* robot = nullptr;  // all of our robot's; null on the lab machine, which hears no GameController
};

/// Those of a process that has our robot's whole memory, which outlives it.
OwnObjects own_objects(memory::Memory& memory);

class Runtime {
 public:
  /// `clock` is the time base of all channels; it and `own` outlive the runtime.
  Runtime(RuntimeOptions options, const Clock& clock, OwnObjects own);
  ~Runtime();

  memory::Channels& channels() { return channels_; }
  logging::LoggingBoard& board() { return board_; }
  const logging::Recorder& recorder() const { return recorder_; }
  net::Parameters& parameters() { return parameters_; }
  net::Server& server() { return *server_; }
  net::Services& services() { return services_; }  // complete before start()

  /// Opens the ports. An Error, in one sentence, if that cannot be.
  Result<void> start();

  /// Begins a session, as a person would by the service start_recording.
  Result<void> record(std::string_view name, std::string_view profile);

  /// Does the housekeeping and calls `tick` ten times a second, until `tick` returns false or the process is told to
  /// end (SIGINT, SIGTERM).
  void run(const std::function<bool()>& tick);

  /// From now on nobody is served. Once it returns no service is being called. Again is nothing.
  void stop();

 private:
  void every_second();
  void write_log(const Report& report);

  const RuntimeOptions options_;
  const Clock& clock_;
  OwnObjects own_;

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
  std::optional<GameService> game_;
  std::unique_ptr<net::Server> server_;
};

}  // namespace robot::app
