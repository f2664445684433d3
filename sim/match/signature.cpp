#include "sim/match/signature.h"

#include "sim/match/hash.h"
#include "sim/match/play.h"
#include "sim/match/situation.h"

namespace sim {
namespace {

constexpr std::uint64_t kSeed = 2012;

template <class List>
const auto& pick(const List& list, std::uint32_t word) {
  return list[word % list.size()];
}

/// Switches each effect over with a probability of 1/4.
void turn_effects_over(Effects& effects, std::uint32_t word) {
  Effects::visit(effects, [&](const char*, bool& effect, const char*, bool, bool) {
    if (word % 4 == 0) effect = !effect;
    word = word * 0x9e3779b1u >> 3;
  });
}

void add(Hash& hash, const referee::Event& event) {
  hash.add(static_cast<std::uint64_t>(event.kind));
  hash.add(event.tick);
  hash.add(event.robot);
}

}  // namespace

Scenario scenario(const Ingredients& ingredients, int number) {
  const RandomKey key{kSeed + static_cast<std::uint64_t>(number)};
  const auto what = draw(key, kNobody, Draw::situation, 1);
  const auto how = draw(key, kNobody, Draw::situation, 2);

  // rules and behaviours rotate, so that each one is used; everything else is random
  Scenario made;
  const auto n = static_cast<std::uint32_t>(number);
  Params& params = made.params;
  params.rules = pick(ingredients.rules, n / 2);
  params.rules.players = 1 + static_cast<int>(what[0] % kMaxPlayers);
  params.marks = field::marks_of(params.rules.field);
  for (std::uint32_t side = 0; side < 2; ++side) {
    params.teams[side].behaviour = pick(ingredients.behaviours, n + side * (1 + n / 8));
    params.teams[side].models = pick(ingredients.models, what[1 + side]);
    turn_effects_over(params.teams[side].models.effects, how[side]);
  }
  take_ball_of_rules(params);
  params.pace = how[2] % 2 == 0 ? Pace::every_tick : Pace::thinned;

  referee::Events events;
  made.start = number % 2 == 0 ? begin(params, key, events) : random_situation(params, key);
  return made;
}

std::uint64_t signature_of(const Ingredients& ingredients) {
  Hash hash;
  for (int number = 0; number < kScenarios; ++number) {
    auto [params, state] = scenario(ingredients, number);
    referee::Events events;
    for (int i = 1; i <= kScenarioSteps; ++i) {
      step(params, state, events);
      for (const referee::Event& event : events) add(hash, event);
      if (i % 30 == 0) hash.add(hash_of(state));
    }
  }
  return hash.value();
}

}  // namespace sim
