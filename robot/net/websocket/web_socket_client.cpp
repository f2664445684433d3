#include "robot/net/websocket/web_socket_client.h"

#include <utility>  // before Asio: Boost 1.74 uses std::exchange without it

#define BOOST_ERROR_CODE_HEADER_ONLY
#include <fcntl.h>

#include <algorithm>
#include <array>
#include <boost/asio/basic_stream_socket.hpp>
#include <boost/asio/connect.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core/bind_handler.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <charconv>
#include <chrono>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "robot/core/clock.h"
#include "robot/core/lock.h"
#include "robot/core/thread.h"
#include "robot/net/websocket/handshake.h"

namespace robot::net {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;
using Executor = asio::io_context::executor_type;

constexpr std::uint64_t kForever = UINT64_MAX;
constexpr std::uint64_t kLongestSleep = 3600 * kSecond;  // steps of a wait, so that no deadline overflows
constexpr std::uint64_t kCancelNs = kSecond / 20;        // the longest time until a search notices cancel()
constexpr std::size_t kMaxReservedBytes = 1 << 20;
constexpr std::size_t kMaxQuotedBytes = 200;  // of the server's words in an error sentence

/// A TCP socket that Beast gives up at once after the goodbyes.
class Socket : public asio::basic_stream_socket<tcp, Executor> {
 public:
  using basic_stream_socket::basic_stream_socket;
};

// Beast calls it after a close frame or a violation; its own version waits until the server closes, maybe forever
template <class Handler>
void async_teardown(beast::role_type, Socket& socket, Handler&& handler) {
  error_code ignored;
  socket.shutdown(Socket::shutdown_both, ignored);
  asio::post(socket.get_executor(), beast::bind_front_handler(std::forward<Handler>(handler), error_code()));
}

using Endpoints = std::vector<tcp::endpoint>;

/// A search for the addresses of a name, on a thread of its own: the system's search can take many seconds, and cannot be
/// ended. A search that nobody waits for any more ends by itself.
class Search {
 public:
  /// Returns null if the system has no room for another thread.
  static std::shared_ptr<Search> begin(const std::string& host, const std::string& port) {
    auto search = std::make_shared<Search>();
    std::thread searching;
    if (!start_thread(searching, "resolve", [search, host, port] { search->run(host, port); })) return nullptr;
    searching.detach();
    return search;
  }

  /// Waits until the search has ended, at most until `until_ns`. Returns whether it has.
  bool wait(std::uint64_t until_ns) {
    const std::lock_guard guard(lock_);
    if (!done_) ended_.wait_until(lock_, until_ns);
    return done_;
  }

  // after wait() returned true
  const Endpoints& endpoints() const { return endpoints_; }
  const error_code& error() const { return error_; }

 private:
  void run(const std::string& host, const std::string& port) {
    become_background_thread("resolve");
    asio::io_context io;
    error_code error;
    const auto found =
        asio::ip::basic_resolver<tcp, Executor>(io).resolve(host, port, tcp::resolver::numeric_service, error);
    const std::lock_guard guard(lock_);
    for (const auto& entry : found) endpoints_.push_back(entry.endpoint());
    error_ = error;
    done_ = true;
    ended_.notify_all();
  }

  Mutex lock_;
  Condition ended_;
  bool done_ = false;
  Endpoints endpoints_;
  error_code error_;
};

/// The state of an asynchronous operation.
struct Step {
  bool done = false;
  error_code error = {};
};

}  // namespace

/// The connection. Each call runs Beast's operations until its own has ended; a read may stay pending between calls.
struct WebSocketClient::Connection {
  // returns false when cancelled, an Error at the deadline
  Result<bool> wait(const Step& step, std::uint64_t deadline_ns);
  Result<void> finish(const Step& step, std::uint64_t deadline_ns);
  Result<Endpoints> find(const WebSocketUrl& url, std::uint64_t deadline_ns);
  Result<void> open_socket(const WebSocketUrl& url, std::uint64_t deadline_ns);
  Result<void> shake_hands(const WebSocketUrl& url, std::uint64_t deadline_ns);
  void prepare();
  void read_on();
  std::string sentence(const error_code& error) const;
  std::string refusal() const;
  Error problem(const std::string& text) const { return Error{name + ": " + text}; }

  asio::io_context io;                                          // cancel() stops it forever
  asio::executor_work_guard<Executor> work{io.get_executor()};  // nothing else stops it
  std::string name;                                             // the url, for error sentences
  std::optional<websocket::stream<Socket, false>> stream;       // false: without compression
  websocket::response_type response;

  // operations outlive a call that returns at its deadline, so their state is here
  Step opened, sent, received;
  bool agreed = false, reading = false;
  std::array<char, 65536> block;
  std::string payload;  // the message so far
  std::optional<CloseInfo> closed;
};

Result<bool> WebSocketClient::Connection::wait(const Step& step, std::uint64_t deadline_ns) {
  while (!step.done) {
    if (io.stopped()) return false;
    const std::uint64_t now_ns = monotonic_ns();
    if (now_ns >= deadline_ns) return problem("no answer in time");
    io.run_one_for(std::chrono::nanoseconds(std::min(deadline_ns - now_ns, kLongestSleep)));
  }
  return true;
}

Result<void> WebSocketClient::Connection::finish(const Step& step, std::uint64_t deadline_ns) {
  const auto done = wait(step, deadline_ns);
  if (!done) return done.failure();
  if (!*done) return problem("cancelled");
  if (step.error) return problem(sentence(step.error));
  return {};
}

std::string WebSocketClient::Connection::sentence(const error_code& error) const {
  if (error == asio::error::eof) return "the connection ended without a goodbye";
  if (error == asio::error::operation_aborted) return "the connection has ended";
  if (error == http::error::end_of_stream || error == http::error::partial_message)
    return "expected an HTTP response, got none";
  if (error.category() == make_error_code(http::error::end_of_stream).category())
    return "expected an HTTP response, got another answer (" + error.message() + ")";
  if (error == websocket::error::upgrade_declined) return refusal();
  if (error == websocket::condition::handshake_failed)
    return "WebSocket: the server's answer does not belong to our request (" + error.message() + ")";
  if (error == websocket::error::message_too_big)
    return "a message has more than " + std::to_string(kMaxMessageBytes) + " bytes";
  if (error == websocket::condition::protocol_violation)
    return "the server broke the protocol (" + error.message() + ")";
  return error.message();
}

// our servers give the reason in the body
std::string WebSocketClient::Connection::refusal() const {
  const std::string status = std::to_string(response.result_int()) + " " + std::string(response.reason());
  const std::string reason = response.body().substr(0, response.body().find('\n'));
  return "WebSocket: expected the server to agree (101), got '" + status.substr(0, kMaxQuotedBytes) + "'" +
         (reason.empty() ? "" : ": " + reason.substr(0, kMaxQuotedBytes));
}

Result<Endpoints> WebSocketClient::Connection::find(const WebSocketUrl& url, std::uint64_t deadline_ns) {
  error_code is_name;
  const auto address = asio::ip::make_address(url.host, is_name);
  std::uint16_t port = 0;
  const auto [end, wrong] = std::from_chars(url.port.data(), url.port.data() + url.port.size(), port);
  if (!is_name && wrong == std::errc() && end == url.port.data() + url.port.size())
    return Endpoints{tcp::endpoint(address, port)};
  const auto search = Search::begin(url.host, url.port);
  if (!search) return problem("the system has no room for another thread");
  while (!search->wait(std::min(deadline_ns, monotonic_ns() + kCancelNs))) {
    if (io.stopped()) return problem("cancelled");
    if (monotonic_ns() >= deadline_ns) return problem("the name '" + url.host + "' was not found in time");
  }
  if (search->error()) return problem(search->error().message());
  return search->endpoints();
}

Result<void> WebSocketClient::Connection::open_socket(const WebSocketUrl& url, std::uint64_t deadline_ns) {
  const Result<Endpoints> endpoints = find(url, deadline_ns);
  if (!endpoints) return endpoints.failure();
  error_code error;
  Socket& socket = stream->next_layer();
  asio::async_connect(socket, *endpoints, [this](const error_code& result, const tcp::endpoint&) {
    opened = {true, result};
  });
  if (auto connected = finish(opened, deadline_ns); !connected) return connected;
  ::fcntl(socket.native_handle(), F_SETFD, FD_CLOEXEC);
  socket.set_option(tcp::no_delay(true), error);
  return {};
}

// sets the options of the stream
void WebSocketClient::Connection::prepare() {
  stream->auto_fragment(false);
  stream->read_message_max(kMaxMessageBytes);
  stream->set_option(websocket::stream_base::decorator([](websocket::request_type& request) {
    request.set(http::field::user_agent, "foresight");
    request.set(http::field::sec_websocket_protocol,
                std::string(kSubprotocols[0]).append(", ").append(kSubprotocols[1]));
  }));
  // a goodbye counts when it comes, even if our answer to it cannot be sent
  stream->control_callback([this](websocket::frame_type type, beast::string_view) {
    if (type != websocket::frame_type::close) return;
    const websocket::close_reason& reason = stream->reason();
    closed = CloseInfo{reason.code == websocket::close_code::none ? std::uint16_t{kNoCodeGiven} : reason.code,
                       std::string(reason.reason.data(), reason.reason.size())};
    received.done = true;
  });
}

Result<void> WebSocketClient::Connection::shake_hands(const WebSocketUrl& url, std::uint64_t deadline_ns) {
  opened = {};
  stream->async_handshake(response, url.authority(), url.target, [this](const error_code& result) {
    opened = {true, result};
  });
  if (auto answered = finish(opened, deadline_ns); !answered) return answered;
  const auto chosen = response[http::field::sec_websocket_protocol];
  agreed = std::ranges::find(kSubprotocols, std::string_view(chosen.data(), chosen.size())) != std::end(kSubprotocols);
  if (!agreed)
    return problem("WebSocket: expected the server to choose one of our subprotocols, got '" +
                   std::string(chosen.substr(0, kMaxQuotedBytes)) + "'");
  return {};
}

// reads piece by piece: the announced size alone makes us reserve no more than kMaxReservedBytes
void WebSocketClient::Connection::read_on() {
  stream->async_read_some(asio::buffer(block), [this](const error_code& error, std::size_t size) {
    payload.append(block.data(), size);
    received = {error || stream->is_message_done(), error};
    if (received.done) return;
    payload.reserve(payload.size() + std::min(stream->read_size_hint(block.size()), kMaxReservedBytes));
    read_on();
  });
}

WebSocketClient::WebSocketClient() : connection_(std::make_unique<Connection>()) {}
WebSocketClient::~WebSocketClient() = default;

void WebSocketClient::cancel() { connection_->io.stop(); }

const std::optional<CloseInfo>& WebSocketClient::closed() const { return connection_->closed; }

int WebSocketClient::socket() const { return connection_->stream->next_layer().native_handle(); }

Result<void> WebSocketClient::connect(std::string_view text, std::uint64_t timeout_ns) {
  Connection& connection = *connection_;
  // the token must not appear in error sentences
  connection.name = std::string(text.substr(0, std::min(text.find('?'), text.size())));
  const std::uint64_t deadline_ns = monotonic_ns() + timeout_ns;
  const auto url = parse_web_socket_url(text);
  if (!url) return url.failure();
  try {
    connection.stream.emplace(connection.io);
  } catch (const boost::system::system_error& error) {  // no file descriptor is left
    return connection.problem(error.code().message());
  }
  connection.prepare();
  if (auto opened = connection.open_socket(*url, deadline_ns); !opened) return opened;
  return connection.shake_hands(*url, deadline_ns);
}

Result<void> WebSocketClient::send(Opcode opcode, std::string_view payload) {
  Connection& connection = *connection_;
  if (connection.io.stopped()) return connection.problem("cancelled");
  if (!connection.agreed) return connection.problem("there is no connection");
  connection.sent = {};
  connection.stream->binary(opcode == Opcode::binary);
  connection.stream->async_write(asio::buffer(payload), [&connection](const error_code& error, std::size_t) {
    connection.sent = {true, error};
  });
  return connection.finish(connection.sent, kForever);
}

Result<std::optional<WebSocketClient::Message>> WebSocketClient::receive(std::uint64_t deadline_ns) {
  Connection& connection = *connection_;
  if (connection.io.stopped() || connection.closed) return std::optional<Message>();
  if (!connection.agreed) return connection.problem("there is no connection");
  if (!connection.reading) {
    connection.reading = true;
    connection.received = {};
    connection.read_on();
  }
  const auto ready = connection.wait(connection.received, deadline_ns);
  if (!ready) return ready.failure();
  if (!*ready || connection.closed) return std::optional<Message>();
  // after an error every call returns it
  if (connection.received.error) return connection.problem(connection.sentence(connection.received.error));
  connection.reading = false;
  return std::optional(
      Message{connection.stream->got_binary() ? Opcode::binary : Opcode::text, std::exchange(connection.payload, {})});
}

}  // namespace robot::net
