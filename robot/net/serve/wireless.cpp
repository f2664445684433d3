#include "robot/net/serve/wireless.h"

#include <ifaddrs.h>
#include <linux/filter.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "robot/core/files.h"
#include "robot/core/folder.h"

namespace robot::net {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostInterfaces = 64;

/// Returns whether the system knows the interface `name` as loopback or as an Ethernet cable of its own.
bool is_wired(const std::string& name) {
  const fs::path folder = fs::path("/sys/class/net") / name;
  const auto type = read_file(folder / "type", 64);
  if (!type) return false;
  const int kind = std::atoi(type->c_str());
  if (kind == ARPHRD_LOOPBACK) return true;
  if (kind != ARPHRD_ETHER) return false;
  const auto entries = list_folder(folder);
  if (!entries) return false;
  // a bridge, a bond, a VLAN or a tunnel may end in the air
  return std::ranges::none_of(*entries, [](const FolderEntry& entry) {
    static constexpr std::string_view kOthers[] = {"wireless", "phy80211", "bridge", "bonding", "tun_flags"};
    return std::ranges::find(kOthers, entry.name) != std::end(kOthers) || entry.name.starts_with("lower_");
  });
}

/// Returns all interfaces that may be wireless.
std::vector<std::string> wireless_names() {
  std::vector<std::string> names;
  struct if_nameindex* const all = ::if_nameindex();
  for (const struct if_nameindex* one = all; one && one->if_index != 0; ++one)
    if (!is_wired(one->if_name)) names.emplace_back(one->if_name);
  if (all) ::if_freenameindex(all);
  return names;
}

/// Returns the address bytes: four or sixteen. An IPv4 address within IPv6 gives four.
std::string bytes_of(const sockaddr& address) {
  if (address.sa_family == AF_INET) {
    const auto& v4 = reinterpret_cast<const sockaddr_in&>(address).sin_addr;
    return {reinterpret_cast<const char*>(&v4), sizeof v4};
  }
  if (address.sa_family != AF_INET6) return {};
  const auto& v6 = reinterpret_cast<const sockaddr_in6&>(address).sin6_addr;
  std::string bytes(reinterpret_cast<const char*>(&v6), sizeof v6);
  return IN6_IS_ADDR_V4MAPPED(&v6) ? bytes.substr(12) : bytes;
}

}  // namespace

Wireless::Wireless(const std::vector<std::string>& given) {
  const std::vector<std::string> names = given.empty() ? wireless_names() : given;
  for (const std::string& name : names)
    if (const unsigned index = ::if_nametoindex(name.c_str()); index != 0 && indices_.size() < kMostInterfaces)
      indices_.push_back(index);

  ifaddrs* all = nullptr;
  if (indices_.empty() || ::getifaddrs(&all) != 0) return;
  for (const ifaddrs* one = all; one; one = one->ifa_next)
    if (one->ifa_addr && std::ranges::count(names, one->ifa_name))
      if (std::string bytes = bytes_of(*one->ifa_addr); !bytes.empty()) addresses_.push_back(std::move(bytes));
  ::freeifaddrs(all);
}

Result<void> Wireless::silence(int socket) const {
  if (indices_.empty()) {
    const int unused = 0;
    if (::setsockopt(socket, SOL_SOCKET, SO_DETACH_FILTER, &unused, sizeof unused) != 0 && errno != ENOENT)
      return Error{"cannot listen to wireless networks again: " + std::string(std::strerror(errno))};
    return {};
  }
  // "if the interface is the first, or the second, …: take 0 bytes of the packet; else all"
  std::vector<sock_filter> program;
  program.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(SKF_AD_OFF + SKF_AD_IFINDEX)));
  for (std::size_t left = indices_.size(); const unsigned index : indices_)
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, index, static_cast<std::uint8_t>(left--), 0));
  program.push_back(BPF_STMT(BPF_RET | BPF_K, 0xffffffff));
  program.push_back(BPF_STMT(BPF_RET | BPF_K, 0));
  const sock_fprog filter{.len = static_cast<unsigned short>(program.size()), .filter = program.data()};
  if (::setsockopt(socket, SOL_SOCKET, SO_ATTACH_FILTER, &filter, sizeof filter) != 0)
    return Error{"cannot stay silent on wireless networks during the game: " + std::string(std::strerror(errno))};
  return {};
}

bool Wireless::carries(int socket) const {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (addresses_.empty() || ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return false;
  return std::ranges::count(addresses_, bytes_of(reinterpret_cast<const sockaddr&>(address))) > 0;
}

}  // namespace robot::net
