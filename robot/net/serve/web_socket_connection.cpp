#include "robot/net/serve/web_socket_connection.h"

#include <boost/asio/write.hpp>

namespace robot::net {
namespace {

using boost::system::error_code;

}  // namespace

WebSocketConnection::WebSocketConnection(Socket socket, ConnectionContext& context)
    : socket_(std::move(socket)), context_(context), parser_(Sender::client, context.options.max_message_bytes) {}

void WebSocketConnection::start(ClientIdentity identity, std::string response, std::string begun) {
  set_low_latency(socket_);
  client_ = context_.hub.join(std::move(identity));

  // the answer goes out before the first frame
  batch_.bytes = std::move(response);
  writing_ = true;
  boost::asio::async_write(socket_, boost::asio::buffer(batch_.bytes),
                           [self = shared_from_this()](error_code error, std::size_t) {
                             self->writing_ = false;
                             if (!self->client_) return;
                             if (error) return self->close();
                             self->flush();
                           });
  take(begun);
  if (client_) read();
}

void WebSocketConnection::read() {
  socket_.async_read_some(boost::asio::buffer(input_), [self = shared_from_this()](error_code error, std::size_t size) {
    if (!self->client_) return;
    if (error) return self->close();
    self->take({self->input_.data(), size});
    if (self->client_) self->read();
  });
}

void WebSocketConnection::take(std::string_view bytes) {
  const auto violation =
      parser_.feed(bytes, [this](Opcode opcode, const std::string& payload) { return on_message(opcode, payload); });
  if (violation) context_.hub.disconnect(*client_, violation->close_code, "WebSocket: " + violation->sentence);
  if (peer_closed_ && sent_all_) return close();
  flush();
}

bool WebSocketConnection::on_message(Opcode opcode, const std::string& payload) {
  switch (opcode) {
    case Opcode::text: context_.hub.on_text(*client_, payload); return true;
    case Opcode::binary: context_.hub.on_binary(*client_, payload); return true;
    case Opcode::pong: context_.hub.on_pong(*client_, monotonic_ns()); return true;
    case Opcode::ping: {
      std::string frame;
      append_frame(frame, Opcode::pong, payload);
      context_.hub.send(*client_, std::move(frame));
      return true;
    }
    case Opcode::close: {
      // answer with the same code; both sides have then sent a close frame
      const std::uint16_t code = parse_close(payload).code;
      peer_closed_ = true;
      client_->queue.finish(close_frame(code == kNoCodeGiven ? std::uint16_t{kNormalClosure} : code, {}));
      return false;
    }
    case Opcode::continuation: break;  // the parser puts fragments together
  }
  return true;
}

void WebSocketConnection::flush() {
  if (!client_) return;
  if (client_->queue.finished() && deadline_ns_ == UINT64_MAX)
    deadline_ns_ = monotonic_ns() + context_.options.close_timeout_ns;
  if (writing_ || sent_all_ || !client_->queue.fill(batch_)) return;

  writing_ = true;
  const std::array<boost::asio::const_buffer, 2> buffers = {boost::asio::buffer(batch_.bytes),
                                                            boost::asio::buffer(batch_.large)};
  boost::asio::async_write(socket_, buffers, [self = shared_from_this()](error_code error, std::size_t) {
    self->writing_ = false;
    if (!self->client_) return;
    if (error) return self->close();
    self->on_written();
  });
}

void WebSocketConnection::on_written() {
  batch_.keeper.reset();  // do not hold a large message longer than needed
  if (!client_->queue.finished() || !client_->queue.empty()) return flush();

  // the close frame is sent; the client closes the connection after reading it
  sent_all_ = true;
  error_code ignored;
  socket_.shutdown(Socket::shutdown_send, ignored);
  if (peer_closed_) close();
}

void WebSocketConnection::check_deadline(std::uint64_t now_ns) {
  if (now_ns >= deadline_ns_) close();
}

void WebSocketConnection::go_away() {
  if (!client_) return;
  client_->queue.finish(close_frame(kGoingAway, "the server stops"));
  flush();
}

void WebSocketConnection::close() {
  if (!client_) return;
  context_.hub.leave(*client_);
  client_.reset();
  error_code ignored;
  socket_.close(ignored);
  context_.web_sockets.erase(shared_from_this());
}

}  // namespace robot::net
