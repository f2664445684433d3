// The server's options on the command line of foresight-robot and foresight-lab.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/net/serve/routes.h"

// forward declaration: each file that includes CLI11 compiles its constants, 2 s of processor time
namespace CLI {  // NOLINT(readability-identifier-naming): a library's name
class App;
}

namespace robot::app {

/// The values of these options.
struct ServerSettings {
  std::vector<std::string> bind = {"127.0.0.1"};
  std::uint16_t port = 8765;
  std::vector<std::string> allowed_hosts, allowed_origins, allowed_frames;
  std::vector<std::string> wireless;   // interfaces that are silent during a game; empty: see server.h
  std::filesystem::path state_folder;  // empty: $XDG_STATE_HOME/foresight, or ~/.local/state/foresight
  bool protect_reading = false;
};

/// Declares the options, which set `settings`.
void add_server_options(CLI::App& command, ServerSettings& settings);

/// Returns the access rules of the server. Creates the control token on the first start, readable by this user only.
Result<net::AccessOptions> access_options(const ServerSettings& settings);

}  // namespace robot::app
