// A plot of characters, for a terminal.
#pragma once

#include <string>
#include <vector>

namespace robot::fit {

class TextPlot {
 public:
  static constexpr int kWidth = 72, kHeight = 18;  // [characters] of the area

  /// The ranges of the axes, in the units of the data.
  struct Axes {
    double left, right, bottom, top;
  };

  /// An empty range is widened to 1.
  explicit TextPlot(const Axes& axes);

  /// Draws a character over those before it. A point outside the axes, or one that is not finite, is left out.
  void dot(char sign, double x, double y);

  /// Returns the lines, with numbers at both ends of the axes.
  std::string text() const;

 private:
  Axes axes_;
  std::vector<std::string> rows_;  // the topmost first
};

}  // namespace robot::fit
