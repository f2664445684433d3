// Which request gets which answer.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "robot/net/http/assets.h"
#include "robot/net/http/http.h"
#include "robot/net/http/origin_policy.h"
#include "robot/net/serve/backend.h"

namespace robot::net {

/// Who may do what from beyond this machine.
struct AccessOptions {
  OriginPolicy origins;
  std::string control_token;  // for parameters and services; empty: nobody from beyond loopback
  std::string read_token;     // for watching and recordings; empty: everybody

  /// What a browser that came with a good token is given as a cookie, so that it may go on reading without the token
  /// in every address; gives no control. A secret of this run; empty: no cookies.
  std::string read_cookie;
};

/// What the other end of a connection may do.
struct Access {
  bool loopback = false;
  bool may_watch = false;
  bool may_control = false;
};

/// Decides by the address of the other end and by the token or the cookie it brings.
Access access_of(const AccessOptions& options, std::string_view address, const HttpRequest& request,
                 const Target& target);

/// Answers everything but WebSocket upgrades. Any thread.
class Routes {
 public:
  /// All three outlive the routes.
  Routes(const AccessOptions& access, std::span<const Asset> assets, Backend& backend)
      : access_(access), assets_(assets), backend_(backend) {}

  /// Whether answer() may wait for the disk.
  static bool may_wait(const HttpRequest& request);

  /// The answer to `request` from `address`.
  HttpResponse answer(const HttpRequest& request, std::string_view address) const;

 private:
  HttpResponse route(const HttpRequest& request, const Target& target, std::string_view address) const;
  HttpResponse answer_data(const HttpRequest& request, const Target& target, const Access& access) const;
  HttpResponse answer_played(const Target& target) const;
  HttpResponse answer_log(const HttpRequest& request, const Target& target) const;
  HttpResponse delete_session(const HttpRequest& request, const Target& target, const Access& access) const;
  HttpResponse answer_sessions(const HttpRequest& request) const;
  void add_cookie(const Target& target, HttpResponse& response) const;
  void add_cross_origin_headers(const HttpRequest& request, HttpResponse& response) const;

  const AccessOptions& access_;
  std::span<const Asset> assets_;
  Backend& backend_;
};

/// Reads the query of `GET /api/played`.
Result<PlayedRequest> parse_played_request(const Target& target);

/// Reads the path and query of `GET /logs/…mcap`.
Result<LogRequest> parse_log_request(const Target& target);

}  // namespace robot::net
