// A simulated game as a recording: the truth, and every robot's memory as if it had been there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robot/agent/convert.h"
#include "robot/core/result.h"
#include "sim/app/mcap_file.h"
#include "sim/match/params.h"
#include "sim/match/state.h"

namespace sim::app {

/// Tick 0 of every recorded game, so that the same game gives the same bytes: 2012-06-18 12:00 UTC, the week of the
/// RoboCup that the thesis was written for.
inline constexpr std::uint64_t kGameEpochNs = 1'340'020'800'000'000'000;

/// Per tick: /truth/world, and of each robot ball (once it was seen), pose and motion_status; the decision where it
/// decided; team, game and motion_command where they changed, game and team at least once a second.
class GameFile {
 public:
  /// An Error if the file exists. `params` outlive this; `seed` goes into the file's metadata.
  static robot::Result<GameFile> create(const std::filesystem::path& path, const Params& params,
                                        const robot::agent::TeamNumbers& teams, std::uint64_t seed);

  /// What is so, before the step of this tick.
  robot::Result<void> add_truth(const State& state);

  /// What robots believe and do since that step; `tick` is the one before it. `traces` are by robot, empty where
  /// nothing was decided.
  robot::Result<void> add_minds(const State& state, Tick tick, const agent::Trace* traces);

  robot::Result<void> close() { return file_.close(); }

  std::uint64_t messages() const { return file_.messages(); }
  std::uint64_t size_bytes() const { return file_.size_bytes(); }

 private:
  GameFile(McapFile file, const Params& params, const robot::agent::TeamNumbers& teams)
      : file_(std::move(file)), params_(params), teams_(teams) {}

  robot::Result<void> add_mind(const State& state, int robot, Tick tick, const agent::Trace& trace);
  robot::Result<void> write(std::size_t channel, Tick tick, const google::protobuf::Message& message);
  /// Where `essence` differs from that of the last message, or that is `at_least` ago.
  robot::Result<void> write_change(std::size_t channel, Tick tick, Tick at_least,
                                   const google::protobuf::Message& message, const google::protobuf::Message& essence);

  McapFile file_;
  const Params& params_;
  const robot::agent::TeamNumbers teams_;
  const robot::agent::Timeline timeline_{.epoch_ns = kGameEpochNs};
  std::string bytes_;
  struct Last {
    std::string essence;
    Tick tick = kNever;
  };
  std::vector<Last> last_;               // by channel
  std::uint32_t sent_[kMaxRobots] = {};  // packets
  Tick last_packet_[kMaxRobots];
};

}  // namespace sim::app
