// sim_signature: prints the simulator's signature. Needs only the standard library.
#include <cstdio>

#include "sim/io/ingredients.h"
#include "sim/match/hash.h"

int main() {
  const auto ingredients = sim::io::embedded_ingredients();
  if (!ingredients) {
    std::fprintf(stderr, "sim_signature: %s\n", ingredients.error().c_str());
    return 2;
  }
  std::printf("%s\n", sim::hex(sim::signature_of(ingredients->lists)).c_str());
  return 0;
}
