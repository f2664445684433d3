// Translation of other programs' recordings. A file maps their topics to our objects:
//
//   {
//     "robot": "14/2",
//     "topics": {
//       "/vision/ball": {"object": "ball", "fields": {"x": "position.x", "y": {"from": "position.y", "scale": 0.001},
//                                                     "seen_ns": "@time", "deviation": {"value": 0.1}}},
//       "/tracker": {"object": "/truth/world", "fields": {"robots": {"each": "players", "fields": {"x": "at[0]"}}}}
//     }
//   }
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/json_library.h"
#include "robot/core/result.h"
#include "robot/logging/streams/provider.h"
#include "robot/memory/channel.h"

namespace google::protobuf {
class Descriptor;
class FieldDescriptor;
}  // namespace google::protobuf

namespace robot::lab {

/// The source of one field of our message.
struct FieldRule {
  const google::protobuf::FieldDescriptor* field = nullptr;
  std::string from;               // "position.x", "at[0]", "@time" (capture time [ns]); empty: `value`
  nlohmann::json value;           // a constant
  double scale = 1, add = 0;      // our value = scale * theirs + add
  nlohmann::json names;           // of an enum: their value, as text → our name; null: the same names
  std::vector<FieldRule> fields;  // of a message, or of each message of a list
};

/// A topic of the other program, and our object for it.
struct TopicRule {
  std::string from;          // their topic
  memory::ChannelInfo info;  // our channel
  const google::protobuf::Descriptor* message = nullptr;
  std::vector<FieldRule> fields;
};

/// The contents of a mapping file.
struct Mapping {
  std::string name;   // of the file
  std::string robot;  // "14/2": owner of the objects
  std::vector<TopicRule> topics;
};

/// Reads a mapping. An Error names the file, the place in it, the expected and the actual value.
Result<Mapping> parse_mapping(const std::string& name, std::string_view text);
Result<Mapping> read_mapping(const std::filesystem::path& file);

/// Translates one decoded message `theirs` of the topic `rule.from` to our serialised message. Returns an Error for a
/// value of a type that does not fit. A missing value is an Error with `strict`; otherwise its field stays absent.
Result<std::string> mapped(const TopicRule& rule, const nlohmann::json& theirs, std::uint64_t capture_ns, bool strict);

/// A stream of the other program, in protobuf or JSON, converted to a stream of our object.
class MappedInProvider final : public logging::InProvider {
 public:
  MappedInProvider(std::unique_ptr<logging::InProvider> stream, TopicRule rule);
  ~MappedInProvider() override;

  /// Returns our channel. Returns an Error if their encoding is another one, or if none of the first 100 messages fits
  /// the mapping.
  Result<memory::ChannelInfo> open() override;

  /// Returns the next message that fits. Others are skipped and counted; the first of them is returned as an Error.
  Result<std::optional<logging::Record>> read() override;
  Result<void> seek(std::uint64_t capture_ns) override { return stream_->seek(capture_ns); }
  std::uint64_t lost_before() const override { return stream_->lost_before() + lost_.load(std::memory_order_relaxed); }
  void cancel() override { stream_->cancel(); }

 private:
  class Reader;

  Result<void> check_first();
  Result<std::string> translate(const logging::Record& record, bool strict) const;

  const std::unique_ptr<logging::InProvider> stream_;
  const TopicRule rule_;
  std::unique_ptr<Reader> reader_;
  std::atomic<std::uint64_t> lost_ = 0;
};

}  // namespace robot::lab
