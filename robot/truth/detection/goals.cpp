#include "robot/truth/detection/goals.h"

namespace robot::truth {

void remove_goals(const sim::field::Field& field, const Sight& sight, GroundGrid& grid) {
  const auto reach = [&](const Eigen::Vector2f& place) {
    return field.post_radius + GroundGrid::kCell / 2 + 2 * sight.deviation_at({place.x(), place.y(), 0.4F});
  };
  for (int post = 0; post < sim::field::kPosts; ++post) {
    const sim::Vec2 foot = sim::field::post_of(field, post);
    const Eigen::Vector2f place(foot.x, foot.y);
    for (const Layer layer : {Layer::low, Layer::body, Layer::head, Layer::tall})
      grid.remove(layer, place, reach(place));
    if (post % 2 != 0) continue;
    // the crossbar begins at every other post
    for (float y = -foot.y; y < foot.y; y += GroundGrid::kCell) {
      const Eigen::Vector2f bar(foot.x, y);
      grid.remove(Layer::tall, bar, reach(bar));
    }
  }
}

}  // namespace robot::truth
