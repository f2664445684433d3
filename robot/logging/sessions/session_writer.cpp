#include "robot/logging/sessions/session_writer.h"

#include <utility>

#include "robot/core/files.h"
#include "robot/logging/sessions/profile.h"
#include "robot/logging/sessions/stream_name.h"

namespace robot::logging {

Result<std::unique_ptr<SessionWriter>> SessionWriter::create(std::filesystem::path folder, SessionInfo info,
                                                             Compression compression) {
  folder = plain_path(folder);
  std::error_code failed;
  if (std::filesystem::exists(folder / "session.json", failed))
    return Error{"session " + folder.string() + ": there is one already"};
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{"session: cannot make the folder " + folder.string() + ": " + failed.message()};
  Result<OwnedFolder> owned = OwnedFolder::own(folder);
  if (!owned) return owned.failure("session");
  if (Result<void> written = store_file(folder / "session.json", to_json(info)); !written)
    return written.failure("session");
  return std::unique_ptr<SessionWriter>(new SessionWriter(std::move(*owned), std::move(info), compression));
}

Result<SessionWriter::Stream*> SessionWriter::stream_of(const memory::ChannelInfo& info) {
  if (const auto found = streams_.find(info.topic); found != streams_.end()) return &found->second;
  const bool image = info.schema.name == kImageSchema;
  Stream stream{.channel = std::make_unique<memory::RawChannel>(info, clock_),
                .file = std::make_unique<FileOutProvider>(
                    folder_ / stream_file_name(info.topic),
                    McapOptions{.first_channel_id = static_cast<std::uint16_t>(streams_.size() + 1),
                                .metadata = metadata_of(info_),
                                .compression = image ? Compression::none : compression_})};
  if (Result<void> opened = stream.file->open(info); !opened) return opened.failure();
  return &streams_.emplace(info.topic, std::move(stream)).first->second;
}

Result<void> SessionWriter::write(const memory::ChannelInfo& info, std::uint64_t capture_ns, std::string_view bytes) {
  Result<Stream*> stream = stream_of(info);
  if (!stream) return stream.failure();
  clock_.set(capture_ns);
  if (Result<void> entered = (*stream)->channel->write_bytes(bytes, capture_ns); !entered) return entered;
  return (*stream)->file->write((*stream)->channel->newest());
}

Result<void> SessionWriter::close() {
  Result<void> closed;
  for (auto& [topic, stream] : streams_)
    if (Result<void> one = stream.file->close(); !one && closed) closed = one;
  if (!closed) return closed;
  info_.complete = true;
  Result<void> written = store_file(folder_ / "session.json", to_json(info_));
  owned_.reset();
  return written;
}

Result<void> write_session(const std::filesystem::path& folder, SessionInfo info,
                           const std::function<Result<void>(SessionWriter&)>& fill) {
  auto writer = SessionWriter::create(folder, std::move(info));
  if (!writer) return writer.failure();
  const Result<void> filled = fill(**writer);
  const Result<void> closed = (*writer)->close();
  if (filled && closed) return {};
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
  return filled ? closed : filled;
}

}  // namespace robot::logging
