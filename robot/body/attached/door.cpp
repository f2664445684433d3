#include "robot/body/attached/door.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <utility>

#include "robot/body/attached/providers.h"
#include "robot/core/local_listener.h"
#include "robot/core/thread.h"

namespace robot::body {
namespace {

constexpr std::uint32_t kVersion = 1;  // of the protocol at the door
constexpr int kClearingMs = 100;       // between checks for ended streams and for new objects
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
  if (!listening) return Error{listening.error()};
  FileDescriptor bell(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (!bell) return file_error("door: cannot make an event for", options.path, errno);
  return std::unique_ptr<Door>(
      new Door(std::move(options), clock, channels, board, std::move(*listening), std::move(bell)));
}

Door::Door(DoorOptions options, const SessionClock& clock, memory::Channels& channels, logging::LoggingBoard& board,
           FileDescriptor listening, FileDescriptor bell)
    : options_(std::move(options)),
      clock_(clock),
      channels_(channels),
      board_(board),
      listening_(std::move(listening)),
      bell_(std::move(bell)),
      objects_(options_.robot, options_.own_objects, channels, clock),
      thread_([this] { run(); }) {}

Door::~Door() {
  const std::uint64_t ring = 1;
  [[maybe_unused]] const ssize_t rung = ::write(bell_.get(), &ring, sizeof ring);
  thread_.join();
  for (const Stream& stream : streams_) board_.stop(stream.id);
  ::unlink(options_.path.c_str());
}

void Door::run() {
  become_background_thread("door");
  while (wait()) {
    take_in();
    for (Guest& guest : guests_) hear(guest);
    std::erase_if(guests_, [](const Guest& guest) { return guest.leaves; });
    clear_away();
  }
}

/// Waits for a new connection, a frame, a disconnect or the next check. Returns false when the door closes.
bool Door::wait() {
  std::vector<pollfd> waiting = {{.fd = bell_.get(), .events = POLLIN, .revents = 0},
                                 {.fd = listening_.get(), .events = POLLIN, .revents = 0}};
  for (const Guest& guest : guests_)
    waiting.push_back(
        {.fd = guest.connection->file(), .events = guest.wanted ? short{POLLRDHUP} : short{POLLIN}, .revents = 0});
  for (const Stream& stream : streams_)
    if (stream.reader) waiting.push_back({.fd = stream.reader->file(), .events = POLLRDHUP, .revents = 0});
  const bool something_to_clear = !streams_.empty() || !guests_.empty();
  ::poll(waiting.data(), waiting.size(), something_to_clear ? kClearingMs : -1);
  return (waiting.front().revents & POLLIN) == 0;
}

void Door::take_in() {
  while (true) {
    FileDescriptor socket(::accept4(listening_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!socket) return;
    Guest guest{.connection = std::make_shared<Connection>(std::move(socket)), .wanted = {}};
    const Peer& peer = guest.connection->peer();
    if (peer.user != ::geteuid() && peer.user != kRoot) {
      refuse(guest, "expected a process of user " + std::to_string(::geteuid()) + ", got one of user " +
                        std::to_string(peer.user));
    } else if (guests_.size() + streams_.size() >= kMaxConnections) {
      refuse(guest, "expected at most " + std::to_string(kMaxConnections) + " streams at once, got one more");
    } else {
      // a process that has already disconnected misses this frame, but its messages are still read
      guest.connection->send(logging::welcome_frame({kVersion, clock_.epoch_offset_ns()}));
      guests_.push_back(std::move(guest));
    }
  }
}

/// Reads the first frame of a connection, or serves one that waits for an object.
void Door::hear(Guest& guest) {
  if (guest.wanted) return serve(guest);
  guest.leaves = !guest.connection->receive();
  Result<std::optional<logging::Frame>> frame = guest.connection->next();
  if (!frame) return refuse(guest, frame.error());
  if (!*frame) return;
  if (auto* announced = std::get_if<memory::ChannelInfo>(&**frame)) return write(guest, std::move(*announced));
  const auto* wanted = std::get_if<logging::Wanted>(&**frame);
  if (!wanted) return refuse(guest, "expected an object to be announced or wanted first, got something else");
  Result<std::string> topic = objects_.topic_of(wanted->topic);
  if (!topic) return refuse(guest, topic.error());
  guest.wanted = std::move(*topic);
  serve(guest);
}

void Door::write(Guest& guest, memory::ChannelInfo announced) {
  const Result<std::shared_ptr<memory::Channel>> channel = objects_.channel_of(std::move(announced));
  if (!channel) return refuse(guest, channel.error());
  guest.leaves = true;
  streams_.push_back(
      {.id = board_.start_parser(
           std::make_unique<DoorInProvider>(guest.connection, (*channel)->info(), clock_.epoch_offset_ns(), turns_),
           {.destination =
                [channel](const memory::ChannelInfo&) { return Result<std::shared_ptr<memory::Channel>>(*channel); },
            .pace = nullptr}),
       .reader = nullptr});
}

/// Starts to send the wanted object as soon as its channel exists.
void Door::serve(Guest& guest) {
  guest.leaves = guest.connection->gone();
  const std::shared_ptr<memory::Channel> channel = channels_.find(*guest.wanted);
  if (!channel || guest.leaves) return;
  guest.leaves = true;
  streams_.push_back(
      {.id = board_.start_logger(channel, std::make_unique<DoorOutProvider>(guest.connection, clock_.epoch_offset_ns()),
                                 kQueueBytes),
       .reader = guest.connection});
}

void Door::refuse(Guest& guest, const std::string& sentence) {
  guest.connection->send(logging::refused_frame({sentence}));
  guest.connection->end();
  guest.leaves = true;
  refusals_.report(Level::error, "door", sentence);
}

/// Removes the streams whose process has disconnected.
void Door::clear_away() {
  std::erase_if(streams_, [this](const Stream& stream) {
    const bool ended = stream.reader ? stream.reader->gone() : board_.status(stream.id).ended;
    if (ended) board_.stop(stream.id);
    return ended;
  });
}

}  // namespace robot::body
