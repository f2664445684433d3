// Downloads with the scenes, frames and images that other viewers draw.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "robot/core/byte_source.h"
#include "robot/core/result.h"
#include "robot/net/serve/backend.h"

namespace robot::app {

/// Returns an MCAP file with the messages that are derived from those of the MCAP file `recorded`. Its channels are those
/// that a server offers to other viewers, without raw images, and the scenes as points. Their ids differ from those of
/// `recorded`. The file has no name and lies on the disk of `folder`. The same recording gives the same bytes.
///
/// Returns an Error if `recorded` cannot be read, if less than 200 MB of that disk are free, or if the client has left.
Result<std::shared_ptr<const ByteSource>> foxglove_file(std::shared_ptr<const ByteSource> recorded,
                                                        const std::filesystem::path& folder, const std::string& rules,
                                                        const net::ClientLeft& left);

}  // namespace robot::app
