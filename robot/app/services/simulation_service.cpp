#include "robot/app/services/simulation_service.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/json.h"
#include "robot/core/json_library.h"
#include "sim/io/situation.h"
#include "sim/io/source.h"
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

/// Returns the embedded situation of that name, or an Error that names a similar one. A path is no name: clients must not
/// read files.
Result<json> situation_named(const std::string& name) {
  const std::vector<std::string_view> known = sim::io::names_of("situations");
  if (std::ranges::find(known, name) == known.end())
    return sim::io::unknown_name("situation", std::string_view(name).substr(0, 100), known);
  const Result<sim::io::Source> source = sim::io::find_source("situations", "situation", name);
  if (!source) return source.failure();
  return parse_json(source->text);
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
  if (const json* situation = find(request, "situation")) {
    if (!situation->is_string()) return begin(body, *situation, seed);
    const Result<json> named = situation_named(situation->get<std::string>());
    return named ? begin(body, *named, seed) : net::failure("/sim/reset: " + named.error());
  }
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
  services.add("/sim/back", control, [&](const json& request, const ClientContext&) {
    const auto ticks = whole(request, "/sim/back", "ticks", 1);
    return ticks ? answer(body, body.back(*ticks)) : net::failure(ticks.error());
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
