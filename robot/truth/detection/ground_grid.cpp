#include "robot/truth/detection/ground_grid.h"

#include <cmath>

namespace robot::truth {

GroundGrid::GroundGrid(const Eigen::Vector2d& half_size)
    : half_columns_(std::ceil(static_cast<float>(half_size.x()) / kCell)),
      half_rows_(std::ceil(static_cast<float>(half_size.y()) / kCell)),
      columns_(2 * static_cast<int>(half_columns_)),
      rows_(2 * static_cast<int>(half_rows_)) {
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  for (std::vector<Surface>& layer : layers_) layer.resize(cells);
  for (std::vector<std::uint32_t>& occupied : occupied_) occupied.reserve(cells);
}

void GroundGrid::clear() {
  for (std::size_t layer = 0; layer < kLayers; ++layer) {
    for (const std::uint32_t cell : occupied_[layer]) layers_[layer][cell] = {};
    occupied_[layer].clear();
  }
}

template <class Visit>
void GroundGrid::visit(const Eigen::Vector2f& place, float radius, Visit&& visit) const {
  // in units of cells, so that the middle of cell (0, 0) is at (0.5, 0.5)
  const float x = place.x() / kCell + half_columns_, y = place.y() / kCell + half_rows_, reach = radius / kCell;
  const int first_row = std::max(static_cast<int>(y - reach), 0),
            end_row = std::min(static_cast<int>(y + reach) + 1, rows_);
  for (int row = first_row; row < end_row; ++row) {
    const float up = static_cast<float>(row) + 0.5F - y, half_squared = reach * reach - up * up;
    if (half_squared < 0) continue;
    const float half = std::sqrt(half_squared);
    const int first = std::max(static_cast<int>(std::ceil(x - half - 0.5F)), 0);
    const int last = std::min(static_cast<int>(std::floor(x + half - 0.5F)), columns_ - 1);
    for (int column = first; column <= last; ++column) visit(index(row, column));
  }
}

Surface GroundGrid::within(Layer layer, const Eigen::Vector2f& place, float radius) const {
  const std::vector<Surface>& cells = layers_[static_cast<std::size_t>(layer)];
  Surface sum;
  visit(place, radius, [&](std::size_t cell) { sum.add(cells[cell]); });
  return sum;
}

void GroundGrid::remove(Layer layer, const Eigen::Vector2f& place, float radius) {
  std::vector<Surface>& cells = layers_[static_cast<std::size_t>(layer)];
  visit(place, radius, [&](std::size_t cell) { cells[cell] = {}; });
}

Eigen::Vector2f GroundGrid::densest(Layer layer, float radius) const {
  constexpr float kLeast = 3e-4F;  // [m²] a fifth of a full cell; scattered noise has less
  const std::vector<Surface>& cells = layers_[static_cast<std::size_t>(layer)];
  Eigen::Vector2f best = Eigen::Vector2f::Zero();
  float most = 0;
  for (const std::uint32_t cell : occupied_[static_cast<std::size_t>(layer)]) {
    if (cells[cell].area < kLeast) continue;
    const int column = static_cast<int>(cell) % columns_, row = static_cast<int>(cell) / columns_;
    const Eigen::Vector2f middle((static_cast<float>(column) + 0.5F - half_columns_) * kCell,
                                 (static_cast<float>(row) + 0.5F - half_rows_) * kCell);
    float area = 0;
    visit(middle, radius, [&](std::size_t near) { area += cells[near].area; });
    if (area > most) most = area, best = middle;
  }
  return best;
}

}  // namespace robot::truth
