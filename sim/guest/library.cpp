#include "sim/guest/library.h"

#include <dlfcn.h>

#include <cstring>

namespace sim::guest {
namespace {

using robot::Error;
using robot::Result;

constexpr std::size_t kMostMemory = 1 << 24;  // bytes of a player

/// A player that the library made.
class Player {
 public:
  Player(const ForesightBehaviour& behaviour, const ForesightPlayer& facts)
      : behaviour_(behaviour), self_(behaviour.create(&facts)) {}
  ~Player() {
    if (self_) behaviour_.destroy(self_);
  }
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  void* self() const { return self_; }

 private:
  const ForesightBehaviour& behaviour_;
  void* const self_;
};

class LibraryGuest final : public GuestBehaviour {
 public:
  LibraryGuest(std::string name, std::uint64_t seed, const ForesightBehaviour& behaviour)
      : GuestBehaviour(std::move(name), seed), behaviour_(behaviour) {}

  std::optional<std::string> save() const override {
    if (!behaviour_.save) return {};
    std::string all;
    for (const Seat& seat : seats_) {
      std::string bytes = seat.loaded;
      if (seat.player) {
        const std::size_t size = behaviour_.save(seat.player->self(), nullptr, 0);
        if (size > kMostMemory) return {};
        bytes.resize(size);
        if (size > 0 && behaviour_.save(seat.player->self(), bytes.data(), size) != size) return {};
      }
      const auto length = static_cast<std::uint32_t>(bytes.size());
      all.append(reinterpret_cast<const char*>(&length), sizeof length).append(bytes);
    }
    return all;
  }

  Result<void> load(std::string_view bytes) override {
    for (Seat& seat : seats_) {
      std::uint32_t length = 0;
      if (bytes.size() < sizeof length) return Error{name() + ": the saved memory is truncated"};
      std::memcpy(&length, bytes.data(), sizeof length);
      bytes.remove_prefix(sizeof length);
      if (length > bytes.size()) return Error{name() + ": the saved memory is truncated"};
      // the library makes a player at its first decision
      seat.loaded = bytes.substr(0, length);
      if (length == 0) seat.player.reset();
      if (seat.player && !seat.take_memory(behaviour_)) return Error{"behaviour '" + name() + "': " + kRefused};
      bytes.remove_prefix(length);
    }
    return {};
  }

 private:
  static constexpr const char* kRefused = "load refused the bytes of save";

  /// A player, and memory that was loaded before it was made.
  struct Seat {
    std::unique_ptr<Player> player;
    std::string loaded;

    /// Gives the player that memory. Returns false if the library refuses it.
    bool take_memory(const ForesightBehaviour& behaviour) {
      if (loaded.empty()) return true;
      const bool taken = behaviour.load(player->self(), loaded.data(), loaded.size()) != 0;
      loaded.clear();
      return taken;
    }
  };

  std::string ask(const ForesightPlayer& facts, const ForesightMoment& moment, ForesightCommand& command) override {
    Seat& seat = seats_[static_cast<std::size_t>(facts.player)];
    if (!seat.player) {
      seat.player = std::make_unique<Player>(behaviour_, facts);
      if (!seat.player->self()) return "create returned no player";
      if (!seat.take_memory(behaviour_)) return kRefused;
    }
    behaviour_.decide(seat.player->self(), &moment, &command);
    return {};
  }

  const ForesightBehaviour& behaviour_;
  std::array<Seat, kMaxPlayers + 1> seats_;  // by number
};

/// A loaded library. It stays loaded to the end of the program, because players may still exist.
class Library final : public GuestFactory {
 public:
  Library(std::string path, const ForesightBehaviour& behaviour) : path_(std::move(path)), behaviour_(behaviour) {}

  std::unique_ptr<GuestBehaviour> begin(std::uint64_t seed) const override {
    return std::make_unique<LibraryGuest>(path_, seed, behaviour_);
  }
  bool saves() const override { return behaviour_.save != nullptr; }

 private:
  const std::string path_;
  const ForesightBehaviour& behaviour_;
};

std::string numbers(std::initializer_list<std::uint64_t> values) {
  std::string all;
  for (const std::uint64_t value : values) all += (all.empty() ? "" : ", ") + std::to_string(value);
  return all;
}

}  // namespace

Result<std::shared_ptr<const GuestFactory>> open_library(const std::string& path) {
  const std::string called = "behaviour '" + path + "': ";
  // a name without a folder would be searched among the system's libraries
  const std::string place = path.find('/') == path.npos ? "./" + path : path;
  void* const library = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) return Error{called + "cannot be loaded: " + dlerror()};
  const auto entry = reinterpret_cast<const ForesightBehaviour* (*)()>(dlsym(library, "foresight_behaviour"));
  if (!entry) return Error{called + "exports no foresight_behaviour, see sim/guest/foresight_behaviour.h"};
  const ForesightBehaviour* const behaviour = entry();
  if (!behaviour) return Error{called + "foresight_behaviour returned nothing"};
  if (behaviour->version != FORESIGHT_BEHAVIOUR_VERSION)
    return Error{called + "expected version " + numbers({FORESIGHT_BEHAVIOUR_VERSION}) + " of the interface, got " +
                 numbers({behaviour->version}) + "; build it anew with this sim/guest/foresight_behaviour.h"};
  if (behaviour->player_bytes != sizeof(ForesightPlayer) || behaviour->moment_bytes != sizeof(ForesightMoment) ||
      behaviour->command_bytes != sizeof(ForesightCommand))
    return Error{called + "expected structs of " +
                 numbers({sizeof(ForesightPlayer), sizeof(ForesightMoment), sizeof(ForesightCommand)}) +
                 " bytes, got " +
                 numbers({behaviour->player_bytes, behaviour->moment_bytes, behaviour->command_bytes}) +
                 "; build it anew with this sim/guest/foresight_behaviour.h"};
  if (!behaviour->create || !behaviour->destroy || !behaviour->decide)
    return Error{called + "expected create, destroy and decide, got a null pointer"};
  if (!behaviour->save != !behaviour->load)
    return Error{called + "expected save and load, or neither, got one of them"};
  return std::shared_ptr<const GuestFactory>(std::make_shared<Library>(path, *behaviour));
}

}  // namespace sim::guest
