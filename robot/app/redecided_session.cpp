#include "robot/app/redecided_session.h"

#include <utility>

#include "robot/app/build_id.h"
#include "robot/logging/sessions/session_provider.h"
#include "robot/logging/sessions/session_writer.h"
#include "robot/memory/schema.h"

namespace robot::app {
namespace {

/// Copies the messages of a stream, and adds the unreadable ones to `unreadable`.
Result<void> copy(const logging::Session& session, const logging::StreamFile& file, logging::SessionWriter& writer,
                  std::uint64_t& unreadable) {
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

Result<void> add(const Redecisions& decisions, logging::SessionWriter& writer) {
  const memory::ChannelInfo info{.topic = "/" + decisions.robot + "/" + kRedecision,
                                 .schema = memory::schema_of(*foresight::DecisionTrace::descriptor())};
  for (const Redecision& decision : decisions.all)
    if (Result<void> written = writer.write(info, decision.at_ns, decision.now.SerializeAsString()); !written)
      return written;
  return {};
}

Result<void> fill(const logging::Session& session, const Redecisions& decisions, logging::SessionWriter& writer) {
  std::uint64_t unreadable = 0;
  for (const logging::StreamFile& file : session.streams)
    if (file.messages > 0)
      if (Result<void> copied = copy(session, file, writer, unreadable); !copied) return copied;
  std::string about = session.info.about;
  about += (about.empty() ? "" : "; ") + ("copy of " + session.id() + " with the decisions of " + decisions.strategy) +
           (unreadable > 0 ? ", without " + std::to_string(unreadable) + " messages that cannot be read" : "");
  writer.describe(std::move(about));
  return add(decisions, writer);
}

}  // namespace

Result<void> write_redecided(const logging::Session& session, const Redecisions& decisions,
                             const std::filesystem::path& folder) {
  logging::SessionInfo info = session.info;
  info.build = std::string(kBuildId);
  info.complete = false;
  info.account = {};
  return logging::write_session(folder, std::move(info),
                                [&](logging::SessionWriter& writer) { return fill(session, decisions, writer); });
}

}  // namespace robot::app
