// Reliability of forecasts: counts of one kind of event.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace sim::foresight {

/// The sums. Adding the same cases in the same order gives the same bits.
struct Reliability {
  static constexpr int kBins = 10;  // by forecast probability: 0 .. 0.1, …, 0.9 .. 1

  struct Bin {
    std::uint32_t cases = 0, came = 0;
    double foretold = 0;  // sum
  };

  std::uint32_t cases = 0, came = 0;
  double squares = 0;  // sum of (forecast - outcome)²
  std::array<Bin, kBins> bins{};

  /// `foretold` [0..1].
  void add(double foretold, bool did_come) {
    const double off = foretold - (did_come ? 1 : 0);
    squares += off * off;
    ++cases;
    came += did_come ? 1u : 0u;
    Bin& bin = bins[static_cast<std::size_t>(std::min(static_cast<int>(foretold * kBins), kBins - 1))];
    ++bin.cases;
    bin.came += did_come ? 1u : 0u;
    bin.foretold += foretold;
  }

  /// Returns the frequency [0..1] of the event; 0 without cases, as the following.
  double rate() const { return cases == 0 ? 0 : static_cast<double>(came) / cases; }
  /// Returns the Brier score [0..1]; small is good.
  double brier() const { return cases == 0 ? 0 : squares / cases; }
  /// Returns the Brier score [0..1] of always forecasting the frequency: the score to beat.
  double brier_of_rate() const { return rate() * (1 - rate()); }
};

}  // namespace sim::foresight
