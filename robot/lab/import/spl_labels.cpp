#include "robot/lab/import/spl_labels.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "proto/foresight/truth.pb.h"
#include "robot/core/text.h"
#include "robot/lab/import/label_camera.h"
#include "robot/lab/import/label_field.h"
#include "robot/lab/import/label_rows.h"
#include "robot/lab/import/label_stance.h"

namespace robot::lab {
namespace {

namespace pb = foresight;
using namespace labels;

/// Everything that turns boxes into places.
struct View {
  Teams teams;
  FieldView field;
  Stance stance;
};

Result<FieldView> view_of(const std::vector<Frame>& fitted, const std::vector<Frame>& all, const Teams& teams) {
  const Result<Camera> camera = fit_camera(upright_boxes(fitted));
  if (!camera) return camera.failure();
  return find_field(*camera, all, teams);
}

pb::GroundTruth truth_of(const Frame& frame, const View& view) {
  pb::GroundTruth truth;
  if (!frame.balls.empty()) {
    const Ground ball = view.field.ball(frame.balls.front());
    truth.mutable_ball()->set_x(static_cast<float>(ball.x));
    truth.mutable_ball()->set_y(static_cast<float>(ball.y));
  }
  for (const RobotBox& robot : frame.robots) {
    const Ground place = view.field.feet(robot.box);
    pb::GroundTruth::TrueRobot& seen = *truth.add_robots();
    const int team = team_of(robot, view.teams);
    if (team >= 0) seen.set_team(static_cast<std::uint32_t>(team) + 1);
    if (team >= 0 && robot.number >= 1) seen.set_player(static_cast<std::uint32_t>(robot.number));
    seen.set_x(static_cast<float>(place.x));
    seen.set_y(static_cast<float>(place.y));
    seen.set_fallen(view.stance.lies(robot.box));
  }
  return truth;
}

/// Returns the median distance [m] between the places of the same robots in two views.
double difference_of(const FieldView& one, const FieldView& two, const std::vector<Frame>& frames) {
  std::vector<double> distances;
  for (const Box& box : upright_boxes(frames)) {
    const Ground first = one.feet(box), second = two.feet(box);
    distances.push_back(std::hypot(first.x - second.x, first.y - second.y));
  }
  return median(std::move(distances));
}

/// Describes the camera and its error: on its own boxes, and on each half of the file after a fit to the other half.
std::string description_of(const View& view, const std::vector<Frame>& frames) {
  const Camera& camera = view.field.camera;
  const CameraError error = error_of(camera, upright_boxes(frames));
  std::string about = formatted(
      "camera %.1f m above the ground, focal length %.0f px, scale %.2f; median error %.1f %% of the distance, %.2f m",
      camera.height * view.field.scale, camera.focal_px, view.field.scale, 100 * error.share,
      view.field.scale * error.metres);
  const auto middle = frames.begin() + static_cast<std::ptrdiff_t>(frames.size() / 2);
  const std::vector<Frame> halves[2] = {{frames.begin(), middle}, {middle, frames.end()}};
  const Result<FieldView> views[2] = {view_of(halves[0], frames, view.teams), view_of(halves[1], frames, view.teams)};
  if (!views[0] || !views[1]) return about + "; too few boxes to fit the halves of the file";
  const CameraError other = error_of(views[0]->camera, upright_boxes(halves[1]));
  const CameraError back = error_of(views[1]->camera, upright_boxes(halves[0]));
  return about + formatted(
                     "; fitted to one half of the file, %.1f %% and %.1f %% on the other; places by the two fits "
                     "differ by %.2f m",
                     100 * other.share, 100 * back.share, difference_of(*views[0], *views[1], frames));
}

std::uint64_t capture_ns_of(const Frame& frame, const Frame& first) {
  const std::int64_t tick = ((frame.time_ms - first.time_ms) * 30 + 500) / 1000;
  return static_cast<std::uint64_t>(tick) * 1'000'000'000 / 30;
}

}  // namespace

Result<ImportReport> import_spl_labels(std::string_view file_bytes, std::uint64_t epoch_ns, ImportSink& sink) {
  Result<Rows> rows = read_rows(file_bytes);
  if (!rows) return rows.failure();
  const Result<Teams> teams = teams_of(rows->frames);
  if (!teams) return teams.failure();
  const Result<FieldView> field = view_of(rows->frames, rows->frames, *teams);
  if (!field) return field.failure();
  const View view{.teams = *teams, .field = *field, .stance = Stance(rows->frames)};

  ImportReport report;
  report.damage = std::move(rows->damage);
  report.about = description_of(view, rows->frames);
  CountingSink counted(sink, report);
  for (const Frame& frame : rows->frames) {
    if (frame.balls.size() > 1 && report.warnings.empty())
      report.warnings.push_back("the image at " + std::to_string(frame.time_ms) +
                                " ms has several balls; the first one counts");
    const std::uint64_t capture_ns = epoch_ns + capture_ns_of(frame, rows->frames.front());
    if (const Result<void> taken = counted.message(memory::kTruthTopic, capture_ns, truth_of(frame, view)); !taken)
      return taken.failure();
  }
  return report;
}

}  // namespace robot::lab
