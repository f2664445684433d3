#include "robot/logging/recent/recent_file.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "robot/logging/mcap/assembly.h"
#include "robot/logging/mcap/format.h"

namespace robot::logging {
namespace {

constexpr std::uint64_t kGoesBackNs = kSecond;

// the writer remembers where each of its chunks was, so it is replaced now and then
constexpr std::size_t kChunksOfWriter = 1000;

}  // namespace

/// The writer's device: takes the head, then chunk after chunk.
class RecentFile::Sink final : public ByteSink {
 public:
  explicit Sink(Store& store) : store_(store) { store_.since_open = 0; }

  Result<void> append(std::span<const std::string_view> pieces) override {
    std::string bytes;
    for (const std::string_view piece : pieces) bytes += piece;
    if (!has_head_) {
      store_.head = std::move(bytes);
      has_head_ = true;
      return {};
    }
    std::size_t at = 0;
    const Result<mcap::RecordView> chunk = mcap::take_record(bytes, at), index = mcap::take_record(bytes, at);
    if (!chunk) return chunk.failure();
    if (!index) return index.failure();
    const auto head = mcap::decode<mcap::ChunkHead>(chunk->content, chunk->offset);
    if (!head) return head.failure();
    const auto entries = mcap::decode<mcap::MessageIndex>(index->content, index->offset);
    if (!entries) return entries.failure();
    const std::size_t size = bytes.size();
    store_.chunks.push_back({entries->channel_id - kFirstId, head->end_ns, std::move(bytes)});
    store_.bytes += size;
    ++store_.since_open;
    return {};
  }

  /// A failed append() has appended nothing.
  Result<void> truncate(std::uint64_t) override { return {}; }

  static constexpr std::size_t kFirstId = 1;

 private:
  Store& store_;
  bool has_head_ = false;
};

std::size_t RecentFile::add(memory::ChannelInfo info) {
  channels_.push_back(std::move(info));
  newest_ns_.push_back(0);
  return channels_.size() - 1;
}

/// Opens a writer that has all channels. Channels keep their ids, so that earlier chunks stay valid.
Result<void> RecentFile::open() {
  if (Result<void> flushed = flush(); !flushed) return flushed;
  writer_.reset();
  auto writer = McapWriter::open(std::make_unique<Sink>(store_), channels_,
                                 {.first_channel_id = Sink::kFirstId,
                                  .metadata = {},
                                  .compression = Compression::zstd,
                                  .chunk_bytes = limits_.chunk_bytes,
                                  .chunk_time_ns = limits_.chunk_ns});
  if (!writer) return writer.failure();
  writer_.emplace(std::move(*writer));
  open_channels_ = channels_.size();
  return {};
}

Result<void> RecentFile::flush() { return writer_ ? writer_->flush() : Result<void>(); }

Result<void> RecentFile::write(std::size_t channel, const OutMessage& message) {
  assert(channel < channels_.size() && "the channel was added");
  if (channel >= open_channels_ || store_.since_open >= kChunksOfWriter)
    if (Result<void> opened = open(); !opened) return opened;
  if (message.capture_ns + kGoesBackNs < newest_ns_[channel])
    if (Result<void> begun = begin_anew(channel); !begun) return begun;
  newest_ns_[channel] = std::max(newest_ns_[channel], message.capture_ns);
  const std::size_t chunks = store_.chunks.size();
  Result<void> written = writer_->write(channel, message, message.capture_ns);
  if (store_.chunks.size() > chunks) forget_old();
  return written;
}

/// Forgets all messages of a channel.
Result<void> RecentFile::begin_anew(std::size_t channel) {
  if (Result<void> flushed = flush(); !flushed) return flushed;
  std::erase_if(store_.chunks, [&](const Chunk& chunk) {
    if (chunk.channel == channel) store_.bytes -= chunk.bytes.size();
    return chunk.channel == channel;
  });
  newest_ns_[channel] = 0;
  return {};
}

void RecentFile::forget_old() {
  const std::uint64_t newest_ns = std::ranges::max(newest_ns_);
  const auto is_only = [&](const Chunk& chunk) {
    return std::ranges::count(store_.chunks, chunk.channel, &Chunk::channel) == 1;
  };
  for (auto chunk = store_.chunks.begin(); chunk != store_.chunks.end();) {
    const bool too_old = chunk->end_ns + limits_.age_ns < newest_ns;
    if (!too_old && store_.bytes <= limits_.bytes) return;
    if (is_only(*chunk)) {
      ++chunk;
      continue;
    }
    store_.bytes -= chunk->bytes.size();
    chunk = store_.chunks.erase(chunk);
  }
}

Result<std::shared_ptr<const ByteSource>> RecentFile::file(std::span<const std::string> topics) {
  if (!writer_ || open_channels_ < channels_.size())
    if (Result<void> opened = open(); !opened) return opened.failure();
  if (Result<void> flushed = flush(); !flushed) return flushed.failure();
  std::string bytes = store_.head;
  for (const Chunk& chunk : store_.chunks)
    if (topics.empty() || std::ranges::count(topics, channels_[chunk.channel].topic) > 0) bytes += chunk.bytes;
  Result<Assembly> assembly = assemble({std::make_shared<const MemorySource>(std::move(bytes), "the last minutes")});
  if (!assembly) return assembly.failure();
  return std::shared_ptr<const ByteSource>(std::make_shared<const Assembly>(std::move(*assembly)));
}

}  // namespace robot::logging
