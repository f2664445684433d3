// Readers of topics of a recording for playheads of their own.
#include <algorithm>
#include <mutex>
#include <utility>

#include "robot/body/replay/replay.h"
#include "robot/logging/mcap/topic_streams.h"

namespace robot::body {

std::optional<std::string> Replay::track_name(const std::string& topic) const {
  const std::optional<Played> stream = find(topic);
  if (!stream) return std::nullopt;
  const auto& file = stream->recording->session.one_file;
  return file && !stream->made ? file->source().name() : topic;
}

/// Returns the file of a stream that is not made. Tracks of one file share it with its index.
Result<std::shared_ptr<const logging::McapFile>> Replay::file_of(const Played& stream) const {
  const logging::Session& session = stream.recording->session;
  if (session.one_file) return session.one_file;
  const std::filesystem::path path = session.folder / stream.file->file;
  const std::lock_guard guard(files_lock_);
  if (auto open = files_[path].lock()) return open;
  auto opened = logging::McapFile::open(path);
  if (opened) files_[path] = *opened;
  return opened;
}

Result<std::unique_ptr<Track>> Replay::open_track(const std::vector<std::string>& topics,
                                                  const std::atomic<bool>& cancelled) const {
  std::vector<logging::TopicStream> streams;
  std::shared_ptr<const logging::McapFile> file;
  std::int64_t shift_ns = 0;
  for (const std::string& topic : topics) {
    const std::optional<Played> played = find(topic);
    if (!played) return Error{"expected a topic that is played, got '" + topic + "'"};
    if (played->made) {
      auto stream = open_stream(*played);
      if (auto opened = stream->open(); !opened) return opened.failure();
      return std::unique_ptr<Track>(std::make_unique<StreamTrack>(std::move(stream), cancelled));
    }
    auto opened = file_of(*played);
    if (!opened) return opened.failure();
    file = std::move(*opened);
    shift_ns = played->recording->shift_ns;
    const auto all = logging::topic_streams(file->index());
    const auto found = std::ranges::find(all, played->file->topic,
                                         [](const logging::TopicStream& stream) { return stream.info.topic; });
    if (found == all.end()) return Error{file->source().name() + ": expected a channel " + topic + ", there is none"};
    streams.push_back(*found);
  }
  return std::unique_ptr<Track>(std::make_unique<FileTrack>(std::move(file), streams, shift_ns, cancelled));
}

}  // namespace robot::body
