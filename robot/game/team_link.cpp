#include "robot/game/team_link.h"

#include <mutex>
#include <random>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/thread.h"

namespace robot::game {
namespace {

constexpr std::uint64_t kTickNs = kSecond / 10;
constexpr std::uint64_t kAnswerNs = kSecond;        // the GameController wants 0.5 .. 2 Hz
constexpr std::uint64_t kDeafNs = 5 * kSecond;      // a GameController that is silent for longer gets no answer
constexpr std::uint64_t kTimeOutNs = 15 * kSecond;  // twice the message interval of a team of seven on its budget

bool penalised(const pb::GameState& game, std::uint32_t player) {
  const auto& players = game.own().players();
  return player <= static_cast<std::uint32_t>(players.size()) && players[static_cast<int>(player) - 1].penalised();
}

}  // namespace

Result<std::unique_ptr<TeamLink>> TeamLink::open(TeamLinkOptions options, memory::Memory& memory, const Clock& clock,
                                                 std::function<std::optional<Endpoint>()> game_controller) {
  if (!options.port) options.port = static_cast<std::uint16_t>(kTeamPortBase + options.team);
  Result<UdpSocket> socket = UdpSocket::open(options.address, *options.port);
  if (!socket) return socket.failure("team messages");
  std::unique_ptr<TeamLink> made(new TeamLink(std::move(*socket), options, memory, clock, std::move(game_controller)));
  if (Result<void> started = start_thread(made->thread_, "team", [link = made.get()] { link->run(); }); !started)
    return started.failure();
  return made;
}

TeamLink::TeamLink(UdpSocket socket, TeamLinkOptions options, memory::Memory& memory, const Clock& clock,
                   std::function<std::optional<Endpoint>()> game_controller)
    : socket_(std::move(socket)),
      options_(options),
      memory_(memory),
      clock_(clock),
      game_controller_(std::move(game_controller)),
      sender_(std::random_device{}()) {}

TeamLink::~TeamLink() {
  socket_.wake();
  if (thread_.joinable()) thread_.join();
}

std::string TeamLink::stopped() const {
  const std::lock_guard guard(lock_);
  return stopped_;
}

void TeamLink::run() {
  name_thread("team");
  std::uint64_t tick_ns = monotonic_ns();
  while (!socket_.woken()) {
    const Result<void> served = attempt("a team message", [&] {
      if (const std::optional<Datagram> datagram = socket_.receive(tick_ns)) take(*datagram);
      if (monotonic_ns() < tick_ns) return;
      tick_ns = monotonic_ns() + kTickNs;
      follow_game();
      answer();
      tell_teammates();
      if (monotonic_ns() >= last_written_ns_ + kSecond) write_team();
    });
    if (!served) throttle_.report(Level::error, "team", served.error());
  }
}

void TeamLink::take(const Datagram& datagram) {
  const std::uint64_t now_ns = clock_.now_ns();
  const Result<TeamMessage> message = parse_team_message(datagram.bytes, now_ns);
  if (message && message->sender == sender_) return;  // our own broadcast comes back to us
  guard_.count();
  if (message && message->team == options_.team) {
    if (message->player == options_.player) guard_.hear_double(text_of(datagram.from));
    return take_message(*message, now_ns);
  }
  ++messages_wrong_;
  // another program's message; if it comes from this robot, its sender is the team's own framework
  if (is_own_address(datagram.from.address)) guard_.hear_double("another program of this robot");
}

void TeamLink::take_message(const TeamMessage& message, std::uint64_t now_ns) {
  if (message.player == options_.player) return;
  pb::Teammate& mate = teammates_[message.player];
  mate.set_player(message.player);
  mate.set_received_ns(now_ns);
  mate.set_fallen(message.fallen);
  mate.clear_pose();
  mate.clear_ball();
  mate.clear_strategy();
  mate.clear_epoch();
  if (message.strategy != kNoStrategy) mate.set_strategy(message.strategy), mate.set_epoch(message.epoch);
  if (message.pose) *mate.mutable_pose() = *message.pose;
  if (message.ball) *mate.mutable_ball() = *message.ball;
  write_team();
}

void TeamLink::follow_game() {
  const auto game = memory_.game.read();
  if (game && game->sequence() != game_sequence_) {
    game_sequence_ = game->sequence();
    guard_.hear(game->value());
  }
  const std::lock_guard guard(lock_);
  if (stopped_ == guard_.stopped()) return;
  stopped_ = guard_.stopped();
  report(Level::error, "game", stopped_);
}

void TeamLink::answer() {
  const std::uint64_t monotonic = monotonic_ns(), now_ns = clock_.now_ns();
  if (!options_.return_packets || !guard_.stopped().empty() || monotonic < last_answer_ns_ + kAnswerNs) return;
  const auto game = memory_.game.read();
  const std::optional<Endpoint> referee = game_controller_();
  if (!game || !referee || now_ns > (*game)->received_ns() + kDeafNs) return;

  const auto motion = memory_.motion_status.read();
  const auto pose = memory_.pose.read();
  const auto ball = memory_.ball.read();
  const auto packet = return_packet((*game)->packet_version(), {.team = options_.team,
                                                                .player = options_.player,
                                                                .motion = motion ? &motion->value() : nullptr,
                                                                .pose = pose ? &pose->value() : nullptr,
                                                                .ball = ball ? &ball->value() : nullptr,
                                                                .now_ns = now_ns});
  if (!packet) return;
  last_answer_ns_ = monotonic;
  if (const Result<void> sent = socket_.send({referee->address, options_.return_port}, *packet); !sent)
    throttle_.report(Level::warning, "game", sent.error());
}

void TeamLink::tell_teammates() {
  const std::uint64_t monotonic = monotonic_ns(), now_ns = clock_.now_ns();
  if (!options_.team_messages || !guard_.may_send(monotonic, last_message_ns_)) return;
  const auto game = memory_.game.read();
  if (!game || now_ns > (*game)->received_ns() + kDeafNs || penalised(game->value(), options_.player)) return;

  TeamMessage message{.team = options_.team, .player = options_.player, .sender = sender_};
  if (const auto motion = memory_.motion_status.read())
    message.fallen = (*motion)->fall() == pb::MotionStatus::FALL_FALLEN;
  if (const auto pose = memory_.pose.read()) message.pose = pose->value();
  if (const auto ball = memory_.ball.read()) message.ball = ball->value();
  if (const auto strategy = memory_.strategy.read()) {
    if ((*strategy)->chosen()) message.strategy = static_cast<std::uint8_t>((*strategy)->number());
    message.epoch = static_cast<std::uint8_t>((*strategy)->epoch());
  }
  last_message_ns_ = monotonic;
  // counted even if sending fails: the budget counts each message that the GameController receives
  guard_.count();
  if (const Result<void> sent = socket_.send({options_.broadcast, port()}, to_bytes(message, now_ns)); !sent)
    return throttle_.report(Level::warning, "game", sent.error());
  sent_ns_ = now_ns;
  ++messages_sent_;
  write_team();
}

void TeamLink::write_team() {
  const std::uint64_t now_ns = clock_.now_ns();
  const auto game = memory_.game.read();
  auto team = memory_.team.draft();
  for (auto& [player, mate] : teammates_) {
    mate.set_active(now_ns < mate.received_ns() + kTimeOutNs && !(game && penalised(game->value(), player)));
    *team->add_teammates() = mate;
  }
  team->set_sent_ns(sent_ns_);
  team->set_messages_sent(messages_sent_);
  team->set_messages_wrong(messages_wrong_);
  memory_.team.write(std::move(team), now_ns);
  last_written_ns_ = monotonic_ns();
}

}  // namespace robot::game
