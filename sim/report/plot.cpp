#include "sim/report/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "robot/core/text.h"
#include "sim/report/page.h"

namespace sim::report {
namespace {

using robot::formatted;

// [px] size of the plot and space for the axes
constexpr double kWidth = 560, kHeight = 240;
constexpr double kLeft = 52, kRight = 12, kTop = 14, kBottom = 40;

/// Returns about `count` round numbers from `low` to `high`.
std::vector<double> ticks_between(double low, double high, int count) {
  const double rough = (high - low) / count, power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {1., 2., 5.})
    if (factor * power >= rough) {
      step = factor * power;
      break;
    }
  std::vector<double> ticks;
  for (double at = std::ceil(low / step - 1e-9) * step; at <= high + 1e-9 * step; at += step)
    ticks.push_back(std::abs(at) < 1e-9 * step ? 0 : at);
  return ticks;
}

}  // namespace

Plot::Plot(double left, double right, double bottom, double top)
    : left_(left), right_(right > left ? right : left + 1), bottom_(bottom), top_(top > bottom ? top : bottom + 1) {}

double Plot::x_of(double x) const { return kLeft + (x - left_) / (right_ - left_) * (kWidth - kLeft - kRight); }

double Plot::y_of(double y) const {
  const double inside = std::clamp(y, bottom_, top_);
  return kHeight - kBottom - (inside - bottom_) / (top_ - bottom_) * (kHeight - kTop - kBottom);
}

void Plot::line(const std::string& style, const std::vector<std::pair<double, double>>& points) {
  drawn_ += "<polyline class=\"" + style + "\" points=\"";
  for (const auto& [x, y] : points) drawn_ += formatted("%.1f,%.1f ", x_of(x), y_of(y));
  drawn_ += "\"/>\n";
  if (!points.empty())
    drawn_ += formatted("<circle class=\"end %s\" cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\"/>\n", style.c_str(),
                        x_of(points.back().first), y_of(points.back().second));
}

void Plot::dots(const std::string& style, const std::vector<std::pair<double, double>>& points) {
  drawn_ += "<g class=\"" + style + "\">\n";
  for (const auto& [x, y] : points)
    if (x >= left_ && x <= right_ && y >= bottom_ && y <= top_)
      drawn_ += formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1.8\"/>\n", x_of(x), y_of(y));
  drawn_ += "</g>\n";
}

void Plot::band(const std::string& style, const std::vector<double>& x, const std::vector<double>& low,
                const std::vector<double>& high) {
  drawn_ += "<polygon class=\"" + style + "\" points=\"";
  for (std::size_t i = 0; i < x.size(); ++i) drawn_ += formatted("%.1f,%.1f ", x_of(x[i]), y_of(high[i]));
  for (std::size_t i = x.size(); i-- > 0;) drawn_ += formatted("%.1f,%.1f ", x_of(x[i]), y_of(low[i]));
  drawn_ += "\"/>\n";
}

void Plot::level(const std::string& style, double y, const std::string& label, Label place) {
  const double at = y_of(y);
  drawn_ += formatted("<line class=\"%s\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>\n", style.c_str(), kLeft,
                      kWidth - kRight, at, at);
  if (!label.empty())
    drawn_ += formatted("<text class=\"label\" x=\"%.1f\" y=\"%.1f\">%s</text>\n", kLeft + 6,
                        place == Label::above ? at - 4 : at + 14, escaped(label).c_str());
}

void Plot::bar(const std::string& style, double left, double right, double height, const std::string& title) {
  const double top = y_of(height), bottom = y_of(std::max(0., bottom_));
  drawn_ += formatted(
      "<rect class=\"%s\" x=\"%.1f\" width=\"%.1f\" y=\"%.1f\" height=\"%.1f\" rx=\"1.5\"><title>%s</title></rect>\n",
      style.c_str(), x_of(left) + 1, std::max(0.5, x_of(right) - x_of(left) - 2), top, bottom - top,
      escaped(title).c_str());
}

std::string Plot::svg(const std::string& about, const std::string& x_label, bool y_axis) const {
  std::string all = formatted("<svg viewBox=\"0 0 %.0f %.0f\" role=\"img\" aria-label=\"%s\">\n", kWidth, kHeight,
                              escaped(about).c_str());
  if (y_axis)
    for (const double y : ticks_between(bottom_, top_, 5))
      all += formatted(
          "<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/><text class=\"tick y\" x=\"%.1f\" "
          "y=\"%.1f\">%g</text>\n",
          kLeft, kWidth - kRight, y_of(y), y_of(y), kLeft - 7, y_of(y) + 4, y);
  for (const double x : ticks_between(left_, right_, 6))
    all += formatted("<text class=\"tick x\" x=\"%.1f\" y=\"%.1f\">%g</text>\n", x_of(x), kHeight - kBottom + 17, x);
  all += formatted("<text class=\"axis\" x=\"%.1f\" y=\"%.1f\">%s</text>\n", (kLeft + kWidth - kRight) / 2, kHeight - 5,
                   escaped(x_label).c_str());
  return all + drawn_ + "</svg>\n";
}

}  // namespace sim::report
