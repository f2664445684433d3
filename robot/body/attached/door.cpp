#include "robot/body/attached/door.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "robot/body/attached/providers.h"
#include "robot/core/attempt.h"
#include "robot/core/local_listener.h"
#include "robot/core/thread.h"

namespace robot::body {
namespace {

constexpr std::uint32_t kVersion = 1;  // of the protocol at the door
constexpr int kClearingMs = 100;       // between checks for ended streams, new objects and free file descriptors
constexpr uid_t kRoot = 0;             // root has access to everything

}  // namespace

std::filesystem::path default_door() {
  if (const char* path = std::getenv("FORESIGHT_DOOR"); path && *path) return path;
  return "/dev/shm/foresight-" + std::to_string(::geteuid()) + ".door";
}

Result<std::unique_ptr<Door>> Door::open(DoorOptions options, const SessionClock& clock, memory::Channels& channels,
                                         logging::LoggingBoard& board) {
  // after a restart all streams of all processes connect at once
  Result<FileDescriptor> listening =
      listen_locally(options.path, {.who = "door",
                                    .another = "another runtime does; end it, or choose another --door",
                                    .type = SOCK_STREAM,
                                    .backlog = kMaxConnections});
  if (!listening) return listening.failure();
  FileDescriptor bell(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (!bell) return file_error("door: cannot make an event for", options.path, errno);
  std::unique_ptr<Door> door(
      new Door(std::move(options), clock, channels, board, std::move(*listening), std::move(bell)));
  if (Result<void> started = start_thread(door->thread_, "door", [door = door.get()] { door->run(); }); !started)
    return started.failure();
  return door;
}

Door::Door(DoorOptions options, const SessionClock& clock, memory::Channels& channels, logging::LoggingBoard& board,
           FileDescriptor listening, FileDescriptor bell)
    : options_(std::move(options)),
      clock_(clock),
      channels_(channels),
      board_(board),
      listening_(std::move(listening)),
      bell_(std::move(bell)),
      objects_(options_.robot, options_.own_objects, options_.written_below, channels, clock),
      spare_(spare_descriptor()) {}

Door::~Door() {
  const std::uint64_t ring = 1;
  [[maybe_unused]] const ssize_t rung = ::write(bell_.get(), &ring, sizeof ring);
  if (thread_.joinable()) thread_.join();
  for (const Stream& stream : streams_) board_.stop(stream.id);
  ::unlink(options_.path.c_str());
}

void Door::run() {
  become_background_thread("door");
  while (wait()) {
    if (const Result<void> taken = attempt("taking a connection", [this] { take_in(); }); !taken)
      refusals_.report(Level::error, "door", taken.error());
    for (PendingConnection& pending : pending_)
      if (const Result<void> heard = attempt("reading a first frame", [&] { hear(pending); }); !heard)
        refuse(pending, heard.error());
    std::erase_if(pending_, [](const PendingConnection& pending) { return pending.done; });
    clear_away();
  }
}

/// Waits for a new connection, a frame, a disconnect or the next check. Returns false when the door closes.
bool Door::wait() {
  const bool rests = monotonic_ns() < rests_until_ns_;
  std::vector<pollfd> waiting = {{.fd = bell_.get(), .events = POLLIN, .revents = 0},
                                 {.fd = rests ? -1 : listening_.get(), .events = POLLIN, .revents = 0}};
  for (const PendingConnection& pending : pending_)
    waiting.push_back(
        {.fd = pending.connection->file(), .events = pending.wanted ? short{POLLRDHUP} : short{POLLIN}, .revents = 0});
  for (const Stream& stream : streams_)
    if (stream.reader) waiting.push_back({.fd = stream.reader->file(), .events = POLLRDHUP, .revents = 0});
  const bool something_to_clear = !streams_.empty() || !pending_.empty() || rests;
  ::poll(waiting.data(), waiting.size(), something_to_clear ? kClearingMs : -1);
  return (waiting.front().revents & POLLIN) == 0;
}

void Door::take_in() {
  if (monotonic_ns() < rests_until_ns_) return;
  if (!spare_) spare_ = spare_descriptor();
  while (true) {
    FileDescriptor socket(::accept4(listening_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!socket && errno == EINTR) continue;
    if (!socket && (errno == EAGAIN || errno == ECONNABORTED)) return;
    if (!socket) return turn_away(errno);
    PendingConnection pending{.connection = std::make_shared<Connection>(std::move(socket)),
                              .late_ns = monotonic_ns() + options_.first_frame_ns,
                              .wanted = {}};
    const Peer& peer = pending.connection->peer();
    if (peer.user != ::geteuid() && peer.user != kRoot) {
      refuse(pending, "expected a process of user " + std::to_string(::geteuid()) + ", got one of user " +
                          std::to_string(peer.user));
    } else if (pending_.size() + streams_.size() >= kMaxConnections) {
      refuse(pending, "expected at most " + std::to_string(kMaxConnections) + " streams at once, got one more");
    } else {
      // a process that has already disconnected misses this frame, but its messages are still read
      pending.connection->send(logging::welcome_frame({kVersion, clock_.epoch_offset_ns()}));
      pending_.push_back(std::move(pending));
    }
  }
}

/// Refuses one process if no file descriptor is left. The others wait while the door rests: the thread would otherwise
/// try again without a pause.
void Door::turn_away(int error_number) {
  rests_until_ns_ = monotonic_ns() + static_cast<std::uint64_t>(kClearingMs) * kMillisecond;
  if (!is_out_of_descriptors(error_number))
    return refusals_.report(Level::error, "door",
                            std::string("cannot take a connection: ") + std::strerror(error_number));
  const std::string sentence =
      "expected a free file descriptor for one more stream, got none: raise the limit of open files (ulimit -n)";
  spare_.reset();
  FileDescriptor socket(::accept4(listening_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (socket) Connection(std::move(socket)).send(logging::refused_frame({sentence}));
  spare_ = spare_descriptor();
  refusals_.report(Level::error, "door", sentence);
}

/// Reads the first frame of a connection, or serves one that waits for an object.
void Door::hear(PendingConnection& pending) {
  if (pending.wanted) return serve(pending);
  pending.done = !pending.connection->receive();
  Result<std::optional<logging::Frame>> frame = pending.connection->next();
  if (!frame) return refuse(pending, frame.error());
  if (!*frame) {
    if (!pending.done && monotonic_ns() >= pending.late_ns)
      refuse(pending, "expected a first frame within " + std::to_string(options_.first_frame_ns / kMillisecond) +
                          " ms, got none");
    return;
  }
  if (auto* announced = std::get_if<memory::ChannelInfo>(&**frame)) return write(pending, std::move(*announced));
  const auto* wanted = std::get_if<logging::Wanted>(&**frame);
  if (!wanted) return refuse(pending, "expected a first frame that announces or wants an object, got another one");
  Result<std::string> topic = objects_.topic_of(wanted->topic);
  if (!topic) return refuse(pending, topic.error());
  pending.wanted = std::move(*topic);
  serve(pending);
}

void Door::write(PendingConnection& pending, memory::ChannelInfo announced) {
  const Result<std::shared_ptr<memory::Channel>> channel = objects_.channel_of(std::move(announced));
  if (!channel) return refuse(pending, channel.error());
  pending.done = true;
  streams_.push_back(
      {.id = board_.start_parser(
           std::make_unique<DoorInProvider>(pending.connection, (*channel)->info(), clock_.epoch_offset_ns(), turns_),
           {.destination =
                [channel](const memory::ChannelInfo&) { return Result<std::shared_ptr<memory::Channel>>(*channel); },
            .pace = nullptr}),
       .reader = nullptr,
       .topic = (*channel)->info().topic});
}

/// Starts to send the wanted object as soon as its channel exists.
void Door::serve(PendingConnection& pending) {
  pending.done = pending.connection->gone();
  const std::shared_ptr<memory::Channel> channel = channels_.find(*pending.wanted);
  if (!channel || pending.done) return;
  pending.done = true;
  streams_.push_back(
      {.id = board_.start_logger(
           channel, std::make_unique<DoorOutProvider>(pending.connection, clock_.epoch_offset_ns()), kQueueBytes),
       .reader = pending.connection,
       .topic = {}});
}

void Door::refuse(PendingConnection& pending, const std::string& sentence) {
  pending.connection->send(logging::refused_frame({sentence}));
  pending.connection->end();
  pending.done = true;
  refusals_.report(Level::error, "door", sentence);
}

/// Removes the streams whose process has disconnected.
void Door::clear_away() {
  std::set<std::string> ended_topics;  // two processes that wrote one topic may end together
  std::erase_if(streams_, [&](const Stream& stream) {
    const bool ended = stream.reader ? stream.reader->gone() : board_.status(stream.id).ended;
    if (!ended) return false;
    board_.stop(stream.id);
    if (!stream.topic.empty()) ended_topics.insert(stream.topic);
    return true;
  });
  if (!options_.on_end) return;
  for (const std::string& topic : ended_topics)
    if (std::ranges::find(streams_, topic, &Stream::topic) == streams_.end()) options_.on_end(topic);
}

}  // namespace robot::body
