// Where importers put what they read, and what they say about it.
#pragma once

#include <google/protobuf/message.h>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace robot::lab {

/// Takes the messages of a recording. Used by one thread.
class ImportSink {
 public:
  virtual ~ImportSink() = default;

  /// One message of the memory object `object` ("ball"), or of the topic `object` if that starts with '/'
  /// ("/truth/world"). `capture_ns` [ns since the epoch]. Within one object times normally do not decrease, but a
  /// damaged file may hold any. An Error ends the import.
  virtual Result<void> message(std::string_view object, std::uint64_t capture_ns,
                               const google::protobuf::Message& value) = 0;
};

/// What an import found.
struct ImportReport {
  std::map<std::string, std::uint64_t> messages;  // how many went to the sink, by object
  std::vector<std::string> warnings;              // sentences: what was left out or looks odd, the file being whole
  std::string damage;  // one sentence: where the file is damaged and how; empty when it is whole
};

/// Counts in `report` what it hands on to `sink`; both outlive it.
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
