#include "robot/fit/text_plot.h"

#include <cmath>

#include "robot/core/text.h"

namespace robot::fit {

TextPlot::TextPlot(const Axes& axes) : axes_(axes), rows_(kHeight, std::string(kWidth, ' ')) {
  if (!(axes_.right > axes_.left)) axes_.right = axes_.left + 1;
  if (!(axes_.top > axes_.bottom)) axes_.top = axes_.bottom + 1;
}

void TextPlot::dot(char sign, double x, double y) {
  const double across = (x - axes_.left) / (axes_.right - axes_.left);
  const double up = (y - axes_.bottom) / (axes_.top - axes_.bottom);
  if (!(across >= 0 && across <= 1 && up >= 0 && up <= 1)) return;
  const auto column = static_cast<std::size_t>(std::lround(across * (kWidth - 1)));
  const auto row = static_cast<std::size_t>(std::lround((1 - up) * (kHeight - 1)));
  rows_[row][column] = sign;
}

std::string TextPlot::text() const {
  std::string text;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == rows_.size();
    text += is_end ? formatted("%7.2f |", i == 0 ? axes_.top : axes_.bottom) : std::string(8, ' ') + '|';
    text += rows_[i].substr(0, rows_[i].find_last_not_of(' ') + 1) + '\n';
  }
  text += std::string(8, ' ') + '+' + std::string(kWidth, '-') + '\n';
  return text + formatted("%9s%-*.2f%.2f\n", "", kWidth - 6, axes_.left, axes_.right);
}

}  // namespace robot::fit
