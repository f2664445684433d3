#include "robot/logging/streams/file_provider.h"

#include <algorithm>
#include <cassert>
#include <system_error>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/clock.h"
#include "robot/logging/mcap/topic_streams.h"

namespace robot::logging {

FileOutProvider::FileOutProvider(std::filesystem::path path, McapOptions options)
    : path_(std::move(path)), options_(std::move(options)) {}

Result<void> FileOutProvider::open(const memory::ChannelInfo& info) {
  assert(!writer_ && "a stream is opened once");
  Result<std::unique_ptr<FileSink>> sink = FileSink::create(path_);
  if (!sink) return sink.failure();
  Result<void> opened = attempt("a new recording", [&]() -> Result<void> {
    Result<McapWriter> writer = McapWriter::open(std::move(*sink), {&info, 1}, options_);
    if (!writer) return writer.failure();
    writer_ = std::move(*writer);
    return {};
  });
  if (!opened) {
    // the file is ours and empty: remove it, or the next attempt would find an existing file
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
    return opened;
  }
  return counted([] { return Result<void>(); });
}

Result<void> FileOutProvider::write(const memory::VersionPtr& version) {
  assert(writer_ && "a stream is opened before it is written");
  const OutMessage message{version->sequence(), version->capture_ns(), version->publish_ns(), version->bytes()};
  return counted([&] {
    Result<void> written = writer_->write(0, message, monotonic_ns());
    if (written) ++taken_;
    return written;
  });
}

std::uint64_t FileOutProvider::flush_due_ns() const { return writer_ ? writer_->flush_due_ns() : kNever; }

Result<void> FileOutProvider::flush() {
  if (!writer_) return {};
  return counted([&] { return writer_->flush(); });
}

Result<void> FileOutProvider::close() {
  if (!writer_) return {};
  return counted([&] { return writer_->close(); });
}

/// Calls a function of the writer, and publishes the writer's counts to other threads, also after an exception.
template <class Call>
Result<void> FileOutProvider::counted(Call&& call) {
  Result<void> result = attempt("a recording", call);
  size_bytes_.store(writer_->size_bytes(), std::memory_order_relaxed);
  messages_.store(writer_->messages(), std::memory_order_relaxed);
  lost_.store(taken_ - writer_->messages() - writer_->collected(), std::memory_order_relaxed);
  return result;
}

Result<memory::ChannelInfo> FileInProvider::open() {
  if (topic_) return open_topic();
  Result<std::shared_ptr<const FileSource>> source = FileSource::open(path_);
  if (!source) return source.failure();
  const Result<McapIndex> index = read_index(**source);
  if (!index) return index.failure();
  if (index->channels.size() != 1)
    return Error{path_.string() + ": expected the recording of one channel, got " +
                 std::to_string(index->channels.size()) + (index->damage.empty() ? "" : " (" + index->damage + ")")};
  reader_.emplace(std::move(*source));
  return channel_info(index->channels.begin()->second, index->schemas);
}

/// Opens only the chunks of the file that hold the topic.
Result<memory::ChannelInfo> FileInProvider::open_topic() {
  if (!file_) {
    auto file = McapFile::open(path_);
    if (!file) return file.failure();
    file_ = std::move(*file);
  }
  for (const TopicStream& stream : topic_streams(file_->index())) {
    if (stream.info.topic != *topic_) continue;
    ordered_.emplace(file_, stream.channels, &cancelled_);
    return stream.info;
  }
  return Error{path_.string() + ": expected a channel " + *topic_ + ", there is none"};
}

Result<std::optional<Record>> FileInProvider::read() {
  assert((reader_ || ordered_) && "a stream is opened before it is read");
  if (ahead_.empty()) return read_on();
  std::optional<Record> record(std::move(ahead_.front()));
  ahead_.pop_front();
  return record;
}

Result<std::optional<Record>> FileInProvider::read_on() {
  if (cancelled_.load(std::memory_order_relaxed)) return std::optional<Record>();
  Result<std::optional<McapMessage>> message = ordered_ ? ordered_->next() : reader_->next();
  if (!message) return message.failure();
  if (!*message) return std::optional<Record>();
  return std::optional<Record>(std::move((*message)->record));
}

Result<void> FileInProvider::seek_topic(std::uint64_t capture_ns) {
  std::vector<McapMessage> newest = ordered_->move_to(capture_ns);
  if (!newest.empty()) ahead_.push_back(std::move(newest.back().record));
  return {};
}

Result<void> FileInProvider::seek(std::uint64_t capture_ns) {
  assert((reader_ || ordered_) && "a stream is opened before it is read");
  ahead_.clear();
  if (ordered_) return seek_topic(capture_ns);
  Result<std::vector<std::uint64_t>> starts = reader_->chunk_starts_until(capture_ns);
  if (!starts) return starts.failure();
  // begin at the last chunk that starts early enough
  std::ranges::reverse(*starts);
  for (const std::uint64_t start_ns : *starts) {
    if (Result<void> sought = reader_->seek(start_ns); !sought) return sought;
    std::optional<Record> newest;
    while (!cancelled_.load(std::memory_order_relaxed)) {
      Result<std::optional<Record>> record = read_on();
      if (!record) continue;  // read() reported this damage before
      if (!*record) break;
      if ((*record)->capture_ns > capture_ns) {
        if (newest) ahead_.push_back(std::move(**record));
        break;
      }
      newest = std::move(**record);
    }
    if (!newest) continue;
    ahead_.push_front(std::move(*newest));
    return {};
  }
  return reader_->seek(0);
}

}  // namespace robot::logging
