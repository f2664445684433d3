#include "robot/net/serve/server.h"

#include "robot/net/serve/connection.h"  // Asio first, see there

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/basic_waitable_timer.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/post.hpp>
#include <chrono>
#include <mutex>
#include <thread>

#include "robot/core/attempt.h"
#include "robot/core/files.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"
#include "robot/net/http/response_head.h"
#include "robot/net/serve/http_connection.h"
#include "robot/net/serve/web_socket_connection.h"
#include "robot/net/serve/wireless.h"

namespace robot::net {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using Acceptor = asio::basic_socket_acceptor<tcp, asio::io_context::executor_type>;
using Timer = asio::basic_waitable_timer<std::chrono::steady_clock, asio::wait_traits<std::chrono::steady_clock>,
                                         asio::io_context::executor_type>;

constexpr auto kTick = std::chrono::milliseconds(100);  // Time frames go out at 10 Hz

/// Ends a connection at once and discards its unsent data.
void reset(Socket& socket) {
  error_code ignored;
  socket.set_option(asio::socket_base::linger(true, 0), ignored);
  socket.close(ignored);
}

}  // namespace

/// The state of a running server. The I/O thread calls all functions that name no other thread.
class Server::Core {
 public:
  Core(ServerOptions options, memory::Channels& channels, Derive derive, Streams& streams, const Clock& clock,
       Parameters& parameters, const Services& services, Backend& backend)
      : options_(std::move(options)),
        channels_(channels),
        derive_(std::move(derive)),
        parameters_(parameters),
        backend_(backend),
        inbox_(std::make_shared<Inbox>(options_.inbox_bytes, [this] { asio::post(io_, [this] { drain(); }); })),
        streams_(streams, inbox_),
        control_("net control"),
        questions_("net questions"),
        hub_(options_.hub, parameters, services, clock, streams_,
             [this](Hub::Kind kind, std::function<void()> work, std::function<void()> then) {
               (kind == Hub::Kind::question ? questions_ : control_)
                   .post([inbox = inbox_, work = std::move(work), then = std::move(then)] {
                     work();
                     inbox->post(then);
                   });
             }),
        routes_(options_.access, options_.assets, backend),
        status_("net status"),
        files_("net files"),
        checksums_("net checksums"),
        downloads_("net downloads"),
        context_{.options = options_,
                 .routes = routes_,
                 .hub = hub_,
                 .io = io_,
                 .status = status_,
                 .files = files_,
                 .checksums = checksums_,
                 .downloads = downloads_},
        timer_(io_) {}

  Result<void> start();  // the owner's thread
  void stop();           // the owner's thread
  std::uint16_t port() const { return port_; }

  // any thread
  ServerStatistics statistics() const {
    const std::lock_guard guard(statistics_lock_);
    return statistics_;
  }
  void set_metadata(const std::string& key, const std::string& value) {
    inbox_->post([this, key, value] { hub_.set_metadata(key, value); });
  }
  void restart_time() {
    inbox_->post([this] { hub_.restart_time(); });
  }

 private:
  std::array<Worker*, 6> workers() { return {&control_, &questions_, &status_, &files_, &checksums_, &downloads_}; }
  void run();
  Result<void> listen(const std::string& address);
  void watch();
  void accept(Acceptor& acceptor);
  bool make_room();
  void turn_away(Acceptor& acceptor);
  void take_back_spare();
  void admit(Socket socket);
  void tick();
  void beat(std::uint64_t now);
  void follow_match();
  void keep_silence(bool silent);
  void drain();
  void flush_all();
  void begin_stop();
  void finish_stop();

  const ServerOptions options_;
  memory::Channels& channels_;
  const Derive derive_;
  Parameters& parameters_;
  const Backend& backend_;

  asio::io_context io_{1};
  std::shared_ptr<Inbox> inbox_;
  StreamControl streams_;
  Worker control_, questions_;
  Hub hub_;
  Routes routes_;
  Worker status_, files_, checksums_, downloads_;
  ConnectionContext context_;

  std::vector<std::unique_ptr<Acceptor>> acceptors_;
  bool match_mode_ = false;
  Wireless wireless_;                       // the interfaces that stay silent in match mode
  std::vector<Acceptor*> tired_acceptors_;  // out of file descriptors: tried again with the next tick
  FileDescriptor spare_ = spare_descriptor(),
                 turned_away_;  // the second takes the place of the first until the next tick
  std::uint16_t port_ = 0;
  Timer timer_;
  std::uint64_t next_second_ns_ = 0;
  std::uint64_t stop_deadline_ns_ = 0;  // 0: not stopping
  Inbox::Contents contents_;

  Throttle io_failures_;

  mutable Mutex statistics_lock_;
  ServerStatistics statistics_;

  std::thread thread_;  // last: it uses all other members
};

Result<void> Server::Core::start() {
  port_ = options_.port;
  for (const std::string& address : options_.bind)
    if (auto listening = listen(address); !listening) return listening;
  for (Worker* worker : workers())
    if (Result<void> started = worker->start(); !started) return started;
  if (Result<void> started = streams_.start_thread(); !started) return started;
  watch();
  for (const auto& acceptor : acceptors_) accept(*acceptor);
  next_second_ns_ = monotonic_ns() + kSecond;
  tick();
  return start_thread(thread_, "net", [this] { run(); });
}

/// Runs the I/O until the server stops. A handler that fails, for lack of memory, costs its own client at most.
void Server::Core::run() {
  become_background_thread("net");
  while (!io_.stopped())
    if (const Result<void> ran = attempt("serving a client", [this] { io_.run(); }); !ran)
      io_failures_.report(Level::error, "net", ran.error());
}

Result<void> Server::Core::listen(const std::string& address) {
  const std::string where = address + ":" + std::to_string(port_);
  error_code error;
  const auto ip = asio::ip::make_address(address, error);
  if (error) return Error{"cannot listen on " + where + ": expected an IP address"};

  auto acceptor = std::make_unique<Acceptor>(io_);
  const tcp::endpoint endpoint(ip, port_);
  acceptor->open(endpoint.protocol(), error);
  if (!error) acceptor->set_option(Acceptor::reuse_address(true), error);
  if (!error && ip.is_v6()) acceptor->set_option(asio::ip::v6_only(true), error);
  if (!error) acceptor->bind(endpoint, error);
  if (!error) acceptor->listen(Acceptor::max_listen_connections, error);
  if (error) return Error{"cannot listen on " + where + ": " + error.message()};
  port_ = acceptor->local_endpoint().port();  // if it was 0, all addresses share this one
  acceptors_.push_back(std::move(acceptor));
  return {};
}

// both lists keep their callbacks for life; the inbox outlives us and then discards everything
void Server::Core::watch() {
  channels_.watch([this, inbox = inbox_](const std::shared_ptr<memory::Channel>& channel) {
    inbox->post([this, channel] { hub_.add_channel(channel, derive_); });
  });
  parameters_.listen([this, inbox = inbox_](const std::vector<std::string>& names) {
    inbox->post([this, names] {
      for (const std::string& name : names) hub_.parameter_changed(name);
    });
  });
}

void Server::Core::accept(Acceptor& acceptor) {
  acceptor.async_accept(io_.get_executor(), [this, &acceptor](error_code error, Socket socket) {
    if (error == asio::error::operation_aborted || stop_deadline_ns_ != 0) return;
    if (error) {
      static Throttle throttle;
      throttle.report(Level::warning, "net", "cannot take a connection: " + error.message());
      if (is_out_of_descriptors(error.value()) && !make_room()) turn_away(acceptor);
      return tired_acceptors_.push_back(&acceptor);
    }
    if (const Result<void> admitted = attempt("taking a connection", [&] { admit(std::move(socket)); }); !admitted)
      io_failures_.report(Level::error, "net", admitted.error());
    accept(acceptor);
  });
}

/// Ends the connection that waits longest without a request. Returns whether there is one.
bool Server::Core::make_room() {
  std::shared_ptr<HttpConnection> oldest;
  for (const auto& connection : context_.http)
    if (connection->waits_for_request() && (!oldest || connection->made_ns() < oldest->made_ns())) oldest = connection;
  if (oldest) oldest->close();
  return oldest != nullptr;
}

/// Accepts one client instead of the spare file descriptor, and answers with 503 whatever it asks.
void Server::Core::turn_away(Acceptor& acceptor) {
  if (!spare_) return;
  spare_.reset();
  turned_away_ = FileDescriptor(::accept4(acceptor.native_handle(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (!turned_away_ || wireless_.carries(turned_away_.get())) return;
  const HttpResponse refusal = error_response(
      503, "no file descriptor is left for one more client: end other clients, or raise the limit of open files");
  const std::string bytes = response_head(refusal, false) + std::get<std::string>(refusal.body);
  ::send(turned_away_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  ::shutdown(turned_away_.get(), SHUT_WR);
}

/// Closes the refused connection. Its request is read first: otherwise the kernel would discard the answer.
void Server::Core::take_back_spare() {
  if (spare_) return;
  char request[4096];
  while (turned_away_ && ::recv(turned_away_.get(), request, sizeof request, MSG_DONTWAIT) > 0) {
  }
  turned_away_.reset();
  spare_ = spare_descriptor();
}

void Server::Core::admit(Socket socket) {
  error_code error;
  const auto remote = socket.remote_endpoint(error);
  if (error) return;                                                    // the client has gone already
  if (wireless_.carries(socket.native_handle())) return reset(socket);  // it connected just before the game
  if (context_.http.size() >= options_.max_http_connections && !make_room()) return;
  auto connection = std::make_shared<HttpConnection>(std::move(socket),
                                                     Remote{remote.address().to_string(), remote.port()}, context_);
  context_.http.insert(connection);
  connection->start();
}

void Server::Core::tick() {
  const std::uint64_t now = monotonic_ns();
  if (const Result<void> beaten = attempt("the server's tick", [&] { beat(now); }); !beaten)
    io_failures_.report(Level::error, "net", beaten.error());
  for (Acceptor* acceptor : std::exchange(tired_acceptors_, {})) accept(*acceptor);
  if (stop_deadline_ns_ != 0 && (now >= stop_deadline_ns_ || context_.web_sockets.empty())) return finish_stop();

  timer_.expires_after(stop_deadline_ns_ == 0 ? kTick : kTick / 10);
  timer_.async_wait([this](error_code error) {
    if (!error) tick();
  });
}

/// Does the work of a tick at `now` [monotonic].
void Server::Core::beat(std::uint64_t now) {
  follow_match();
  hub_.send_time();
  if (now >= next_second_ns_) {
    next_second_ns_ = now + kSecond;
    if (match_mode_) keep_silence(true);  // an interface may be new
    hub_.every_second(now);
    const std::lock_guard guard(statistics_lock_);
    statistics_ = hub_.statistics();
  }
  // copies: a connection that times out leaves the set
  for (const auto& connection : std::vector(context_.http.begin(), context_.http.end()))
    connection->check_deadline(now);
  for (const auto& connection : std::vector(context_.web_sockets.begin(), context_.web_sockets.end()))
    connection->check_deadline(now);
  flush_all();
  take_back_spare();
}

void Server::Core::follow_match() {
  const bool match_mode = backend_.match_mode();
  if (match_mode == match_mode_) return;
  match_mode_ = match_mode;
  hub_.set_match_mode(match_mode);
  keep_silence(match_mode);
}

// At a listening socket the kernel drops packets from a wireless interface before it answers them.
// An open connection ends with one packet. Later packets of its client get no answer either.
void Server::Core::keep_silence(bool silent) {
  wireless_ = silent ? Wireless(options_.wireless) : Wireless();
  for (const auto& acceptor : acceptors_)
    if (const auto set = wireless_.silence(acceptor->native_handle()); !set) {
      static Throttle throttle;
      throttle.report(Level::error, "net", set.error());
    }
  for (const auto& connection : std::vector(context_.http.begin(), context_.http.end()))
    if (wireless_.carries(connection->socket().native_handle())) reset(connection->socket()), connection->close();
  for (const auto& connection : std::vector(context_.web_sockets.begin(), context_.web_sockets.end()))
    if (wireless_.carries(connection->socket().native_handle())) reset(connection->socket()), connection->close();
}

void Server::Core::drain() {
  inbox_->take(contents_);
  for (const Inbox::Task& task : contents_.tasks)
    if (const Result<void> done = attempt("a task of the server", task); !done)
      io_failures_.report(Level::error, "net", done.error());
  for (const Inbox::Item& item : contents_.items)
    if (const Result<void> delivered = attempt("delivering a message", [&] { hub_.deliver(item); }); !delivered)
      io_failures_.report(Level::error, "net", delivered.error());
  contents_.items.clear();  // versions are not held longer than needed
  flush_all();
}

void Server::Core::flush_all() {
  for (const auto& connection : context_.web_sockets) connection->flush();
}

void Server::Core::stop() {
  if (thread_.joinable()) {
    asio::post(io_, [this] { begin_stop(); });
    thread_.join();
  }
  inbox_->close();  // loggers that wait for room go on
  streams_.finish();
  for (Worker* worker : workers()) {
    worker->forget();
    worker->finish();
  }
}

void Server::Core::begin_stop() {
  stop_deadline_ns_ = monotonic_ns() + options_.stop_timeout_ns;
  error_code ignored;
  for (const auto& acceptor : acceptors_) acceptor->close(ignored);
  for (const auto& connection : std::vector(context_.http.begin(), context_.http.end())) connection->close();
  for (const auto& connection : context_.web_sockets) connection->go_away();
  timer_.cancel();
  tick();
}

void Server::Core::finish_stop() {
  for (const auto& connection : std::vector(context_.web_sockets.begin(), context_.web_sockets.end()))
    connection->close();
  io_.stop();
}

Server::Server(ServerOptions options, memory::Channels& channels, Derive derive, Streams& streams, const Clock& clock,
               Parameters& parameters, const Services& services, Backend& backend)
    : core_(std::make_shared<Core>(std::move(options), channels, std::move(derive), streams, clock, parameters,
                                   services, backend)) {}

Server::~Server() { stop(); }

Result<void> Server::start() { return core_->start(); }
void Server::stop() { core_->stop(); }
std::uint16_t Server::port() const { return core_->port(); }
ServerStatistics Server::statistics() const { return core_->statistics(); }
void Server::set_metadata(const std::string& key, const std::string& value) { core_->set_metadata(key, value); }
void Server::restart_time() { core_->restart_time(); }

}  // namespace robot::net
