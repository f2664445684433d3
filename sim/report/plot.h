// Small pictures of numbers, as SVG that the page's style colours.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sim::report {

/// "&lt;" for "<" and so on: text within a page.
std::string escaped(const std::string& text);

/// A picture with axes, drawn piece by piece in the numbers' own units.
class Plot {
 public:
  /// What the axes span; a span of nothing is widened.
  Plot(double left, double right, double bottom, double top);

  /// Classes name how the style draws a piece: "path", "bound", "zero", "mean" …
  void line(const std::string& style, const std::vector<std::pair<double, double>>& points);
  /// Between two lines with the same places.
  void band(const std::string& style, const std::vector<double>& x, const std::vector<double>& low,
            const std::vector<double>& high);
  void level(const std::string& style, double y, const std::string& label);
  void bar(const std::string& style, double left, double right, double height, const std::string& title);

  /// The whole picture. `about` is read out to those who do not see it.
  std::string svg(const std::string& about, const std::string& x_label, bool y_axis = true) const;

 private:
  double x_of(double x) const;
  double y_of(double y) const;

  double left_, right_, bottom_, top_;
  std::string drawn_;
};

}  // namespace sim::report
