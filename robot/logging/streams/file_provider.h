// Providers for files: one MCAP file holds one memory object.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/mcap_file.h"
#include "robot/logging/mcap/ordered_reader.h"
#include "robot/logging/mcap/reader.h"
#include "robot/logging/mcap/writer.h"
#include "robot/logging/streams/provider.h"

namespace robot::logging {

/// The recording of one channel into a new file. It never overwrites an existing file.
class FileOutProvider final : public OutProvider {
 public:
  /// The logger's thread wakes for a quarter of a chunk at least: the writer collects messages into chunks anyway.
  static constexpr Patience kPatience{.time_ns = 100 * kMillisecond, .bytes = 64 * 1024};

  FileOutProvider(std::filesystem::path path, McapOptions options);

  Result<void> open(const memory::ChannelInfo& info) override;
  Result<void> write(const memory::VersionPtr& version) override;
  Patience patience() const override { return kPatience; }
  std::uint64_t flush_due_ns() const override;
  Result<void> flush() override;
  Result<void> close() override;

  /// Sizes and counts up to now. Any thread.
  std::uint64_t size_bytes() const { return size_bytes_.load(std::memory_order_relaxed); }
  std::uint64_t messages() const { return messages_.load(std::memory_order_relaxed); }  // in the file
  std::uint64_t lost_afterwards() const override { return lost_.load(std::memory_order_relaxed); }

  std::uint64_t buffered() const override { return writer_ ? writer_->collected() : 0; }

 private:
  template <class Call>
  Result<void> counted(Call&& call);

  std::filesystem::path path_;
  McapOptions options_;
  std::optional<McapWriter> writer_;
  std::uint64_t taken_ = 0;  // messages whose write() succeeded
  std::atomic<std::uint64_t> size_bytes_ = 0, messages_ = 0, lost_ = 0;
};

/// The stream of a file with one channel, or of one topic of a file with many. The file's writer may have died.
class FileInProvider final : public InProvider {
 public:
  /// A file with one channel. Its messages come in the order of the file.
  explicit FileInProvider(std::filesystem::path path) : path_(std::move(path)) {}

  /// A topic of a file with many. Its messages come in the order of their capture times. If channels of the topic have
  /// different schemas or encodings, the stream has some of them, as topic_streams() chooses.
  FileInProvider(std::filesystem::path path, std::string topic) : path_(std::move(path)), topic_(std::move(topic)) {}

  /// As before, for a file that is open already.
  FileInProvider(std::shared_ptr<const McapFile> file, std::string topic)
      : path_(file->source().name()), topic_(std::move(topic)), file_(std::move(file)) {}

  /// Returns the channel. Returns an Error if the file has no channel of the topic, or without a topic, if it does not
  /// hold exactly one channel.
  Result<memory::ChannelInfo> open() override;

  /// As InProvider::read. Returns an Error once for each damage, after all messages before it. The next call continues
  /// after the damage.
  Result<std::optional<Record>> read() override;

  void cancel() override { cancelled_.store(true, std::memory_order_relaxed); }

  Result<void> seek(std::uint64_t capture_ns) override;

 private:
  Result<std::optional<Record>> read_on();
  Result<memory::ChannelInfo> open_topic();
  Result<void> seek_topic(std::uint64_t capture_ns);

  const std::filesystem::path path_;
  const std::optional<std::string> topic_;
  std::shared_ptr<const McapFile> file_;  // of a topic
  std::optional<McapReader> reader_;      // without a topic
  std::optional<OrderedReader> ordered_;  // of a topic
  std::deque<Record> ahead_;              // records that seek() has read already
  std::atomic<bool> cancelled_ = false;
};

}  // namespace robot::logging
