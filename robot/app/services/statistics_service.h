// The contents of the memory object `runtime`: streams, loggers, recording, clients and use of the machine.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "proto/foresight/runtime.pb.h"
#include "robot/app/process_usage.h"
#include "robot/core/clock.h"
#include "robot/logging/sessions/recorder.h"
#include "robot/logging/sessions/session_store.h"
#include "robot/logging/streams/board.h"
#include "robot/memory/channels.h"
#include "robot/net/foxglove/statistics.h"

namespace robot::app {

/// The collector of statistics of the whole process, once a second. Used by one thread.
class StatisticsService {
 public:
  /// All references outlive this. `recorder` may be null.
  StatisticsService(const memory::Channels& channels, const Clock& clock, const logging::LoggingBoard& board,
                    const logging::SessionStore& store, const logging::Recorder* recorder)
      : channels_(channels), clock_(clock), board_(board), store_(store), recorder_(recorder) {}

  /// Collects the statistics. Rates are means since the last call.
  foresight::RuntimeStatistics collect(const net::ServerStatistics& server);

 private:
  void add_streams(foresight::RuntimeStatistics& to, double seconds);
  void add_recording(foresight::RuntimeStatistics& to, double seconds);
  void add_process(foresight::RuntimeStatistics& to, double seconds);

  const memory::Channels& channels_;
  const Clock& clock_;
  const logging::LoggingBoard& board_;
  const logging::SessionStore& store_;
  const logging::Recorder* const recorder_;

  // values of the last call
  std::uint64_t last_ns_ = 0;  // [monotonic]
  std::map<std::string, std::uint64_t> counts_;
  std::uint64_t recorded_bytes_ = 0, cpu_ns_ = 0;
  const std::uint64_t started_ns_ = monotonic_ns();
};

}  // namespace robot::app
