#include "robot/logging/sessions/session_provider.h"

#include "robot/logging/streams/file_provider.h"

namespace robot::logging {

std::unique_ptr<InProvider> provider_of(const Session& session, const StreamFile& stream) {
  if (session.one_file) return std::make_unique<FileInProvider>(session.one_file, stream.topic);
  return std::make_unique<FileInProvider>(session.folder / stream.file);
}

}  // namespace robot::logging
