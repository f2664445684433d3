#include "tests/bench/fit/planted.h"

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

namespace bench {

void Planted::add(const std::vector<robot::fit::Figure>& figures) {
  for (const robot::fit::Figure& figure : figures) {
    const auto planted = values_.find(figure.name);
    if (planted == values_.end()) continue;
    Tally& tally = tallies_[figure.name];
    tally.covered.add(planted->second >= figure.low && planted->second <= figure.high);
    tally.bias.push_back(figure.value - planted->second);
    tally.half_widths.push_back((figure.high - figure.low) / 2);
  }
}

void Planted::print() const {
  for (const auto& [name, tally] : tallies_) {
    const double half = sim::statistics::mean_of(tally.half_widths), bias = sim::statistics::mean_of(tally.bias);
    std::cout << nlohmann::json{{"case", "planted"},
                                {"figure", prefix_ + name},
                                {"planted", values_.at(name)},
                                {"repetitions", tally.covered.cases},
                                {"coverage", tally.covered.value()},
                                {"half_width", half},
                                {"bias", bias},
                                {"bias_share", std::abs(bias) / (2 * half)}}
                     .dump()
              << std::endl;
  }
}

}  // namespace bench
