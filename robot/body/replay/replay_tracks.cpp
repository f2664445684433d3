// Readers of topics of a recording for playheads of their own.
#include <map>
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
  std::map<std::string, Played> by_topic;
  for (const Played& stream : played()) by_topic.emplace(name_of(stream), stream);
  const auto found = [&](const std::string& topic) { return by_topic.find(topic); };
  if (topics.empty() || found(topics.front()) == by_topic.end())
    return Error{"expected a topic that is played, got '" + (topics.empty() ? "" : topics.front()) + "'"};
  const Played& first = found(topics.front())->second;
  if (first.made) {
    auto stream = open_stream(first);
    if (auto opened = stream->open(); !opened) return opened.failure();
    return std::unique_ptr<Track>(std::make_unique<StreamTrack>(std::move(stream), cancelled));
  }
  auto file = file_of(first);
  if (!file) return file.failure();
  std::map<std::string, logging::TopicStream> streams;
  for (logging::TopicStream& stream : logging::topic_streams((*file)->index()))
    streams.emplace(stream.info.topic, std::move(stream));
  std::vector<logging::TopicStream> wanted;
  for (const std::string& topic : topics) {
    const auto played = found(topic);
    const auto stream = played == by_topic.end() ? streams.end() : streams.find(played->second.file->topic);
    if (stream == streams.end()) return Error{(*file)->source().name() + ": expected a channel " + topic};
    wanted.push_back(std::move(stream->second));
  }
  return std::unique_ptr<Track>(
      std::make_unique<FileTrack>(std::move(*file), wanted, first.recording->shift, cancelled));
}

}  // namespace robot::body
