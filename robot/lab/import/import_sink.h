// The output of importers: messages and a report.
#pragma once

#include <google/protobuf/message.h>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace robot::lab {

/// A receiver of the messages of a recording. Used by one thread.
class ImportSink {
 public:
  virtual ~ImportSink() = default;

  /// Takes one message of the memory object `object` ("ball"), or of the topic `object` if it starts with '/'
  /// ("/truth/world"). `capture_ns` [ns since the epoch]. Within one object times normally do not decrease, but a
  /// damaged file may contain any times. An Error ends the import.
  virtual Result<void> message(std::string_view object, std::uint64_t capture_ns,
                               const google::protobuf::Message& value) = 0;
};

/// The result of an import.
struct ImportReport {
  std::map<std::string, std::uint64_t> messages;  // number of messages in the sink, by object
  std::string about;                  // one sentence about the data, for the session's description; or empty
  std::vector<std::string> warnings;  // sentences about omitted or odd data of a file that is not damaged
  std::string damage;                 // one sentence: place and kind of the damage; empty if there is none
};

/// A sink that passes messages on to `sink` and counts them in `report`. Both outlive it.
class CountingSink final : public ImportSink {
 public:
  CountingSink(ImportSink& sink, ImportReport& report) : sink_(sink), report_(report) {}

  Result<void> message(std::string_view object, std::uint64_t capture_ns,
                       const google::protobuf::Message& value) override;

 private:
  ImportSink& sink_;
  ImportReport& report_;
};

}  // namespace robot::lab
