// Streams that are files: one MCAP file for one memory object.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/logging/mcap/reader.h"
#include "robot/logging/mcap/writer.h"
#include "robot/logging/streams/provider.h"

namespace robot::logging {

/// Records one channel into a new file. An existing file is never overwritten.
class FileOutProvider final : public OutProvider {
 public:
  /// Messages are collected into chunks anyway: nobody is woken at once for less than a quarter of one.
  static constexpr Patience kPatience{.time_ns = 100 * kMillisecond, .bytes = 64 * 1024};

  FileOutProvider(std::filesystem::path path, McapOptions options);

  Result<void> open(const memory::ChannelInfo& info) override;
  Result<void> write(const memory::VersionPtr& version) override;
  Patience patience() const override { return kPatience; }
  std::uint64_t flush_due_ns() const override;
  Result<void> flush() override;
  Result<void> close() override;

  /// What came of it so far. Any thread.
  std::uint64_t size_bytes() const { return size_bytes_.load(std::memory_order_relaxed); }
  std::uint64_t messages() const { return messages_.load(std::memory_order_relaxed); }  // in the file
  std::uint64_t lost_afterwards() const override { return lost_.load(std::memory_order_relaxed); }

 private:
  Result<void> counted(Result<void> result);

  std::filesystem::path path_;
  McapOptions options_;
  std::optional<McapWriter> writer_;
  std::uint64_t refused_ = 0;  // messages whose write() failed
  std::atomic<std::uint64_t> size_bytes_ = 0, messages_ = 0, lost_ = 0;
};

/// Reads the file of one channel, also one whose writer died, or one channel of a file that holds many.
class FileInProvider final : public InProvider {
 public:
  /// `topic` names the channel of a file with many.
  explicit FileInProvider(std::filesystem::path path, std::optional<std::string> topic = {})
      : path_(std::move(path)), topic_(std::move(topic)) {}

  /// An Error if the file does not hold exactly one channel, or not the one of the topic.
  Result<memory::ChannelInfo> open() override;

  /// As InProvider::read. An Error names a damage, once, after everything before it was delivered;
  /// the next call goes on behind it.
  Result<std::optional<Record>> read() override;

  void cancel() override { cancelled_.store(true, std::memory_order_relaxed); }

  Result<void> seek(std::uint64_t capture_ns) override;

 private:
  Result<std::optional<Record>> read_on();
  Result<memory::ChannelInfo> open_topic(std::shared_ptr<const ByteSource> source, const McapIndex& index);

  std::filesystem::path path_;
  std::optional<std::string> topic_;
  std::set<std::uint16_t> channel_ids_;  // of the topic
  std::optional<McapReader> reader_;
  std::deque<Record> ahead_;  // read already by seek()
  std::atomic<bool> cancelled_ = false;
};

}  // namespace robot::logging
