#include "robot/logging/sessions/recorder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <utility>

#include "robot/core/files.h"
#include "robot/core/report.h"
#include "robot/logging/sessions/abandonable.h"
#include "robot/logging/sessions/session_counter.h"
#include "robot/logging/sessions/stream_name.h"
#include "robot/logging/streams/file_provider.h"

namespace robot::logging {
namespace {

/// The recording time for which a new session makes room: a half with its breaks.
constexpr double kMinutesWanted = 15;

/// Writes session.json anew. A person may have marked the session as kept meanwhile, which stays.
Result<void> write_info(const std::filesystem::path& folder, SessionInfo info) {
  if (const Result<Session> session = read_session(folder)) info.kept = session->info.kept;
  return store_file(folder / "session.json", to_json(info));
}

/// Returns the number of the newest version of `channel`, or 0 without one.
std::uint64_t newest_number(const memory::Channel& channel) {
  const memory::VersionPtr newest = channel.newest();
  return newest ? newest->sequence() : 0;
}

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
    : channels_(channels),
      board_(board),
      store_(store),
      clock_(clock),
      origin_(std::move(origin)),
      rules_(origin_.info.rules) {
  // objects that appear during a session join it; while it cannot begin, their versions are counted
  watcher_ = channels_.watch([this](const std::shared_ptr<memory::Channel>& channel) {
    const std::lock_guard guard(lock_);
    if (folder_) add(channel);
    if (wish_ && !folder_ && wants(*channel)) until_.try_emplace(channel->info().topic, 0);
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

Result<Recorder::Wish> Recorder::accept(std::string_view name, std::string_view profile_name,
                                        std::vector<std::string> only) const {
  const Result<Profile> profile = profile_named(profile_name);
  if (!profile) return profile.failure();
  if (const Result<void> usable = check_session_name(name); !usable) return usable.failure();
  if (folder_) return Error{"recording: the session " + session_ + " is being recorded already"};
  if (wish_) return Error{"recording: a session is wanted already; " + wish_->problem};
  return Wish{.name = std::string(name), .profile = *profile, .problem = "", .only = std::move(only)};
}

void Recorder::take(Wish wish) {
  const std::lock_guard guard(lock_);
  ++request_;
  dropped_ = 0;
  loss_.clear();
  until_.clear();
  session_.clear();
  last_ = {};
  profile_name_ = wish.profile.name;
  shown_ = {.request = request_, .profile = profile_name_};
  wish_ = std::move(wish);
}

std::vector<std::string> Recorder::object_names() const {
  std::vector<std::string> names;
  for (const auto& channel : channels_.all()) names.emplace_back(memory::object_name(channel->info().topic).object);
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

Result<std::string> Recorder::start(std::string_view name, std::string_view profile_name,
                                    std::vector<std::string> only) {
  const std::lock_guard working(work_);
  Result<Wish> wish = accept(name, profile_name, std::move(only));
  if (!wish) return wish.failure();
  take(std::move(*wish));
  if (const Result<void> begun = begin(); !begun) {
    const std::lock_guard guard(lock_);
    shown_.reset();
    last_ = {.request = request_, .profile = profile_name_};
    wish_.reset();
    return begun.failure("recording");
  }
  return session_;
}

Result<std::uint64_t> Recorder::want(std::string_view name, std::string_view profile_name,
                                     std::vector<std::string> only) {
  const std::lock_guard working(work_);
  Result<Wish> wish = accept(name, profile_name, std::move(only));
  if (!wish) return wish.failure();
  take(std::move(*wish));
  try_to_begin();
  const std::lock_guard guard(lock_);
  if (!folder_)
    for (const auto& channel : channels_.all())
      if (wants(*channel)) until_[channel->info().topic] = newest_number(*channel);
  return request_;
}

void Recorder::know_rules(const std::string& rules) {
  const std::lock_guard guard(lock_);
  if (!rules_.empty()) return;
  rules_ = rules;
  if (!folder_) return;
  info_.rules = rules;
  has_news_ = true;
}

/// Writes facts about the present session that were learnt after its begin. If the disk does not take them, the end of the
/// session has them.
void Recorder::write_news() {
  std::unique_lock guard(lock_);
  if (!std::exchange(has_news_, false) || !folder_) return;
  SessionInfo info = info_;
  const std::filesystem::path folder = folder_->path();
  guard.unlock();
  (void)write_info(folder, std::move(info));
}

void Recorder::tend() {
  const std::lock_guard working(work_);
  write_ends();
  write_news();
  if (!wish_) return;
  if (folder_ && is_whole()) return;
  if (folder_) (void)end();
  try_to_begin();
}

void Recorder::try_to_begin() {
  const Result<void> begun = begin();
  const std::string problem = begun ? "" : "the recording begins when the disk permits it; " + begun.error();
  if (!problem.empty() && problem != wish_->problem) report(Level::warning, "logging", problem);
  const std::lock_guard guard(lock_);
  wish_->problem = problem;
  shown_.reset();
}

/// Returns how far the clock is behind the time of day [ns], or 0 for less than a second.
std::int64_t Recorder::behind_ns() const {
  const std::int64_t behind_ns = origin_.behind_ns ? origin_.behind_ns() : 0;
  return std::abs(behind_ns) < static_cast<std::int64_t>(kSecond) ? 0 : behind_ns;
}

/// Begins the wanted session.
Result<void> Recorder::begin() {
  const Wish& wish = *wish_;
  const Room room = room_for(wish.profile);
  if (room.minutes < 1) return Error{room.sentence};
  (void)store_.make_room(static_cast<std::uint64_t>(kMinutesWanted * wish.profile.mb_per_minute * 1e6),
                         clock_.now_ns());
  SessionInfo info = origin_.info;
  info.start_ns = clock_.now_ns();
  info.behind_ns = behind_ns();
  Result<OwnedFolder> folder =
      OwnedFolder::make(store_.folder(), session_folder_name(time_of_day_ns(info), wish.name, wish.profile.name));
  if (!folder) return folder.failure();
  if (Result<void> described = describe(wish, *folder, info); !described) {
    std::error_code ignored;
    std::filesystem::remove(folder->path() / "session.json", ignored);
    folder->discard();
    return described;
  }

  report(Level::info, "logging", "recording the session " + folder->name());
  const std::lock_guard guard(lock_);
  info_ = std::move(info);
  info_.rules = rules_;
  advice_ = room.minutes < kMinutesWanted ? room.sentence : "";
  gone_ = std::make_shared<std::atomic<bool>>(false);
  folder_.emplace(std::move(*folder));
  session_ = folder_->name();
  for (const auto& channel : channels_.all()) add(channel);
  until_.clear();
  shown_.reset();
  return {};
}

/// Sets the facts about the new session and writes them into its folder.
Result<void> Recorder::describe(const Wish& wish, const OwnedFolder& folder, SessionInfo& info) const {
  info.name = wish.name;
  info.profile = wish.profile.name;
  info.only = wish.only;
  {
    const std::lock_guard guard(lock_);
    info.rules = rules_;
  }
  info.number = next_session_number(store_.folder(), store_.greatest_number());
  info.boot = boot_id();
  return store_file(folder.path() / "session.json", to_json(info));
}

void Recorder::add(const std::shared_ptr<memory::Channel>& channel) {
  const memory::ChannelInfo& info = channel->info();
  if (!wants(*channel)) return;
  const bool image = info.schema.name == kImageSchema;
  // a channel that appears while a session begins is added twice: ignore the second time
  if (std::ranges::find(streams_, info.topic, &Stream::topic) != streams_.end()) return;
  const std::string file = stream_file_name(info.topic);
  std::unique_ptr<OutProvider> provider = std::make_unique<FileOutProvider>(
      folder_->path() / file, McapOptions{.first_channel_id = static_cast<std::uint16_t>(streams_.size() + 1),
                                          .metadata = metadata_of(info_),
                                          .compression = image ? Compression::none : origin_.compression,
                                          // together one second, the most that the death of the process costs
                                          .chunk_time_ns = kSecond - FileOutProvider::kPatience.time_ns});
  if (image && !wish_->profile.raw_images) provider = thin_images(wish_->profile, std::move(provider));
  provider = unless_gone(gone_, std::move(provider));
  Stream stream{
      .id = board_.start_logger(channel, std::move(provider)), .topic = info.topic, .file = file, .until = {}};
  if (const auto until = until_.find(info.topic); until != until_.end() && wants_all(*channel))
    stream.until = until->second;
  streams_.push_back(std::move(stream));
}

/// Returns whether the session has `channel` at all.
bool Recorder::wants(const memory::Channel& channel) const {
  const std::vector<std::string>& only = wish_->only;
  return only.empty() || std::ranges::find(only, memory::object_name(channel.info().topic).object) != only.end();
}

/// Returns whether the profile wants every version of `channel`.
bool Recorder::wants_all(const memory::Channel& channel) const {
  return channel.info().schema.name != kImageSchema || wish_->profile.raw_images;
}

/// Returns how many versions no session will have: if one begins now, with the newest versions, or if none begins any more.
/// Leaves out channels of which the profile does not want every version.
std::uint64_t Recorder::missed(bool begins) const {
  std::uint64_t missed = 0;
  for (const auto& [topic, until] : until_) {
    const auto channel = channels_.find(topic);
    if (!channel || !wants_all(*channel)) continue;
    const std::uint64_t newest = newest_number(*channel);
    if (newest > until) missed += newest - until - (begins ? 1 : 0);
  }
  return missed;
}

/// Returns how many versions the session of `stream` began too late for. The stream itself knows where it began: the
/// channel's writer does not wait for the recorder.
std::uint64_t Recorder::missed_before(const Stream& stream, const StreamStatus& carried) {
  if (!stream.until || carried.first <= *stream.until + 1) return 0;
  return carried.first - *stream.until - 1;
}

/// Reports whether the file that holds the messages of `stream` was deleted or replaced.
bool Recorder::is_lost(const OwnedFolder& folder, Stream& stream, const StreamStatus& carried) {
  if (carried.messages == 0) return false;  // a file appears before its first message
  const std::uint64_t identity = folder.identity_of(stream.file);
  if (stream.identity == 0) stream.identity = identity;
  return identity == 0 || identity != stream.identity;
}

/// Reports whether all files of the session are in its folder, and the folder in its place.
bool Recorder::is_whole() {
  const std::lock_guard guard(lock_);
  return folder_->in_place() && std::ranges::none_of(streams_, [&](Stream& stream) {
           return is_lost(*folder_, stream, board_.status(stream.id));
         });
}

/// Closes the streams of the session, counts the messages in deleted files as dropped, and says so. Returns its account.
/// Until the next change the status is the one before.
SessionAccount Recorder::end() {
  std::unique_lock guard(lock_);
  shown_ = status_now();
  std::vector<Stream> streams = std::exchange(streams_, {});
  OwnedFolder folder = *std::move(folder_);
  folder_.reset();
  guard.unlock();

  std::uint64_t deleted = 0;
  std::string problem;
  SessionAccount account;
  std::map<std::string, std::uint64_t> until;
  const bool in_place = folder.in_place();
  *gone_ = !in_place;
  for (Stream& stream : streams) {
    const StreamStatus last = board_.stop(stream.id);
    until[stream.topic] = std::max(last.newest, stream.until.value_or(0));
    (is_lost(folder, stream, last) ? deleted : account.messages) += last.messages;
    account.dropped += last.dropped + missed_before(stream, last);
    if (last.dropped > 0 && !last.problem.empty()) problem = "; " + last.problem;
  }
  account.dropped += deleted;
  const std::uint64_t lost = account.dropped - deleted;
  std::string sentence;
  if (lost > 0) {
    sentence = "session " + folder.name() + ": messages lost: " + std::to_string(lost) + " of " +
               std::to_string(account.messages + account.dropped) + problem;
    report(Level::warning, "logging", sentence);
  }
  if (!in_place || deleted > 0) {
    sentence =
        "session " + folder.name() +
        ": its files were deleted, replaced or moved while it was recorded; messages lost: " + std::to_string(deleted);
    report(Level::error, "logging", sentence);
  }

  guard.lock();
  until_.merge(until);
  dropped_ += account.dropped;
  if (!sentence.empty()) loss_ = std::move(sentence);
  SessionInfo info = std::move(info_);
  guard.unlock();

  info.behind_ns = behind_ns();
  info.complete = true;
  info.account = account;
  folder.release();
  ends_.push_back({.folder = std::move(folder), .info = std::move(info)});
  write_ends();
  return account;
}

/// Writes session.json of the sessions that have ended, also into moved folders. Those that the disk does not take stay in
/// the list.
void Recorder::write_ends() {
  std::erase_if(ends_, [](End& end) {
    const std::filesystem::path folder = end.folder.present_path();
    if (folder.empty()) return true;
    const Result<void> written = write_info(folder, end.info);
    if (!written && !std::exchange(end.reported, true))
      report(Level::warning, "logging",
             "session " + end.folder.name() + ": its end is written when the disk permits it; " + written.error());
    return bool(written);
  });
}

Result<std::string> Recorder::stop() {
  const std::lock_guard working(work_);
  if (!wish_) return Error{"recording: there is none to stop"};
  std::uint64_t messages = 0;
  if (folder_) {
    report(Level::info, "logging", "the session " + session_ + " ends");
    messages = end().messages;
  } else {
    give_up();
  }
  const std::lock_guard guard(lock_);
  last_ = {.request = request_,
           .session = session_,
           .profile = profile_name_,
           .messages = messages,
           .dropped = dropped_,
           .message = loss_};
  wish_.reset();
  shown_.reset();
  return session_;
}

/// Counts the versions for which no session could begin, and says so.
void Recorder::give_up() {
  const std::lock_guard guard(lock_);
  const std::uint64_t missing = missed(false);
  if (missing == 0) return;
  dropped_ += missing;
  loss_ = "no session could begin before the end of the recording; messages lost: " + std::to_string(missing);
  report(Level::warning, "logging", loss_);
}

RecordingStatus Recorder::status() const {
  const std::lock_guard guard(lock_);
  if (shown_) return *shown_;
  return wish_ ? status_now() : last_;
}

/// Returns the status while a session is wanted.
RecordingStatus Recorder::status_now() const {
  RecordingStatus status{.request = request_, .session = session_, .profile = profile_name_};
  status.mb_per_minute = wish_->profile.mb_per_minute;
  status.dropped = dropped_;
  status.state = folder_ ? RecordingStatus::State::recording : RecordingStatus::State::disk_full;
  status.message = !folder_ ? wish_->problem : loss_.empty() ? advice_ : loss_;
  if (!folder_) status.dropped += missed(true);
  std::vector<StreamStatus> carried;
  std::uint64_t delivered_ns = 0;
  for (const Stream& stream : streams_) {
    const StreamStatus& one = carried.emplace_back(board_.status(stream.id));
    status.messages += one.messages;
    status.waiting += one.waiting;
    status.dropped += one.dropped + missed_before(stream, one);
    delivered_ns = std::max(delivered_ns, one.delivered_ns);
    std::error_code failed;
    const std::uintmax_t size = std::filesystem::file_size(folder_->path() / stream.file, failed);
    if (!failed) status.size_bytes += size;
  }
  for (const StreamStatus& one : carried) {
    if (!one.failing || delivered_ns > one.failed_ns + kMendedNs) continue;
    status.state = RecordingStatus::State::disk_full;
    status.message = one.problem;
  }
  return status;
}

}  // namespace robot::logging
