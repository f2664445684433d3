// The HTTP routes and the access rules.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "robot/net/http/assets.h"
#include "robot/net/http/http.h"
#include "robot/net/http/origin_policy.h"
#include "robot/net/serve/backend.h"

namespace robot::net {

/// Access rules for clients on other machines.
struct AccessOptions {
  OriginPolicy origins;
  std::string control_token;  // for parameters and services; empty: loopback clients only
  std::string read_token;     // for watching and recordings; empty: no token is needed

  /// The cookie for a browser that came with a valid token. With it the browser may read without the token in every
  /// address, but may not control. A secret of this run; empty: no cookies.
  std::string read_cookie;

  std::string frame_ancestors = "'none'";  // pages that may show the viewer in a frame, see origin_policy.h
};

/// The rights of the client of a connection.
struct Access {
  bool loopback = false;
  bool may_watch = false;
  bool may_control = false;
};

/// Returns the rights of a client at `address`, by the token or the cookie of its request.
Access access_of(const AccessOptions& options, std::string_view address, const HttpRequest& request,
                 const Target& target);

/// The kind of waiting for an answer. Each kind has a thread, so that the status never waits for the disk, and the list of
/// sessions never for a checksum.
enum class Work {
  none,       // it does not wait
  status,     // a tenth of a second at most: status and lists
  files,      // it reads the beginning or the index of files
  checksums,  // it reads whole files, for minutes: checksums, downloads for other viewers, answers about a whole recording
};

/// The answers to all requests except WebSocket upgrades. Any thread.
class Routes {
 public:
  /// All three arguments must outlive the routes.
  Routes(const AccessOptions& access, std::span<const Asset> assets, Backend& backend)
      : access_(access), assets_(assets), backend_(backend) {}

  /// Returns the work of answer().
  static Work work_of(const HttpRequest& request);

  /// Returns the answer to `request` from a client at `address`. Long work ends early when the client has left.
  HttpResponse answer(const HttpRequest& request, std::string_view address, const ClientLeft& left) const;

 private:
  HttpResponse route(const HttpRequest& request, const Target& target, std::string_view address,
                     const ClientLeft& left) const;
  HttpResponse answer_data(const HttpRequest& request, const Target& target, const Access& access,
                           const ClientLeft& left) const;
  HttpResponse answer_report(const std::string& name) const;
  HttpResponse answer_played(const Target& target) const;
  HttpResponse answer_log(const HttpRequest& request, const Target& target, const ClientLeft& left) const;
  HttpResponse delete_session(const HttpRequest& request, const Target& target, const Access& access) const;
  HttpResponse answer_sessions(const HttpRequest& request) const;
  void add_cookie(const Target& target, HttpResponse& response) const;
  void add_cross_origin_headers(const HttpRequest& request, HttpResponse& response) const;

  const AccessOptions& access_;
  std::span<const Asset> assets_;
  Backend& backend_;
};

/// Parses the query of `GET /api/played`.
Result<PlayedRequest> parse_played_request(const Target& target);

/// Parses the path and query of `GET /logs/…mcap`.
Result<LogRequest> parse_log_request(const Target& target);

}  // namespace robot::net
