#include "robot/logging/sessions/session_provider.h"

#include <optional>

#include "robot/logging/streams/file_provider.h"

namespace robot::logging {

std::unique_ptr<InProvider> provider_of(const Session& session, const StreamFile& stream) {
  return std::make_unique<FileInProvider>(session.folder / stream.file,
                                          session.one_file ? std::optional(stream.topic) : std::nullopt);
}

}  // namespace robot::logging
