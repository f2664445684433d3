#include "robot/net/foxglove/web_socket_out_provider.h"

namespace robot::net {

Result<void> WebSocketOutProvider::write(const memory::VersionPtr& version) {
  version->bytes();                                       // serialises here instead of on the I/O thread
  inbox_->put({channel_, stream_, version}, cancelled_);  // after cancel() no client watches: nothing is lost
  return {};
}

Result<void> ConvertingOutProvider::write(const memory::VersionPtr& version) {
  auto bytes = convert_(*version);
  if (!bytes) return Error{info_.topic + ": " + bytes.error()};
  if (!*bytes) return {};
  return target_->write(memory::with_bytes(*version, ++last_sequence_, **std::move(bytes)));
}

}  // namespace robot::net
