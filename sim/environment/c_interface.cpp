#include <cstdio>
#include <exception>
#include <memory>
#include <string>

#include "sim/environment/environment.h"
#include "sim/environment/foresight_env.h"
#include "sim/match/hash.h"

struct foresight_env {
  std::unique_ptr<sim::environment::Environment> games;
  std::string problem;
};

namespace {

/// Calls work() and returns its Result as a status. An exception of the standard library, such as of memory, becomes a
/// sentence.
template <class Work>
std::int32_t guarded(foresight_env* env, Work&& work) {
  try {
    const robot::Result<void> done = work();
    env->problem = done ? "" : done.error();
  } catch (const std::exception& exception) {
    env->problem = std::string("environment: ") + exception.what();
  }
  return env->problem.empty() ? 0 : -1;
}

foresight_env* refuse(const std::string& sentence, char* problem, std::size_t room) {
  if (problem != nullptr && room > 0) std::snprintf(problem, room, "%s", sentence.c_str());
  return nullptr;
}

}  // namespace

#define VISIBLE __attribute__((visibility("default")))

extern "C" {

VISIBLE std::int32_t foresight_env_version(void) { return FORESIGHT_ENV_VERSION; }

VISIBLE foresight_env* foresight_env_open(std::int32_t version, const char* options, char* problem, std::size_t room) {
  if (version != FORESIGHT_ENV_VERSION)
    return refuse("environment: expected version " + std::to_string(FORESIGHT_ENV_VERSION) +
                      " of the interface, got a program of version " + std::to_string(version),
                  problem, room);
  try {
    auto games = sim::environment::Environment::open(options);
    if (!games) return refuse(games.error(), problem, room);
    return new foresight_env{*std::move(games), {}};
  } catch (const std::exception& exception) {
    return refuse(std::string("environment: ") + exception.what(), problem, room);
  }
}

VISIBLE void foresight_env_close(foresight_env* env) { delete env; }

VISIBLE foresight_env_shape foresight_env_shape_of(const foresight_env* env) {
  const auto& games = *env->games;
  return {games.games(), games.agents(), games.columns(), games.width()};
}

VISIBLE foresight_env_arrays foresight_env_arrays_of(foresight_env* env) {
  sim::environment::Arrays& arrays = env->games->arrays();
  return {arrays.observations.data(), arrays.actions.data(), arrays.rewards.data(),   arrays.terminated.data(),
          arrays.truncated.data(),    arrays.active.data(),  arrays.succeeded.data(), arrays.seeds.data()};
}

VISIBLE const char* foresight_env_about(const foresight_env* env) { return env->games->about().c_str(); }

VISIBLE std::int32_t foresight_env_reset(foresight_env* env, const std::uint64_t* seeds, const std::uint8_t* which) {
  return guarded(env, [&]() -> robot::Result<void> {
    const auto games = static_cast<std::size_t>(env->games->games());
    env->games->reset({seeds, games}, which ? std::span(which, games) : std::span<const std::uint8_t>());
    return {};
  });
}

VISIBLE std::int32_t foresight_env_step(foresight_env* env) {
  return guarded(env, [&] { return env->games->step(); });
}

VISIBLE std::int32_t foresight_env_check(foresight_env* env) {
  return guarded(env, [&] { return env->games->check(); });
}

VISIBLE std::uint64_t foresight_env_hash(const foresight_env* env, std::int32_t game) {
  return game < 0 || game >= env->games->games() ? 0 : sim::hash_of(env->games->state(game));
}

VISIBLE const char* foresight_env_error(const foresight_env* env) { return env->problem.c_str(); }

}  // extern "C"
