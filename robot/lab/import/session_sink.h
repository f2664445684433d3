// The sink that writes imported messages to a session.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "robot/lab/import/import_sink.h"
#include "robot/logging/sessions/session_writer.h"
#include "robot/memory/channel.h"

namespace robot::lab {

/// A sink that writes each object with its topic and schema in a robot's memory. Used by one thread.
class SessionSink final : public ImportSink {
 public:
  /// `robot` is "<team>/<player>"; `writer` outlives this.
  SessionSink(std::string_view robot, logging::SessionWriter& writer);

  Result<void> message(std::string_view object, std::uint64_t capture_ns,
                       const google::protobuf::Message& value) override;

 private:
  std::map<std::string, memory::ChannelInfo, std::less<>> channels_;  // by object
  logging::SessionWriter& writer_;
  std::string bytes_;
};

}  // namespace robot::lab
