#include "sim/app/game_file.h"

#include <algorithm>

#include "robot/logging/sessions/session.h"
#include "robot/memory/schema.h"
#include "sim/match/pace.h"

namespace sim::app {

namespace pb = foresight;
using robot::Error;
using robot::Result;
using robot::agent::to_proto;
using robot::memory::ChannelInfo;
using robot::memory::Delivery;

namespace {

// channels of one robot, in their order in the file; the truth comes before all robots
enum Object : std::size_t { ball, pose, team, game, motion_command, motion_status, decision, kObjects };

constexpr Tick kSecond = 30;

template <class Message>
ChannelInfo channel(std::string topic, Delivery delivery) {
  return {.topic = std::move(topic), .schema = robot::memory::schema_of(*Message::descriptor()), .delivery = delivery};
}

std::vector<ChannelInfo> channels_of(const Params& params, const robot::agent::TeamNumbers& teams) {
  std::vector<ChannelInfo> channels = {channel<pb::GroundTruth>("/truth/world", Delivery::latest)};
  for_each_robot(params.rules.players, [&](int robot) {
    const std::string name = "/" + robot_name(teams, robot) + "/";
    channels.push_back(channel<pb::Ball>(name + "ball", Delivery::latest));
    channels.push_back(channel<pb::Pose>(name + "pose", Delivery::latest));
    channels.push_back(channel<pb::Team>(name + "team", Delivery::latest));
    channels.push_back(channel<pb::GameState>(name + "game", Delivery::reliable));
    channels.push_back(channel<pb::MotionCommand>(name + "motion_command", Delivery::fifo));
    channels.push_back(channel<pb::MotionStatus>(name + "motion_status", Delivery::fifo));
    channels.push_back(channel<pb::DecisionTrace>(name + "decision", Delivery::fifo));
  });
  return channels;
}

/// The channel of a robot's object.
std::size_t channel_of(const World& world, int robot, Object object) {
  const int number = side_of(robot) == Side::home ? robot : robot - kMaxPlayers + world.players;
  return 1 + static_cast<std::size_t>(number) * kObjects + object;
}

robot::logging::MetadataByName metadata_of(const Params& params, const robot::agent::TeamNumbers& teams,
                                           std::uint64_t seed) {
  auto metadata = robot::logging::metadata_of({.name = "simulated game",
                                               .robot = robot_name(teams, 0),
                                               .team = static_cast<int>(teams.home),
                                               .player = 1,
                                               .build = "foresight-sim " FORESIGHT_VERSION,
                                               .profile = "sim",
                                               .start_ns = kGameEpochNs});
  metadata["foresight.game"] = {{"seed", std::to_string(seed)},
                                {"home", params.teams[0].behaviour->name()},
                                {"away", params.teams[1].behaviour->name()},
                                {"home_models", params.teams[0].models.name},
                                {"away_models", params.teams[1].models.name}};
  return metadata;
}

/// What is left of it when nothing happens.
pb::GameState without_clocks(pb::GameState told) {
  told.clear_received_ns();
  told.clear_seconds_remaining();
  for (pb::TeamState* team : {told.mutable_own(), told.mutable_opponent()}) {
    team->clear_message_budget();
    for (pb::PlayerState& player : *team->mutable_players()) player.clear_seconds_till_unpenalised();
  }
  return told;
}

}  // namespace

Result<GameFile> GameFile::create(const std::filesystem::path& path, const Params& params,
                                  const robot::agent::TeamNumbers& teams, std::uint64_t seed) {
  const std::vector<ChannelInfo> channels = channels_of(params, teams);
  Result<McapFile> mcap = McapFile::create(path, channels, metadata_of(params, teams, seed));
  if (!mcap) return Error{mcap.error()};
  GameFile file(std::move(*mcap), params, teams);
  file.last_.resize(channels.size());
  std::fill_n(file.last_packet_, kMaxRobots, kNever);
  return file;
}

Result<void> GameFile::add_truth(const State& state) {
  pb::GroundTruth truth;
  to_proto(between_turns(state), teams_, truth);
  return write(0, state.world.tick, truth);
}

Result<void> GameFile::add_minds(const State& state, Tick tick, const agent::Trace* traces) {
  Result<void> written;
  for_each_robot(state.world.players, [&](int robot) {
    if (written) written = add_mind(state, robot, tick, traces[robot]);
  });
  return written;
}

Result<void> GameFile::add_mind(const State& state, int robot, Tick tick, const agent::Trace& trace) {
  const Robot& self = state.robots[robot];
  const Team& side = params_.teams[static_cast<int>(side_of(robot))];
  const auto at = [&](Object object) { return channel_of(state.world, robot, object); };
  Result<void> written;

  if (pb::Ball message; to_proto(self.beliefs.ball, params_.teams[0].models.ball.deceleration, timeline_, message))
    written = write(at(ball), tick, message);
  if (!written) return written;

  pb::Pose where;
  to_proto(self.beliefs.pose, where);
  if (written = write(at(pose), tick, where); !written) return written;

  pb::Team mates;
  to_proto(self.beliefs, player_of(robot), timeline_, mates);
  if (self.cognition.packet.sent != kNever) mates.set_sent_ns(timeline_.at(self.cognition.packet.sent));
  if (self.cognition.packet.sent != std::exchange(last_packet_[robot], self.cognition.packet.sent)) ++sent_[robot];
  mates.set_messages_sent(sent_[robot]);
  if (written = write_change(at(team), tick, kSecond, mates, mates); !written) return written;

  pb::GameState told;
  to_proto(params_, state, robot, teams_, timeline_, told);
  if (written = write_change(at(game), tick, kSecond / 2, told, without_clocks(told)); !written) return written;

  pb::MotionCommand command;
  to_proto(self.command, side.models.motion, command);
  if (written = write_change(at(motion_command), tick, kNever, command, command); !written) return written;

  pb::MotionStatus status;
  to_proto(state.world.bodies[robot], self.command, side.models.motion, state.world.tick, status);
  if (written = write(at(motion_status), tick, status); !written) return written;

  if (*trace.skill == '\0') return {};
  pb::DecisionTrace decided;
  to_proto(trace, decided);
  return write(at(decision), tick, decided);
}

Result<void> GameFile::write(std::size_t channel, Tick tick, const google::protobuf::Message& message) {
  message.SerializeToString(&bytes_);
  return file_.write(channel, timeline_.at(tick), bytes_);
}

Result<void> GameFile::write_change(std::size_t channel, Tick tick, Tick at_least,
                                    const google::protobuf::Message& message,
                                    const google::protobuf::Message& essence) {
  essence.SerializeToString(&bytes_);
  Last& last = last_[channel];
  if (last.tick != kNever && tick - last.tick < at_least && bytes_ == last.essence) return {};
  last.tick = tick;
  std::swap(last.essence, bytes_);
  return write(channel, tick, message);
}

}  // namespace sim::app
