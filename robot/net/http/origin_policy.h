// Checks of Host, Origin and token. Any page in any browser can open a WebSocket to a robot, so we check these headers.
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
inline constexpr std::string_view kAllowFrame = "--allow-frame";

/// Hosts and origins that are accepted in addition to the built-in rules.
struct OriginPolicy {
  std::vector<std::string> hosts;    // names of this machine: "nao14.local", "nao.lab.example.org"
  std::vector<std::string> origins;  // further pages: "https://lab.example.org"
  std::vector<std::string> robots;   // hosts of the team's robots, whose viewers may connect here
};

/// Returns the names under which a machine called `host_name` is reached: "nao14.lab" is also "nao14" and "nao14.local".
std::vector<std::string> names_of_machine(std::string_view host_name);

/// Accepts the Host header of a request if it is an IP address, localhost or a name in `policy`. An attacker may point any
/// other name at our address (DNS rebinding), in a local network also a name in *.local.
Result<void> check_host(const OriginPolicy& policy, std::string_view host);

/// Accepts the Origin of a page: our own host, a file, localhost at any port, the team's robots,
/// https://app.foxglove.dev, or a configured one. No Origin is accepted too, because the client is then no browser.
/// `host` is the Host header, already checked.
Result<void> check_origin(const OriginPolicy& policy, std::optional<std::string_view> origin, std::string_view host);

/// Returns the value of frame-ancestors in the Content-Security-Policy for `pages` that may show the viewer in a frame,
/// each like "https://lab.example.org:8080". It is 'none' without pages. Returns an Error for anything that is no such
/// page, because a blank or a semicolon would begin another rule.
Result<std::string> frame_ancestors(const std::vector<std::string>& pages);

/// Returns whether a peer at `address` is on this machine: 127.0.0.0/8 or ::1, also IPv4 within IPv6.
bool is_loopback(std::string_view address);

/// Returns whether `given` equals `expected`. The time it takes does not reveal how many characters are right.
/// Returns false if `expected` is empty.
bool same_token(std::string_view given, std::string_view expected);

}  // namespace robot::net
