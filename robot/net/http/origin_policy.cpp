#include "robot/net/http/origin_policy.h"

#include <arpa/inet.h>

#include <algorithm>
#include <cctype>

#include "robot/core/text.h"

namespace robot::net {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// "nao.local:8765" -> "nao.local", "[::1]:8765" -> "::1"; empty if it is no host
std::string name_of(std::string_view host) {
  std::string_view name, port;
  if (host.starts_with('[')) {
    const std::size_t end = host.find(']');
    if (end == std::string_view::npos) return {};
    name = host.substr(1, end - 1);
    port = host.substr(end + 1);
  } else {
    const std::size_t colon = std::min(host.find(':'), host.size());
    name = host.substr(0, colon);
    port = host.substr(colon);
  }
  const bool port_ok =
      port.empty() ||
      (port[0] == ':' && std::ranges::all_of(port.substr(1), [](char c) { return c >= '0' && c <= '9'; }));
  return port_ok ? lower(name) : std::string();
}

bool is_address(const std::string& name) {
  in6_addr address;
  return inet_pton(AF_INET, name.c_str(), &address) == 1 || inet_pton(AF_INET6, name.c_str(), &address) == 1;
}

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::ranges::any_of(list, [&](const std::string& entry) { return lower(entry) == name; });
}

bool is_localhost(const std::string& name) { return name == "localhost" || is_loopback(name); }

}  // namespace

std::vector<std::string> names_of_machine(std::string_view host_name) {
  const std::string name = lower(host_name), first = name.substr(0, name.find('.'));
  if (first.empty()) return {};
  return {name, first, first + ".local"};
}

Result<void> check_host(const OriginPolicy& policy, std::string_view host) {
  const std::string name = name_of(host);
  const bool accepted =
      is_address(name) || name == "localhost" || contains(policy.hosts, name) || contains(policy.robots, name);
  if (accepted) return {};
  return Error{"host '" + printable(host, 100) + "' is not a name of this robot; if it is, start it with " +
               std::string(kAllowHost) + " " + (name.empty() ? "<name>" : printable(name, 100))};
}

Result<void> check_origin(const OriginPolicy& policy, std::optional<std::string_view> origin, std::string_view host) {
  if (!origin) return {};
  const std::string page = lower(*origin);
  // browsers send file:// for pages from disk; "null" may be a sandboxed frame of any page and is refused
  if (page == "file://" || page == "https://app.foxglove.dev" || contains(policy.origins, page)) return {};

  const std::size_t scheme_end = page.find("://");
  const std::string scheme = page.substr(0, std::min(scheme_end, page.size()));
  if (scheme_end != std::string::npos && (scheme == "http" || scheme == "https")) {
    const std::string authority = page.substr(scheme_end + 3);
    const std::string name = name_of(authority);
    if (authority == lower(host) || is_localhost(name) || contains(policy.robots, name)) return {};
  }
  return Error{"pages of '" + printable(*origin, 100) +
               "' may not connect to this robot; if they should, start it with " + std::string(kAllowOrigin) + " " +
               printable(*origin, 100)};
}

Result<std::string> frame_ancestors(const std::vector<std::string>& pages) {
  std::string all;
  for (const std::string& page : pages) {
    const std::string_view text = page;
    const std::size_t scheme = text.starts_with("https://") ? 8 : text.starts_with("http://") ? 7 : 0;
    const std::string_view host = text.substr(scheme);
    const auto allowed = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             std::string_view(".-:[]").find(c) != std::string_view::npos;
    };
    if (scheme == 0 || host.empty() || !std::ranges::all_of(host, allowed))
      return Error{std::string(kAllowFrame) + ": expected a page such as https://lab.example.org, got '" +
                   printable(text, 100) + "'"};
    all += (all.empty() ? "" : " ") + page;
  }
  return all.empty() ? "'none'" : all;
}

bool is_loopback(std::string_view address) {
  const std::string text(address);
  in_addr v4{};
  if (inet_pton(AF_INET, text.c_str(), &v4) == 1) return (ntohl(v4.s_addr) >> 24) == 127;
  in6_addr v6{};
  if (inet_pton(AF_INET6, text.c_str(), &v6) != 1) return false;
  return IN6_IS_ADDR_LOOPBACK(&v6) || (IN6_IS_ADDR_V4MAPPED(&v6) && v6.s6_addr[12] == 127);
}

bool same_token(std::string_view given, std::string_view expected) {
  if (expected.empty()) return false;
  unsigned difference = given.size() == expected.size() ? 0 : 1;
  for (std::size_t i = 0; i < given.size(); ++i)
    difference |= static_cast<unsigned char>(given[i]) ^ static_cast<unsigned char>(expected[i % expected.size()]);
  return difference == 0;
}

}  // namespace robot::net
