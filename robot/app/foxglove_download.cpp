#include "robot/app/foxglove_download.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "robot/app/rules_field.h"
#include "robot/core/clock.h"
#include "robot/core/scratch_file.h"
#include "robot/logging/mcap/mcap_file.h"
#include "robot/logging/mcap/ordered_reader.h"
#include "robot/logging/mcap/writer.h"
#include "robot/memory/channels.h"
#include "robot/net/foxglove/derived_channels.h"
#include "robot/net/foxglove/parameters.h"
#include "robot/net/scene/points.h"
#include "robot/net/scene/scene_channels.h"

namespace robot::app {
namespace {

constexpr std::uint64_t kSpareBytes = 200'000'000;   // of the disk, which the recorder may need
constexpr std::uint64_t kLookEvery = 256;            // messages between two looks at the disk and the client
constexpr std::uint64_t kChunkTimeNs = 5 * kSecond;  // of the recording: larger chunks are smaller when packed
constexpr const char* kFieldSource = "/field";       // no recording has this topic

/// A recording in the order of time, as the channels of a memory, and the messages that are derived from it.
class Derivation {
 public:
  Derivation(std::shared_ptr<const logging::McapFile> recorded, const std::string& rules)
      : recorded_(std::move(recorded)),
        sources_{
            .channels = channels_, .each_second = kFieldSource, .field = [field = field_of(rules)] { return field; }} {
    net::declare_image_parameters(parameters_);
    const auto& index = recorded_->index();
    for (const auto& [id, described] : index.channels) {
      auto channel = std::make_shared<memory::RawChannel>(logging::channel_info(described, index.schemas), clock_);
      if (channels_.add(channel)) add(id, std::move(channel));
    }
    field_ = std::make_shared<memory::RawChannel>(memory::ChannelInfo{.topic = kFieldSource}, clock_);
    add(0, field_);  // no channel of ours has the id 0
  }

  const std::vector<memory::ChannelInfo>& infos() const { return infos_; }

  /// Writes everything that is derived from the recording.
  Result<void> write(logging::McapWriter& writer, const std::filesystem::path& folder, const net::ClientLeft& left) {
    logging::OrderedReader reader(recorded_);
    for (std::uint64_t messages = 0;; ++messages) {
      if (messages % kLookEvery == 0)
        if (Result<void> goes_on = look(folder, left); !goes_on) return goes_on;
      const auto message = reader.next();
      if (!message) continue;  // a damaged chunk; its reader continues after it
      if (!*message) return {};
      if (Result<void> written = take(**message, writer); !written) return written;
    }
  }

 private:
  struct Output {
    std::size_t channel = 0;  // index in infos_
    net::Convert convert;
    std::uint64_t sequence = 0;
  };
  struct Input {
    std::shared_ptr<memory::RawChannel> channel;
    std::vector<Output> outputs;
  };

  void add(std::uint16_t id, std::shared_ptr<memory::RawChannel> channel) {
    const memory::ChannelInfo& info = channel->info();
    std::vector<net::Derived> derived = net::derived_channels(info, parameters_);
    std::erase_if(derived, [](const net::Derived& one) { return one.info.topic.ends_with("/raw"); });
    for (auto& more : {net::scene_channels(info, sources_), net::point_channels(info, sources_)})
      derived.insert(derived.end(), more.begin(), more.end());
    Input& input = inputs_[id];
    input.channel = std::move(channel);
    for (net::Derived& one : derived) {
      if (channels_.find(one.info.topic)) continue;  // the recording has it already
      input.outputs.push_back({.channel = infos_.size(), .convert = one.make_convert()});
      infos_.push_back(std::move(one.info));
    }
  }

  /// Returns an Error if the work should end.
  static Result<void> look(const std::filesystem::path& folder, const net::ClientLeft& left) {
    if (left && left()) return Error{"download: the client has left"};
    std::error_code unknown;
    const std::filesystem::space_info space = std::filesystem::space(folder, unknown);
    if (!unknown && space.available < kSpareBytes)
      return Error{"download: the disk of " + folder.string() + " has less than 200 MB left; leave out ?foxglove"};
    return {};
  }

  Result<void> take(const logging::McapMessage& message, logging::McapWriter& writer) {
    const auto input = inputs_.find(message.channel_id);
    if (input == inputs_.end()) return {};
    const std::uint64_t capture_ns = message.record.capture_ns;
    if (Result<void> taken = input->second.channel->write_bytes(message.record.bytes, capture_ns); !taken) return taken;
    // the field comes first and again whenever it is another one
    std::string field = net::known_field(sources_).SerializeAsString();
    if (field != shown_field_) {
      shown_field_ = std::move(field);
      if (Result<void> taken = field_->write_bytes({}, capture_ns); !taken) return taken;
      if (Result<void> written = put(inputs_.at(0), writer); !written) return written;
    }
    return put(input->second, writer);
  }

  static Result<void> put(Input& input, logging::McapWriter& writer) {
    const memory::VersionPtr version = input.channel->newest();
    for (Output& output : input.outputs) {
      const auto bytes = output.convert(*version);
      if (!bytes || !*bytes) continue;  // a damaged message, or one that is not due
      const logging::OutMessage message{.sequence = ++output.sequence,
                                        .capture_ns = version->capture_ns(),
                                        .publish_ns = version->capture_ns(),
                                        .bytes = **bytes};
      if (Result<void> written = writer.write(output.channel, message, version->capture_ns()); !written) return written;
    }
    return {};
  }

  const std::shared_ptr<const logging::McapFile> recorded_;
  ManualClock clock_{0};
  net::Parameters parameters_;
  memory::Channels channels_;
  net::SceneSources sources_;
  std::map<std::uint16_t, Input> inputs_;  // by the channel id of the recording
  std::vector<memory::ChannelInfo> infos_;
  std::shared_ptr<memory::RawChannel> field_;
  std::string shown_field_ = "none";
};

}  // namespace

Result<std::shared_ptr<const ByteSource>> foxglove_file(std::shared_ptr<const ByteSource> recorded,
                                                        const std::filesystem::path& folder, const std::string& rules,
                                                        const net::ClientLeft& left) {
  const auto file = logging::McapFile::open(std::move(recorded));
  if (!file) return file.failure();
  const auto& channels = (*file)->index().channels;
  const std::uint16_t last = channels.empty() ? std::uint16_t{0} : channels.rbegin()->first;
  Derivation derivation(*file, rules);
  const auto scratch = ScratchFile::make(folder);
  if (!scratch) return scratch.failure();
  auto sink = scratch->sink();
  if (!sink) return sink.failure();
  auto writer = logging::McapWriter::open(std::move(*sink), derivation.infos(),
                                          {.first_channel_id = static_cast<std::uint16_t>(last + 1),
                                           .metadata = {},
                                           .compression = logging::Compression::lz4,
                                           .chunk_time_ns = kChunkTimeNs});
  if (!writer) return writer.failure();
  if (Result<void> written = derivation.write(*writer, folder, left); !written) return written.failure();
  if (Result<void> closed = writer->close(); !closed) return closed.failure();
  return scratch->source();
}

}  // namespace robot::app
