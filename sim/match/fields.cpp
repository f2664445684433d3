#include "sim/match/fields.h"

#include <vector>

namespace sim {

std::string FieldPath::text() const {
  std::string text;
  for (int i = 0; i < depth; ++i) {
    if (i > 0) text += '.';
    text += names[i].name;
    if (names[i].index >= 0) text += "[" + std::to_string(names[i].index) + "]";
  }
  return text;
}

namespace {

/// Returns the bits of a field, with -0 replaced by 0.
template <class Field>
std::uint64_t comparable(Field field) {
  return bits_of(field == Field{} ? Field{} : field);
}

}  // namespace

std::string difference(const State& a, const State& b) {
  std::vector<std::uint64_t> of_a;
  visit_fields(a, [&](const FieldPath&, auto field) { of_a.push_back(comparable(field)); });

  std::string name;
  std::size_t i = 0;
  visit_fields(b, [&](const FieldPath& path, auto field) {
    if (comparable(field) != of_a[i++] && name.empty()) name = path.text();
  });
  return name;
}

}  // namespace sim
