#include "sim/app/game_file.h"

#include <system_error>
#include <utility>

#include "robot/core/byte_sink.h"
#include "robot/core/clock.h"
#include "robot/logging/sessions/session.h"

namespace sim::app {

using robot::Result;
using robot::bridge::SimulatedGame;
using robot::logging::McapWriter;

namespace {

/// The longest chunk [ns] of game time. It is longer than on a robot, because large chunks compress better.
constexpr std::uint64_t kChunkNs = 10 * robot::kSecond;

/// The clock of a recorded game, in which writing takes no time.
class StoppedClock final : public robot::Clock {
 public:
  std::uint64_t now_ns() const override { return kGameEpochNs; }
};
const StoppedClock kStoppedClock;

robot::logging::MetadataByName metadata_of(const SimulatedGame& game, std::uint64_t seed) {
  const auto& teams = game.params().teams;
  auto metadata = robot::logging::metadata_of({.name = "simulated game",
                                               .robot = robot::bridge::robot_name(game.names().teams, 0),
                                               .team = static_cast<int>(game.names().teams.home),
                                               .player = 1,
                                               .build = "foresight-sim " FORESIGHT_VERSION,
                                               .profile = "sim",
                                               .rules = game.names().rules,
                                               .start_ns = kGameEpochNs});
  metadata["foresight.game"] = {{"seed", std::to_string(seed)},
                                {"home", teams[0].behaviour->name()},
                                {"away", teams[1].behaviour->name()},
                                {"home_models", teams[0].models.name},
                                {"away_models", teams[1].models.name}};
  return metadata;
}

}  // namespace

GameFile::GameFile(const SimulatedGame& game)
    : narrator_(std::make_unique<robot::bridge::Narrator>(game, 0, kStoppedClock)) {}

Result<GameFile> GameFile::create(const std::filesystem::path& path, const SimulatedGame& game, std::uint64_t seed) {
  GameFile file(game);
  robot::memory::Channels channels;
  if (const Result<void> listed = file.narrator_->list(channels); !listed) return listed.failure();
  std::vector<robot::memory::ChannelInfo> infos;
  for (std::shared_ptr<robot::memory::Channel>& channel : channels.all()) {
    infos.push_back(channel->info());
    file.channels_.push_back({.channel = std::move(channel)});
  }
  auto sink = robot::FileSink::create(path);
  if (!sink) return sink.failure();
  file.draft_ = std::make_unique<Draft>(path);
  const robot::logging::McapOptions options{.metadata = metadata_of(game, seed),
                                            .library = "foresight-sim " FORESIGHT_VERSION,
                                            .compression = robot::logging::Compression::zstd,
                                            .chunk_time_ns = kChunkNs};
  Result<McapWriter> writer = McapWriter::open(std::move(*sink), infos, options);
  if (!writer) return writer.failure();
  file.file_.emplace(std::move(*writer));
  return file;
}

GameFile::Draft::~Draft() {
  std::error_code ignored;
  if (!complete) std::filesystem::remove(path, ignored);
}

Result<void> GameFile::close() {
  Result<void> closed = file_->close();
  draft_->complete = bool(closed);
  return closed;
}

Result<void> GameFile::add(const SimulatedGame& game) {
  const std::uint64_t now_ns = timeline_.at(game.state().world.tick);
  narrator_->write(game, timeline_);
  narrator_->write_status(game, {}, timeline_);
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const robot::memory::VersionPtr newest = channels_[i].channel->newest();
    if (!newest || newest->sequence() == channels_[i].sequence) continue;
    channels_[i].sequence = newest->sequence();
    const robot::logging::OutMessage message{.sequence = ++channels_[i].messages,
                                             .capture_ns = newest->capture_ns(),
                                             .publish_ns = newest->capture_ns(),
                                             .bytes = newest->bytes()};
    if (Result<void> written = file_->write(i, message, now_ns); !written) return written;
  }
  return {};
}

}  // namespace sim::app
