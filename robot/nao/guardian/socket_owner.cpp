#include "robot/nao/guardian/socket_owner.h"

#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <linux/sock_diag.h>
#include <linux/unix_diag.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <set>
#include <string_view>

#include "robot/core/files.h"
#include "robot/core/folder.h"

namespace robot::nao {
namespace {

constexpr std::size_t kMaxCommBytes = 64;

/// Returns "name (process 123)" of the first other process with an open file whose link in /proc satisfies `is_it`.
std::string process_with(const std::function<bool(const std::string&)>& is_it) {
  const auto processes = list_folder("/proc");
  if (!processes) return "";
  for (const auto& [id, kind, size_bytes, changed_ns] : *processes) {
    const std::filesystem::path process = "/proc/" + id;
    if (id.find_first_not_of("0123456789") != std::string::npos || id == std::to_string(::getpid())) continue;
    // files of other users are unreadable, and processes may end during the search
    const auto files = list_folder(process / "fd");
    if (!files) continue;
    for (const FolderEntry& file : *files) {
      std::error_code unreadable;
      if (!is_it(std::filesystem::read_symlink(process / "fd" / file.name, unreadable))) continue;
      const Result<std::string> name = read_file(process / "comm", kMaxCommBytes);
      return (name ? name->substr(0, name->find('\n')) : "a program") + " (process " + id + ")";
    }
  }
  return "";
}

/// The kernel's description of one local socket.
struct Described {
  std::string_view name;
  std::uint32_t peer = 0;  // number of the socket at the other end; 0: none
};

Described describe(const nlmsghdr* header) {
  Described socket;
  const auto* message = static_cast<const unix_diag_msg*>(NLMSG_DATA(header));
  auto left = static_cast<unsigned>(NLMSG_PAYLOAD(header, sizeof *message));
  for (auto* extra = reinterpret_cast<const rtattr*>(message + 1); RTA_OK(extra, left); extra = RTA_NEXT(extra, left)) {
    const char* data = static_cast<const char*>(RTA_DATA(extra));
    // the path may end with a zero byte or not
    if (extra->rta_type == UNIX_DIAG_NAME) socket.name = {data, ::strnlen(data, RTA_PAYLOAD(extra))};
    if (extra->rta_type == UNIX_DIAG_PEER && RTA_PAYLOAD(extra) >= 4) std::memcpy(&socket.peer, data, 4);
  }
  return socket;
}

/// Returns the numbers of the sockets that are connected to a socket named `path`.
std::set<std::uint32_t> connected_to(const std::filesystem::path& path) {
  std::set<std::uint32_t> peers;
  const FileDescriptor kernel(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_SOCK_DIAG));
  struct {
    nlmsghdr header;
    unix_diag_req request;
  } question{};
  question.header.nlmsg_len = sizeof question;
  question.header.nlmsg_type = SOCK_DIAG_BY_FAMILY;
  question.header.nlmsg_flags = NLM_F_REQUEST | NLM_F_DUMP;
  question.request.sdiag_family = AF_UNIX;
  question.request.udiag_states = ~0u;
  question.request.udiag_show = UDIAG_SHOW_NAME | UDIAG_SHOW_PEER;
  if (!kernel || ::send(kernel.get(), &question, sizeof question, 0) < 0) return peers;
  while (true) {
    alignas(nlmsghdr) char block[16384];
    const ssize_t n = ::recv(kernel.get(), block, sizeof block, 0);
    if (n <= 0) return peers;
    auto left = static_cast<unsigned>(n);
    for (auto* header = reinterpret_cast<nlmsghdr*>(block); NLMSG_OK(header, left); header = NLMSG_NEXT(header, left)) {
      if (header->nlmsg_type == NLMSG_DONE || header->nlmsg_type == NLMSG_ERROR) return peers;
      const Described socket = describe(header);
      if (socket.name == path.native() && socket.peer != 0) peers.insert(socket.peer);
    }
  }
}

}  // namespace

std::string who_is_connected_to(const std::filesystem::path& path) {
  const std::set<std::uint32_t> peers = connected_to(path);
  if (peers.empty()) return "";
  return process_with([&](const std::string& link) {
    constexpr std::string_view kSocket = "socket:[";
    if (!link.starts_with(kSocket)) return false;
    return peers.count(static_cast<std::uint32_t>(std::strtoul(link.c_str() + kSocket.size(), nullptr, 10))) > 0;
  });
}

std::string who_has_open(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(path, error);
  if (error) return "";
  return process_with([&](const std::string& link) { return link == real.native(); });
}

}  // namespace robot::nao
