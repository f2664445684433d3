#include "robot/app/session_copy.h"

#include <utility>

#include "robot/app/build_id.h"
#include "robot/logging/sessions/session_provider.h"

namespace robot::app {
namespace {

/// Copies the messages of a stream, and adds the unreadable ones to `unreadable`.
Result<void> copy_stream(const logging::Session& session, const logging::StreamFile& file,
                         logging::SessionWriter& writer, std::uint64_t& unreadable) {
  const auto stream = logging::provider_of(session, file);
  const auto info = stream->open();
  if (!info) return info.failure(file.topic);
  while (true) {
    const auto record = stream->read();
    if (!record) {
      ++unreadable;
      continue;
    }
    if (!*record) return {};
    if (Result<void> written = writer.write(*info, (*record)->capture_ns, (*record)->bytes); !written) return written;
  }
}

Result<void> fill(const logging::Session& session, const SessionCopy& copy, logging::SessionWriter& writer) {
  std::uint64_t unreadable = 0;
  for (const logging::StreamFile& file : session.streams)
    if (file.messages > 0 && file.topic != copy.without)
      if (Result<void> copied = copy_stream(session, file, writer, unreadable); !copied) return copied;
  std::string about = session.info.about;
  about += (about.empty() ? "" : "; ") + ("copy of " + session.id() + " " + copy.about) +
           (unreadable > 0 ? ", without " + std::to_string(unreadable) + " messages that cannot be read" : "");
  writer.describe(std::move(about));
  return copy.add(writer);
}

}  // namespace

Result<void> write_copy(const logging::Session& session, const SessionCopy& copy, const std::filesystem::path& folder) {
  logging::SessionInfo info = session.info;
  info.build = std::string(kBuildId);
  info.complete = false;
  info.account = {};
  return logging::write_session(folder, std::move(info),
                                [&](logging::SessionWriter& writer) { return fill(session, copy, writer); });
}

}  // namespace robot::app
