#include "robot/net/http/response_head.h"

#include <algorithm>
#include <utility>  // before Asio: Boost 1.74 uses std::exchange without it

#define BOOST_ERROR_CODE_HEADER_ONLY
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/serializer.hpp>

namespace robot::net {
namespace {

namespace http = boost::beast::http;

constexpr std::string_view kPolicyName = "Content-Security-Policy";
constexpr std::string_view kPolicy =
    "default-src 'self'; connect-src 'self' ws: wss:; img-src 'self' blob: data:; object-src 'none'; "
    "base-uri 'none'; form-action 'none'";
constexpr std::pair<std::string_view, std::string_view> kSecurityHeaders[] = {{"X-Content-Type-Options", "nosniff"},
                                                                              {"Referrer-Policy", "no-referrer"}};

}  // namespace

std::string response_head(const HttpResponse& response, bool keep_alive, std::string_view frame_ancestors) {
  Headers headers = response.headers;
  if (response.status != 204 && response.status != 304)
    headers.emplace_back("Content-Length", std::to_string(response.body_size()));
  // a browser obeys each policy that it gets, so there must be only one
  auto policy = std::ranges::find(headers, kPolicyName, &Headers::value_type::first);
  if (policy == headers.end()) policy = headers.emplace(policy, kPolicyName, kPolicy);
  policy->second.append("; frame-ancestors ").append(frame_ancestors);
  headers.insert(headers.end(), std::begin(kSecurityHeaders), std::end(kSecurityHeaders));
  headers.emplace_back("Connection", keep_alive ? "keep-alive" : "close");
  return plain_head(response.status, headers);
}

std::string plain_head(int status, const Headers& headers) {
  http::response<http::empty_body> response(static_cast<http::status>(status), 11);  // HTTP/1.1
  for (const auto& [name, value] : headers) response.insert(name, value);

  // the body's bytes are sent by us, piece by piece
  http::response_serializer<http::empty_body> serializer(response);
  serializer.split(true);
  std::string head;
  boost::beast::error_code error;
  serializer.next(
      error, [&](boost::beast::error_code&, const auto& buffers) { head = boost::beast::buffers_to_string(buffers); });
  return head;
}

}  // namespace robot::net
