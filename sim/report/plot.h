// Small plots as SVG. The page's style sets their colours.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sim::report {

/// A plot with axes. Coordinates are in the units of the data.
class Plot {
 public:
  enum class Label { above, below };  // its line

  /// Takes the ranges of the axes. An empty range is widened to 1.
  Plot(double left, double right, double bottom, double top);

  /// `style` is a CSS class of the page: "path", "zero", "mean" …
  void line(const std::string& style, const std::vector<std::pair<double, double>>& points);
  /// Draws a dot for each point; those outside the ranges are left out.
  void dots(const std::string& style, const std::vector<std::pair<double, double>>& points);
  /// Fills the area between two lines with the same x.
  void band(const std::string& style, const std::vector<double>& x, const std::vector<double>& low,
            const std::vector<double>& high);
  void level(const std::string& style, double y, const std::string& label, Label place = Label::above);
  void bar(const std::string& style, double left, double right, double height, const std::string& title);

  /// Returns the whole plot. Screen readers read `about`.
  std::string svg(const std::string& about, const std::string& x_label, bool y_axis = true) const;

 private:
  double x_of(double x) const;
  double y_of(double y) const;

  double left_, right_, bottom_, top_;
  std::string drawn_;
};

}  // namespace sim::report
