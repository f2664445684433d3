#include "robot/app/services/simulation_service.h"

#include <optional>
#include <string>

#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "sim/io/situation.h"
#include "sim/math/tick.h"

namespace robot::app {
namespace {

using net::ClientContext;
using nlohmann::json;

json describe(const foresight::SimulatedTeam& team) {
  return {{"number", team.number()}, {"strategy", team.strategy()}, {"models", team.models()}, {"score", team.score()}};
}

json answer(const body::SimBody& body) {
  const foresight::Simulation state = body.state();
  return {{"ok", true},
          {"paused", state.paused()},
          {"finished", state.finished()},
          {"speed", state.speed()},
          {"seed", state.seed()},
          {"tick", state.tick()},
          {"seconds", static_cast<float>(state.tick()) * sim::kTickDuration},
          {"ticks_behind", state.ticks_behind()},
          {"rules", state.rules()},
          {"home", describe(state.home())},
          {"away", describe(state.away())}};
}

json answer(const body::SimBody& body, const Result<void>& done) {
  return done ? answer(body) : net::failure(done.error());
}

/// Returns the entry `key`, or nullptr.
const json* find(const json& request, const char* key) {
  const auto found = request.find(key);
  return found == request.end() ? nullptr : &*found;
}

/// Reads the entry `key` as a whole number >= 0. Returns `otherwise` if the request does not have it.
Result<std::int64_t> whole(const json& request, const char* service, const char* key,
                           std::optional<std::int64_t> otherwise = {}) {
  const json* entry = find(request, key);
  if (!entry && otherwise) return *otherwise;
  constexpr std::int64_t kGreatest = body::SimBody::kGreatestSeed;
  const std::optional<std::int64_t> number = entry ? whole_number(*entry) : std::nullopt;
  if (number && *number >= 0 && *number <= kGreatest) return *number;
  return Error{std::string(service) + ": '" + key + "' must be a whole number 0 .. " + std::to_string(kGreatest) +
               (entry ? ", got " + entry->dump().substr(0, 40) : ", got none")};
}

/// Spells each whole number without a fraction, because the simulator reads its integers only so.
void spell_whole_numbers(json& value) {
  if (value.is_structured())
    for (json& element : value) spell_whole_numbers(element);
  else if (const auto number = value.is_number_float() ? whole_number(value) : std::nullopt)
    value = *number;
}

/// Begins a game from the described situation. A given `seed` replaces the seed of the description.
json begin(body::SimBody& body, json situation, std::optional<std::uint64_t> seed) {
  if (seed && situation.is_object()) situation["seed"] = *seed;
  spell_whole_numbers(situation);
  const auto state = sim::io::parse_situation(situation.dump(), "situation", body.setup().params());
  if (!state) return net::failure("/sim/reset: " + state.error());
  body.reset(*state);
  return answer(body);
}

json reset(body::SimBody& body, const json& request) {
  std::optional<std::uint64_t> seed;
  if (find(request, "seed")) {
    const auto given = whole(request, "/sim/reset", "seed");
    if (!given) return net::failure(given.error());
    seed = static_cast<std::uint64_t>(*given);
  }
  if (const json* situation = find(request, "situation")) return begin(body, *situation, seed);
  return answer(body, body.reset(seed.value_or(body.state().seed())));
}

}  // namespace

void add_simulation_service(body::SimBody& body, net::Services& services) {
  using enum net::Services::For;
  services.add("/sim/state", everybody, [&](const json&, const ClientContext&) { return answer(body); });
  services.add("/sim/pause", control, [&](const json&, const ClientContext&) {
    body.pause();
    return answer(body);
  });
  services.add("/sim/resume", control, [&](const json&, const ClientContext&) { return answer(body, body.resume()); });
  services.add("/sim/step", control, [&](const json& request, const ClientContext&) {
    const auto ticks = whole(request, "/sim/step", "ticks", 1);
    return ticks ? answer(body, body.step(*ticks)) : net::failure(ticks.error());
  });
  services.add("/sim/speed", control, [&](const json& request, const ClientContext&) {
    const json* speed = find(request, "speed");
    if (!speed || !speed->is_number()) return net::failure("/sim/speed: 'speed' must be a number 0.1 .. 100");
    return answer(body, body.set_speed(speed->get<double>()));
  });
  services.add("/sim/seed", control, [&](const json& request, const ClientContext&) {
    const auto seed = whole(request, "/sim/seed", "seed");
    return seed ? answer(body, body.reset(static_cast<std::uint64_t>(*seed))) : net::failure(seed.error());
  });
  services.add("/sim/reset", control, [&](const json& request, const ClientContext&) { return reset(body, request); });
}

}  // namespace robot::app
