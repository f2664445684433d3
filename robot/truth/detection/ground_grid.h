// The things on the carpet seen from above: a grid of the surface that the sensor sees, in layers of height.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace robot::truth {

/// The layers of the grid, from the carpet upwards. Things in the layer `tall` are no robots.
enum class Layer : std::uint8_t { low, body, head, tall };
inline constexpr std::size_t kLayers = 4;

/// The surface within one cell or several.
struct Surface {
  float area = 0;                // [m²] square to the sensor's rays
  float x_area = 0, y_area = 0;  // [m³] sums of area times place
  float top = 0;                 // [m] height of the highest point

  void add(const Surface& other) {
    area += other.area, x_area += other.x_area, y_area += other.y_area;
    top = std::max(top, other.top);
  }
  /// Returns its middle [m, field]. The area is > 0.
  Eigen::Vector2f mean() const { return {x_area / area, y_area / area}; }
};

/// A grid around the centre of the field. It keeps its memory from frame to frame.
class GroundGrid {
 public:
  static constexpr float kCell = 0.04F;  // [m]

  /// `half_size` [m] is half the size of the grid.
  explicit GroundGrid(const Eigen::Vector2d& half_size);

  /// Removes everything.
  void clear();

  /// Adds the surface of a pixel at a place [m, field]. A place outside of the grid counts for the nearest cell.
  void add(Layer layer, float x, float y, float area, float height) {
    const std::size_t cell = cell_of(x, y);
    Surface& surface = layers_[static_cast<std::size_t>(layer)][cell];
    if (surface.area == 0) occupied_[static_cast<std::size_t>(layer)].push_back(static_cast<std::uint32_t>(cell));
    surface.add({area, area * x, area * y, height});
  }

  /// Returns the surface of the cells whose middle is within `radius` [m] of a place [m, field].
  Surface within(Layer layer, const Eigen::Vector2f& place, float radius) const;

  /// Removes the surface of these cells.
  void remove(Layer layer, const Eigen::Vector2f& place, float radius);

  /// Returns the middle of the cell around which the most surface is within `radius` [m]. Tries only cells with some
  /// surface of their own; returns the centre of the grid when there is no such cell.
  Eigen::Vector2f densest(Layer layer, float radius) const;

 private:
  std::size_t cell_of(float x, float y) const {
    const int column = std::clamp(static_cast<int>(x / kCell + half_columns_), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>(y / kCell + half_rows_), 0, rows_ - 1);
    return index(row, column);
  }
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  /// Calls visit(cell) for each cell within a radius.
  template <class Visit>
  void visit(const Eigen::Vector2f& place, float radius, Visit&& visit) const;

  float half_columns_, half_rows_;
  int columns_, rows_;
  std::array<std::vector<Surface>, kLayers> layers_;
  std::array<std::vector<std::uint32_t>, kLayers> occupied_;  // cells with a surface, perhaps removed since
};

}  // namespace robot::truth
