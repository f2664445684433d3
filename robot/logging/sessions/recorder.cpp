#include "robot/logging/sessions/recorder.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "robot/core/files.h"
#include "robot/core/report.h"
#include "robot/logging/streams/file_provider.h"

namespace robot::logging {
namespace {

/// The recording time for which a new session makes room: a half with its breaks.
constexpr double kMinutesWanted = 15;

}  // namespace

std::string_view name(RecordingStatus::State state) {
  switch (state) {
    case RecordingStatus::State::off: return "off";
    case RecordingStatus::State::recording: return "recording";
    case RecordingStatus::State::disk_full: return "disk_full";
  }
  return "?";
}

Recorder::Recorder(memory::Channels& channels, LoggingBoard& board, SessionStore& store, const Clock& clock,
                   Origin origin)
    : channels_(channels), board_(board), store_(store), clock_(clock), origin_(std::move(origin)) {
  // objects that appear during a session join it
  watcher_ = channels_.watch([this](const std::shared_ptr<memory::Channel>& channel) {
    const std::lock_guard guard(lock_);
    if (recording_) add(channel);
  });
}

Recorder::~Recorder() {
  channels_.unwatch(watcher_);
  (void)stop();
}

Recorder::Room Recorder::room_for(const Profile& profile) const {
  const std::uint64_t deletable = store_.deletable_bytes(clock_.now_ns());
  const std::uint64_t staying = store_.size_bytes() - std::min(store_.size_bytes(), deletable);
  const std::uint64_t under_cap = store_.max_bytes() - std::min(store_.max_bytes(), staying);
  const double bytes = static_cast<double>(std::min(store_.disk_free_bytes() + deletable, under_cap));
  Room room{.minutes = bytes / (profile.mb_per_minute * 1e6), .sentence = ""};
  room.sentence = "profile " + std::string(profile.name) + " takes about " +
                  std::to_string(std::lround(profile.mb_per_minute)) + " MB per minute; " +
                  std::to_string(std::lround(std::floor(room.minutes))) + " minutes of it fit";
  return room;
}

Result<std::string> Recorder::start(std::string_view name, std::string_view profile_name) {
  const Result<Profile> profile = profile_named(profile_name);
  if (!profile) return profile.failure();
  const std::lock_guard guard(lock_);
  if (recording_) return Error{"recording: the session " + folder_.filename().string() + " is being recorded already"};
  const Room room = room_for(*profile);
  if (room.minutes < 1) return Error{"recording: " + room.sentence};
  for (const std::string& gone :
       store_.make_room(static_cast<std::uint64_t>(kMinutesWanted * profile->mb_per_minute * 1e6), clock_.now_ns()))
    report(Level::info, "logging", "deleted the session " + gone + " to make room");

  info_ = origin_.info;
  info_.name = name;
  info_.profile = profile->name;
  info_.start_ns = clock_.now_ns();
  folder_ = store_.folder() / session_folder_name(info_.start_ns, name, profile->name);
  for (int again = 2; std::filesystem::exists(folder_); ++again)
    folder_ =
        store_.folder() / (session_folder_name(info_.start_ns, name, profile->name) + "_" + std::to_string(again));
  std::error_code failed;
  std::filesystem::create_directories(folder_, failed);
  if (failed) return Error{"recording: cannot make the folder " + folder_.string() + ": " + failed.message()};
  if (Result<void> written = replace_file(folder_ / "session.json", to_json(info_)); !written)
    return written.failure("recording");

  profile_ = *profile;
  advice_ = room.minutes < kMinutesWanted ? room.sentence : "";
  streams_.clear();
  recording_ = true;
  store_.set_recording(folder_.filename().string());
  for (const auto& channel : channels_.all()) add(channel);
  report(Level::info, "logging", "recording the session " + folder_.filename().string());
  return folder_.filename().string();
}

void Recorder::add(const std::shared_ptr<memory::Channel>& channel) {
  const memory::ChannelInfo& info = channel->info();
  const bool image = info.schema.name == kImageSchema;
  const std::filesystem::path path = folder_ / stream_file_name(info.topic);
  // a channel that appears while a session begins is added twice: ignore the second time
  if (std::ranges::find(streams_, path, &Stream::path) != streams_.end()) return;
  std::unique_ptr<OutProvider> provider = std::make_unique<FileOutProvider>(
      path, McapOptions{.first_channel_id = static_cast<std::uint16_t>(streams_.size() + 1),
                        .metadata = metadata_of(info_),
                        .compression = image ? Compression::none : origin_.compression,
                        // together one second, the most that the death of the process costs
                        .chunk_time_ns = kSecond - FileOutProvider::kPatience.time_ns});
  if (image && !profile_.raw_images) provider = thin_images(profile_, std::move(provider));
  streams_.push_back({board_.start_logger(channel, std::move(provider)), path});
}

Result<std::string> Recorder::stop() {
  const std::lock_guard guard(lock_);
  if (!recording_) return Error{"recording: there is none to stop"};
  report(Level::info, "logging", "the session " + folder_.filename().string() + " ends");
  for (const Stream& stream : streams_) board_.stop(stream.id);
  recording_ = false;
  store_.set_recording("");
  // a person may have marked the session as kept while it was being recorded
  const Result<Session> session = read_session(folder_);
  if (session) info_.kept = session->info.kept;
  info_.complete = true;
  if (Result<void> written = replace_file(folder_ / "session.json", to_json(info_)); !written)
    return written.failure("recording");
  return folder_.filename().string();
}

RecordingStatus Recorder::status() const {
  const std::lock_guard guard(lock_);
  RecordingStatus status{.session = folder_.filename().string(), .profile = std::string(profile_.name)};
  if (!recording_) return status;
  status.state = RecordingStatus::State::recording;
  status.mb_per_minute = profile_.mb_per_minute;
  status.message = advice_;
  for (const Stream& stream : streams_) {
    const StreamStatus carried = board_.status(stream.id);
    status.messages += carried.messages;
    status.dropped += carried.dropped;
    std::error_code failed;
    const std::uintmax_t size = std::filesystem::file_size(stream.path, failed);
    if (!failed) status.size_bytes += size;
    if (!carried.failing) continue;
    status.state = RecordingStatus::State::disk_full;
    status.message = carried.problem;
  }
  return status;
}

}  // namespace robot::logging
