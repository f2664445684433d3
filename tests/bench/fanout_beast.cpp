#include <utility>  // before Asio: Boost 1.74 uses std::exchange without it

#define BOOST_ERROR_CODE_HEADER_ONLY
#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/basic_stream_socket.hpp>
#include <boost/asio/basic_waitable_timer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <memory>
#include <string>
#include <thread>

#include "robot/net/foxglove/to_client.h"
#include "tests/bench/fanout.h"

namespace bench {
namespace {

namespace asio = boost::asio;
namespace websocket = boost::beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;
using Socket = asio::basic_stream_socket<tcp, asio::io_context::executor_type>;
using Acceptor = asio::basic_socket_acceptor<tcp, asio::io_context::executor_type>;

/// One client: it writes a message when the previous one is written.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(Socket socket, const std::string& message) : stream_(std::move(socket)), message_(message) {
    error_code ignored;
    stream_.next_layer().set_option(tcp::no_delay(true), ignored);
    stream_.set_option(websocket::stream_base::decorator(
        [](websocket::response_type& response) { response.set("Sec-WebSocket-Protocol", "foxglove.websocket.v1"); }));
    stream_.set_option(websocket::permessage_deflate{});
    stream_.auto_fragment(false);
    stream_.binary(true);
  }

  void start() {
    stream_.async_accept([self = shared_from_this()](error_code error) {
      if (error) return;
      self->read();
      self->write();
    });
  }

 private:
  void write() {
    stream_.async_write(asio::buffer(message_), [self = shared_from_this()](error_code error, std::size_t) {
      if (!error) self->write();
    });
  }

  void read() {
    stream_.async_read(input_, [self = shared_from_this()](error_code error, std::size_t) {
      if (error) return;
      self->input_.clear();
      self->read();
    });
  }

  websocket::stream<Socket> stream_;
  boost::beast::flat_buffer input_;
  const std::string& message_;
};

class Listener {
 public:
  Listener(asio::io_context& io, const std::string& message)
      : acceptor_(io, tcp::endpoint(asio::ip::address_v4::loopback(), 0)), io_(io), message_(message) {
    accept();
  }

  std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

 private:
  void accept() {
    acceptor_.async_accept(io_.get_executor(), [this](error_code error, Socket socket) {
      if (error) return;
      std::make_shared<Session>(std::move(socket), message_)->start();
      accept();
    });
  }

  Acceptor acceptor_;
  asio::io_context& io_;
  const std::string& message_;
};

}  // namespace

void serve_beast(const FanoutLoad& load, FanoutShared& shared) {
  // the same bytes as those of our server
  std::string message;
  robot::net::foxglove::append_message_data_header(message, 1, 1'700'000'000'000'000'000);
  message.append(load.payload_bytes, 'x');

  asio::io_context io{1};
  const Listener listener(io, message);
  std::thread serving([&io] { io.run(); });
  shared.port = listener.port();
  while (!shared.ended) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  io.stop();
  serving.join();
}

}  // namespace bench
