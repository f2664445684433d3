#include "robot/app/server_settings.h"

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <cstdlib>
#include <span>

#include "robot/core/files.h"

namespace robot::app {
namespace {

constexpr std::size_t kTokenBytes = 16, kMaxTokenFileBytes = 4096;

std::filesystem::path state_folder(const ServerSettings& settings) {
  if (!settings.state_folder.empty()) return settings.state_folder;
  if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state)
    return std::filesystem::path(state) / "foresight";
  if (const char* home = std::getenv("HOME"); home && *home)
    return std::filesystem::path(home) / ".local/state/foresight";
  return "/var/lib/foresight";
}

/// Fills `bytes` with random numbers of the kernel. Returns false if the system provides none.
bool fill_randomly(std::span<unsigned char> bytes) {
  const auto all = static_cast<ssize_t>(bytes.size());
  if (getrandom(bytes.data(), bytes.size(), 0) == all) return true;
  // the kernel of a Nao V4 or V5 does not have getrandom
  const FileDescriptor device(open("/dev/urandom", O_RDONLY | O_CLOEXEC));
  return device && read(device.get(), bytes.data(), bytes.size()) == all;
}

/// Returns the names of this machine, and the hosts that the options allow.
std::vector<std::string> hosts_of(const ServerSettings& settings) {
  char host_name[256] = "";
  if (::gethostname(host_name, sizeof host_name - 1) != 0) host_name[0] = '\0';
  std::vector<std::string> hosts = net::names_of_machine(host_name);
  hosts.insert(hosts.end(), settings.allowed_hosts.begin(), settings.allowed_hosts.end());
  return hosts;
}

Result<std::string> make_token() {
  unsigned char bytes[kTokenBytes];
  if (!fill_randomly(bytes)) return Error{"token: the system provides no random numbers"};
  std::string token;
  for (const unsigned char byte : bytes) {
    token.push_back("0123456789abcdef"[byte >> 4]);
    token.push_back("0123456789abcdef"[byte & 15]);
  }
  return token;
}

/// Reads the token in `folder`, or creates it if there is none.
Result<std::string> token_in(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "token";
  std::error_code failed;
  if (std::filesystem::exists(path, failed)) {
    Result<std::string> text = read_file(path, kMaxTokenFileBytes);
    if (!text) return text.failure("token");
    text->erase(text->find_last_not_of(" \r\n\t") + 1);
    if (text->size() < 8) return Error{"token: expected at least 8 characters in " + path.string()};
    return text;
  }
  Result<std::string> token = make_token();
  if (!token) return token;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{"token: cannot make the folder " + folder.string() + ": " + failed.message()};
  if (Result<void> written = replace_file(path, *token + "\n", 0600); !written) return written.failure("token");
  return token;
}

}  // namespace

void add_server_options(CLI::App& command, ServerSettings& settings) {
  command.add_option("--bind", settings.bind, "IP address to listen on; may be given several times; 0.0.0.0 is all")
      ->allow_extra_args(false)
      ->capture_default_str();
  command.add_option("--port", settings.port, "port of viewer, API, recordings and WebSocket; 0: any free port")
      ->capture_default_str();
  command
      .add_option("--allow-host", settings.allowed_hosts,
                  "another host name of this machine; may be given several times")
      ->allow_extra_args(false);
  command
      .add_option("--allow-origin", settings.allowed_origins,
                  "another page that may connect, https://host; may be given several times")
      ->allow_extra_args(false);
  command
      .add_option(std::string(net::kAllowFrame), settings.allowed_frames,
                  "a page that may show the viewer in a frame, https://host; may be given several times; default: none")
      ->allow_extra_args(false);
  command
      .add_option("--wireless", settings.wireless,
                  "network interface that is silent during a game; default: all except loopback and cables")
      ->allow_extra_args(false);
  command.add_option("--state-dir", settings.state_folder, "folder of the control token");
  command.add_flag("--protect-reading", settings.protect_reading,
                   "ask for the token also for watching from another machine, not only for control");
}

Result<net::AccessOptions> access_options(const ServerSettings& settings) {
  const Result<std::string> token = token_in(state_folder(settings));
  if (!token) return token.failure();
  const Result<std::string> cookie = make_token();
  if (!cookie) return cookie.failure();
  const Result<std::string> frames = net::frame_ancestors(settings.allowed_frames);
  if (!frames) return frames.failure();
  return net::AccessOptions{.origins = {.hosts = hosts_of(settings), .origins = settings.allowed_origins, .robots = {}},
                            .control_token = *token,
                            .read_token = settings.protect_reading ? *token : "",
                            .read_cookie = settings.protect_reading ? *cookie : "",
                            .frame_ancestors = *frames};
}

}  // namespace robot::app
