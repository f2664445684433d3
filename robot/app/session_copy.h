// Copies of recordings that differ from the original in one object.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "robot/core/result.h"
#include "robot/logging/sessions/session.h"
#include "robot/logging/sessions/session_writer.h"

namespace robot::app {

/// The plan of a copy.
struct SessionCopy {
  std::string about;         // its description after that of the original: "with the decisions of passing"
  std::string without = {};  // the topic that is not copied; empty: all are
  std::function<Result<void>(logging::SessionWriter&)> add;  // writes what the original does not have
};

/// Writes a copy of `session` into the new folder `folder`. Messages that cannot be read are left out, and the description
/// of the copy counts them. After an Error there is no copy.
Result<void> write_copy(const logging::Session& session, const SessionCopy& copy, const std::filesystem::path& folder);

}  // namespace robot::app
