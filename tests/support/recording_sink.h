// Keeps the messages of an importer.
#pragma once

#include <google/protobuf/message.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "robot/lab/import/import_sink.h"

namespace tests {

class RecordingSink final : public robot::lab::ImportSink {
 public:
  struct Entry {
    std::string object;
    std::uint64_t capture_ns;
    std::shared_ptr<google::protobuf::Message> value;
  };
  std::vector<Entry> entries;

  robot::Result<void> message(std::string_view object, std::uint64_t capture_ns,
                              const google::protobuf::Message& value) override {
    std::shared_ptr<google::protobuf::Message> copy(value.New());
    copy->CopyFrom(value);
    entries.push_back({std::string(object), capture_ns, std::move(copy)});
    return {};
  }

  /// The values of `object`, which must be of type T, in order.
  template <class T>
  std::vector<const T*> of(std::string_view object) const {
    std::vector<const T*> values;
    for (const Entry& entry : entries)
      if (entry.object == object) values.push_back(dynamic_cast<const T*>(entry.value.get()));
    return values;
  }
};

/// Refuses everything.
class FullSink final : public robot::lab::ImportSink {
 public:
  robot::Result<void> message(std::string_view, std::uint64_t, const google::protobuf::Message&) override {
    return robot::Error{"disk full"};
  }
};

/// True if `some` are the first entries of `all`, bytes and times alike.
inline bool is_start_of(const std::vector<RecordingSink::Entry>& some, const std::vector<RecordingSink::Entry>& all) {
  if (some.size() > all.size()) return false;
  for (std::size_t i = 0; i < some.size(); ++i)
    if (some[i].object != all[i].object || some[i].capture_ns != all[i].capture_ns ||
        some[i].value->SerializeAsString() != all[i].value->SerializeAsString())
      return false;
  return true;
}

}  // namespace tests
