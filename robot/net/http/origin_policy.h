// Who may talk to us: any page in any browser can open a WebSocket to a robot, so we look at what the browser says.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace robot::net {

/// The options of the programs that change the policy; a refusal names them.
inline constexpr std::string_view kAllowHost = "--allow-host";
inline constexpr std::string_view kAllowOrigin = "--allow-origin";

/// What is accepted beyond the built-in rules.
struct OriginPolicy {
  std::vector<std::string> hosts;    // further names of this machine: "nao.lab.example.org"
  std::vector<std::string> origins;  // further pages: "https://lab.example.org"
  std::vector<std::string> robots;   // hosts of the team's robots, whose viewers may connect here
};

/// Accepts the Host header of a request if it is an IP address, localhost, a name in *.local or a configured one:
/// any other name may belong to somebody who has pointed it at us (DNS rebinding).
Result<void> check_host(const OriginPolicy& policy, std::string_view host);

/// Accepts the Origin of a page: none (no browser), our own host, a file, localhost at any port, the team's robots,
/// https://app.foxglove.dev, or a configured one. `host` is the Host header, already checked.
Result<void> check_origin(const OriginPolicy& policy, std::optional<std::string_view> origin, std::string_view host);

/// Whether `address`, of the other end of a connection, is this machine: 127.0.0.0/8 or ::1, also IPv4 within IPv6.
bool is_loopback(std::string_view address);

/// Whether `given` is `expected`, in a time that does not tell how much of it is right. An empty `expected` never is.
bool same_token(std::string_view given, std::string_view expected);

}  // namespace robot::net
