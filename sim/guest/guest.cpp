#include "sim/guest/guest.h"

#include <filesystem>
#include <sstream>

#include "robot/core/files.h"
#include "sim/agent/trace.h"
#include "sim/guest/library.h"
#include "sim/guest/moment.h"
#include "sim/guest/pipe.h"

namespace sim::guest {
namespace {

constexpr std::string_view kPipe = "pipe:";
constexpr std::size_t kMostBytes = 256 << 20;  // of a library
constexpr std::size_t kMostTreeBytes = 1 << 20;

/// FNV-1a.
void add(std::uint64_t& hash, std::string_view bytes) {
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
}

bool holds_json(const std::string& path) {
  const auto text = robot::read_file(path, kMostTreeBytes);
  if (!text) return false;
  const std::size_t first = text->find_first_not_of(" \t\r\n");
  return first != text->npos && (*text)[first] == '{';
}

bool is_executable(const std::string& path) {
  using std::filesystem::perms;
  std::error_code failed;
  const perms execute = perms::owner_exec | perms::group_exec | perms::others_exec;
  return (std::filesystem::status(path, failed).permissions() & execute) != perms::none;
}

}  // namespace

motion::Command GuestBehaviour::decide(const agent::Surroundings& surroundings, const agent::Game& game,
                                       const agent::Beliefs& beliefs, Tick now, agent::Mind& mind,
                                       agent::Trace* trace) const {
  if (trace) trace->clear(), trace->strategy = trace->skill = name_.c_str();
  // a guest keeps its memory itself, not in the state: only guests change when they decide
  auto& self = const_cast<GuestBehaviour&>(*this);
  if (problem_.empty()) {
    ForesightPlayer& player = self.players_[game.player];
    if (player.player == 0) player = player_of(surroundings, game, seed_ * kMaxPlayers + game.player);
    const bool entered = mind.leaf == agent::kNoLeaf;
    ForesightCommand command = usual_command(mind);
    self.problem_ = self.ask(player, moment_of(game, beliefs, now, entered), command);
    if (problem_.empty()) {
      self.problem_ = problem_of(command, player.kick_count);
      if (problem_.empty()) return command_of(command, surroundings, game, beliefs, now, mind);
    }
    self.problem_ = "behaviour '" + name_ + "': player " + std::to_string(game.player) + ", tick " +
                    std::to_string(now) + ": " + problem_;
  }
  return {};
}

bool is_guest(const std::string& name) { return name.starts_with(kPipe) || name.ends_with(".so"); }

robot::Result<std::shared_ptr<const GuestFactory>> open(const std::string& name) {
  return name.starts_with(kPipe) ? open_pipe(name, name.substr(kPipe.size())) : open_library(name);
}

std::string advice_about(const std::string& name) {
  std::error_code failed;
  if (name.ends_with(".json") || !std::filesystem::is_regular_file(name, failed)) return {};
  const std::string called = "behaviour '" + name + "' ";
  const std::string path = name.find('/') == name.npos ? "./" + name : name;
  if (holds_json(name)) return path == name ? "" : called + "is a file of JSON: use '" + path + "'";
  if (name.ends_with(".py")) return called + "is a program: use 'pipe:python3 " + name + "'";
  if (is_executable(name)) return called + "is a program: use 'pipe:" + path + "'";
  return called + "is a file, but neither JSON nor a shared library (.so) nor a program that may be executed";
}

std::uint64_t content_of(const std::string& name) {
  std::uint64_t hash = 0xcbf29ce484222325;
  add(hash, name);
  std::istringstream words(name.starts_with(kPipe) ? name.substr(kPipe.size()) : name);
  std::error_code failed;
  for (std::string word; words >> word;)
    if (std::filesystem::is_regular_file(word, failed))
      if (const auto bytes = robot::read_file(word, kMostBytes)) add(hash, *bytes);
  return hash;
}

}  // namespace sim::guest
