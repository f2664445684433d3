#include "robot/net/serve/http_connection.h"

#include <sys/socket.h>

#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <cerrno>
#include <charconv>

#include "robot/net/http/response_head.h"
#include "robot/net/serve/web_socket_connection.h"

namespace robot::net {
namespace {

using boost::system::error_code;

constexpr std::size_t kPieceBytes = 64 << 10;  // of a recording: read and written in turns

/// Returns the playhead that `?playhead=own` or `?playhead=TIME` asks for, see ClientIdentity.
std::optional<std::uint64_t> playhead_in(const Target& target) {
  if (!target.parameters.contains("playhead")) return std::nullopt;
  const std::string text = target.parameter("playhead");
  std::uint64_t from_ns = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), from_ns);
  return error == std::errc() && end == text.data() + text.size() ? from_ns : 0;
}

}  // namespace

HttpConnection::HttpConnection(Socket socket, Remote remote, ConnectionContext& context)
    : socket_(std::move(socket)), remote_(std::move(remote)), context_(context), made_ns_(monotonic_ns()) {}

void HttpConnection::start() { wait_for_request(context_.options.request_timeout_ns); }

// the deadline is for the whole header: sending it byte by byte gains no time
void HttpConnection::wait_for_request(std::uint64_t timeout_ns) {
  state_ = State::waiting;
  deadline_ns_ = monotonic_ns() + timeout_ns;
  take_requests();
}

void HttpConnection::read() {
  socket_.async_read_some(boost::asio::buffer(input_), [self = shared_from_this()](error_code error, std::size_t size) {
    if (self->state_ == State::closed) return;
    if (error) return self->close();
    if (self->state_ == State::leaving) return self->read();  // later bytes are ignored

    // waiting between two requests is cheap; a request that has begun must arrive in time
    if (!self->parser_.begun())
      self->deadline_ns_ = std::min(self->deadline_ns_, monotonic_ns() + self->context_.options.request_timeout_ns);
    self->parser_.add({self->input_.data(), size});
    self->take_requests();
  });
}

void HttpConnection::take_requests() {
  auto request = parser_.next();
  if (!request) {
    request_ = {.method = "GET", .keep_alive = false};
    return respond(error_response(400, request.error()));
  }
  if (!*request) return read();
  handle(**std::move(request));
}

void HttpConnection::handle(HttpRequest request) {
  state_ = State::answering;
  deadline_ns_ = UINT64_MAX;  // our own work has no deadline
  request_ = std::move(request);
  if (wants_web_socket(request_)) return upgrade(request_);
  switch (Routes::work_of(request_)) {
    case Work::none: return respond(context_.routes.answer(request_, remote_.address, {}));
    case Work::status: return answer_on(context_.status);
    case Work::files: return answer_on(context_.files);
    case Work::checksums: watch_client(); return answer_on(context_.checksums);
  }
}

void HttpConnection::answer_on(Worker& worker) {
  worker.post([self = shared_from_this(), request = request_] {
    const ClientLeft left = [&left = self->left_] { return left.load(); };
    if (left()) return;
    HttpResponse response = self->context_.routes.answer(request, self->remote_.address, left);
    boost::asio::post(self->context_.io, [self, response = std::move(response)]() mutable {
      if (self->state_ == State::answering) self->respond(std::move(response));
    });
  });
}

/// Ends the connection if the client ends it before its answer is ready. Short answers do without: a client that has
/// only finished sending, as `nc -N` does, still gets them.
void HttpConnection::watch_client() {
  watched_ = true;
  socket_.async_wait(Socket::wait_read, [self = shared_from_this()](error_code error) {
    if (error || !self->watched_ || self->state_ != State::answering) return;
    char byte = 0;
    const ssize_t n = ::recv(self->socket_.native_handle(), &byte, 1, MSG_PEEK | MSG_DONTWAIT);
    if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) self->close();
  });
}

void HttpConnection::upgrade(const HttpRequest& request) {
  const auto target = parse_target(request.target);
  HttpResponse refusal;
  const auto agreed = target ? agree(request, *target, refusal) : Result<Upgrade>(target.failure());
  if (!agreed) {
    request_.keep_alive = false;
    return respond(refusal.status == 200 ? error_response(400, agreed.error()) : std::move(refusal));
  }

  const Access access = access_of(context_.options.access, remote_.address, request, *target);
  ClientIdentity identity{
      .context = {.address = remote_.text(), .loopback = access.loopback, .may_control = access.may_control},
      .user_agent = std::string(request.header("user-agent").value_or("").substr(0, 200)),
      .subprotocol = agreed->subprotocol,
      .lossless = target->parameter("delivery") == "lossless",
      .numbered = target->parameters.contains("numbered"),
      .playback = target->parameters.contains("playback"),
      .playhead = playhead_in(*target)};
  auto connection = std::make_shared<WebSocketConnection>(std::move(socket_), context_);
  context_.web_sockets.insert(connection);
  connection->start(std::move(identity), agreed->response, parser_.take_rest());
  state_ = State::closed;
  context_.http.erase(shared_from_this());
}

// an Error that leaves `refusal` unchanged means a bad request
Result<Upgrade> HttpConnection::agree(const HttpRequest& request, const Target& target, HttpResponse& refusal) const {
  const auto refuse = [&](int status, const std::string& sentence) {
    refusal = error_response(status, sentence);
    return Error{sentence};
  };
  const AccessOptions& access = context_.options.access;
  if (std::ranges::count(request.headers, "host", &Headers::value_type::first) != 1)
    return Error{"HTTP request: expected one Host header"};
  const std::string_view host = *request.header("host");
  if (auto accepted = check_host(access.origins, host); !accepted) return refuse(403, accepted.error());
  if (auto accepted = check_origin(access.origins, request.header("origin"), host); !accepted)
    return refuse(403, accepted.error());
  if (!access_of(access, remote_.address, request, target).may_watch)
    return refuse(401, "watching this robot needs its read token: add ?token=<token> to the address");
  if (context_.web_sockets.size() >= context_.options.max_clients)
    return refuse(503,
                  "there are " + std::to_string(context_.web_sockets.size()) + " clients already, no more are taken");
  return accept_web_socket(request);
}

void HttpConnection::respond(HttpResponse response) {
  state_ = State::answering;
  watched_ = false;
  deadline_ns_ = monotonic_ns() + context_.options.idle_timeout_ns;
  response_ = std::move(response);
  body_sent_ = 0;
  head_ = response_head(response_, request_.keep_alive, context_.options.access.frame_ancestors);

  std::string_view body;
  if (const auto* text = std::get_if<std::string>(&response_.body)) body = *text;
  if (const auto* text = std::get_if<std::string_view>(&response_.body)) body = *text;
  if (request_.method == "HEAD") {
    body = {};
    response_.body = std::string();
  }
  write(head_, body);
}

void HttpConnection::write(std::string_view head, std::string_view body) {
  const std::array<boost::asio::const_buffer, 2> buffers = {boost::asio::buffer(head), boost::asio::buffer(body)};
  boost::asio::async_write(socket_, buffers, [self = shared_from_this()](error_code error, std::size_t) {
    if (self->state_ != State::answering) return;
    if (error) return self->close();
    self->on_written();
  });
}

void HttpConnection::on_written() {
  deadline_ns_ = monotonic_ns() + context_.options.idle_timeout_ns;
  const auto* part = std::get_if<BodyPart>(&response_.body);
  if (part && body_sent_ < part->size) return read_piece();
  response_ = {};
  piece_.reset();
  if (!request_.keep_alive) return leave();
  wait_for_request(context_.options.idle_timeout_ns);
}

// the thread of downloads reads a piece, then the I/O thread writes it; neither waits for the device of the other
void HttpConnection::read_piece() {
  deadline_ns_ = UINT64_MAX;
  if (!piece_) piece_ = std::make_shared<std::string>();
  const BodyPart& part = std::get<BodyPart>(response_.body);
  const std::size_t wanted = static_cast<std::size_t>(std::min<std::uint64_t>(kPieceBytes, part.size - body_sent_));

  context_.downloads.post(
      [self = shared_from_this(), source = part.source, offset = part.offset + body_sent_, wanted, piece = piece_] {
        if (self->left_) return;
        piece->resize(wanted);
        const bool whole = static_cast<bool>(source->read(offset, *piece));
        boost::asio::post(self->context_.io, [self, whole] {
          if (self->state_ != State::answering) return;
          if (!whole) return self->close();  // the client sees that bytes are missing
          self->body_sent_ += self->piece_->size();
          self->deadline_ns_ = monotonic_ns() + self->context_.options.idle_timeout_ns;
          self->write(*self->piece_, {});
        });
      });
}

// after an immediate close the kernel would discard an answer that the client has not read yet
void HttpConnection::leave() {
  state_ = State::leaving;
  deadline_ns_ = monotonic_ns() + kSecond;
  error_code ignored;
  socket_.shutdown(Socket::shutdown_send, ignored);
  read();
}

void HttpConnection::check_deadline(std::uint64_t now_ns) {
  if (now_ns >= deadline_ns_) close();
}

void HttpConnection::close() {
  if (state_ == State::closed) return;
  state_ = State::closed;
  left_ = true;
  error_code ignored;
  socket_.close(ignored);
  context_.http.erase(shared_from_this());
}

}  // namespace robot::net
