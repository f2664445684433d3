#include "sim/match/hash.h"

#include "sim/match/fields.h"

namespace sim {

std::uint64_t hash_of_text(std::string_view text) {
  Hash hash;
  for (const char c : text) hash.add(static_cast<unsigned char>(c));
  return hash.value();
}

std::uint64_t hash_of(const State& state) {
  Hash hash;
  visit_fields(state, [&](const FieldPath&, auto field) { hash.add(bits_of(field)); });
  return hash.value();
}

std::uint64_t hash_of_game(const State& state) {
  State played = state;
  played.world.key = {};
  for (Robot& robot : played.robots) robot.mind = {};
  return hash_of(played);
}

std::string hex(std::uint64_t hash) {
  std::string digits(16, '0');
  for (int i = 15; i >= 0; --i, hash >>= 4) digits[static_cast<std::size_t>(i)] = "0123456789abcdef"[hash & 15];
  return digits;
}

}  // namespace sim
