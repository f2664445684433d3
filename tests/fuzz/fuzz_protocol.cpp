// Any text or binary message of a client or a server of the live protocol: no crash, no exception.
#include <cstdint>
#include <string_view>

#include "robot/core/encoding.h"
#include "robot/core/json_library.h"
#include "robot/net/foxglove/from_client.h"
#include "robot/net/foxglove/services.h"
#include "robot/net/foxglove/to_client.h"
#include "robot/net/http/origin_policy.h"
#include "robot/net/serve/session_page.h"
#include "robot/net/websocket/web_socket_client.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace net = robot::net;
  static const robot::ManualClock clock(1);
  static const net::Services services = [] {
    net::Services list;
    net::add_clock_sync(list, clock, {});
    // services of other programs copy their input, and repeat it in an error
    list.add("echo", net::Services::For::everybody, [](nlohmann::json request, const net::ClientContext&) {
      return nlohmann::json{{"ok", false},
                            {"error", request.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace)}};
    });
    return list;
  }();

  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  net::foxglove::parse_client_text(bytes).operator bool();
  net::foxglove::parse_client_binary(bytes).operator bool();
  net::foxglove::parse_advertise(bytes).operator bool();
  net::foxglove::parse_server_text(bytes).operator bool();
  net::foxglove::parse_message_data(bytes).operator bool();
  net::foxglove::parse_service_answer(bytes).operator bool();
  robot::from_base64(bytes).operator bool();
  net::parse_web_socket_url(bytes).operator bool();
  net::check_host({}, bytes).operator bool();
  net::check_origin({}, bytes, "nao.local").operator bool();
  net::session_page(bytes);
  for (const std::uint32_t service : {1, 2}) services.call(service, bytes, {});
  return 0;
}
