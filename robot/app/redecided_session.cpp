#include "robot/app/redecided_session.h"

#include "robot/app/session_copy.h"
#include "robot/memory/schema.h"

namespace robot::app {
namespace {

Result<void> add(const Redecisions& decisions, logging::SessionWriter& writer) {
  const memory::ChannelInfo info{.topic = "/" + decisions.robot + "/" + kRedecision,
                                 .schema = memory::schema_of(*foresight::DecisionTrace::descriptor())};
  for (const Redecision& decision : decisions.all)
    if (Result<void> written = writer.write(info, decision.at_ns, decision.now.SerializeAsString()); !written)
      return written;
  return {};
}

}  // namespace

Result<void> write_redecided(const logging::Session& session, const Redecisions& decisions,
                             const std::filesystem::path& folder) {
  return write_copy(session,
                    {.about = "with the decisions of " + decisions.strategy,
                     .add = [&](logging::SessionWriter& writer) { return add(decisions, writer); }},
                    folder);
}

}  // namespace robot::app
