#include "robot/fit/localisation/localisation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "proto/foresight/sim.pb.h"
#include "robot/core/text.h"
#include "robot/fit/localisation/pose_pictures.h"
#include "robot/fit/localisation/variance_parts.h"
#include "robot/fit/math/counts.h"
#include "robot/lab/clocks/belief_error.h"
#include "robot/logging/sessions/read_all.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestShifts = 8, kFewestFlips = 3;
constexpr double kFewestMinutes = 10;      // of robots that may flip
constexpr double kWidestRate = 0.05;       // [1/min]
constexpr double kWidestFlip = 15;         // [s]
constexpr double kFresh = 5;               // [s] after a fall or an entrance
constexpr double kEnoughPerMinute = 0.02;  // [1/min]
constexpr const char* kLocalisationTitle = "How well the robots know where they are";

/// A figure of shifts and the half of its widest useful interval.
struct ShiftFigure {
  const char* name;
  const char* unit;
  double widest;
  bool of_heading;
};
constexpr ShiftFigure kStarts[] = {{"localisation.start_deviation", "m", 0.15, false},
                                   {"localisation.start_deviation_heading", "rad", 0.1, true}};
constexpr ShiftFigure kFalls[] = {{"localisation.fall_deviation", "m", 0.15, false},
                                  {"localisation.fall_deviation_heading", "rad", 0.2, true}};

std::vector<SquaredError> squares_of(const std::vector<PoseShift>& shifts, bool of_heading) {
  std::vector<SquaredError> errors;
  for (const PoseShift& shift : shifts) {
    if (of_heading)
      errors.push_back({.squares = shift.heading * shift.heading,
                        .freedom = 1,
                        .amounts = {shift.events, 0, 0},
                        .known = shift.heading_noise});
    else
      errors.push_back({.squares = shift.x * shift.x + shift.y * shift.y,
                        .freedom = 2,
                        .amounts = {shift.events, 0, 0},
                        .known = shift.place_noise});
  }
  return errors;
}

Figure figure_of_shifts(const ShiftFigure& which, const std::vector<PoseShift>& shifts, const PoseErrors& poses,
                        const std::string& kind) {
  const std::vector<SquaredError> errors = squares_of(shifts, which.of_heading);
  const RootInterval root = relative_interval(errors, fit_variances(errors, 1));
  double least = INFINITY, most = 0;
  for (const SquaredError& error : errors) {
    least = std::min(least, std::sqrt(error.squares));
    most = std::max(most, std::sqrt(error.squares));
  }
  return {.name = which.name,
          .unit = which.unit,
          .value = root.value,
          .low = root.low,
          .high = root.high,
          .events = shifts.size(),
          .kind = kind,
          .recordings = poses.recordings,
          .domain = {.quantity = "shift", .unit = which.unit, .from = least, .to = most},
          .widest = which.widest};
}

void add_shifts(const ShiftFigure (&figures)[2], const std::vector<PoseShift>& shifts, const PoseErrors& poses,
                const std::string& kind, const std::string& advice, Report& report) {
  if (shifts.size() < kFewestShifts) {
    report.kept.push_back(formatted("%s and its heading: expected at least %zu %s beside the truth, got %zu",
                                    figures[0].name, kFewestShifts, kind.c_str(), shifts.size()));
    report.needs.push_back(need_of(figures[0].name, kind, shifts.size(), kFewestShifts, advice));
    return;
  }
  for (const ShiftFigure& which : figures) {
    report.figures.push_back(figure_of_shifts(which, shifts, poses, kind));
    report.needs.push_back(need_of(report.figures.back(), which.widest / 2, advice));
  }
}

void add_flip_rate(const PoseErrors& poses, Report& report) {
  const double minutes = poses.unsure_seconds / 60;
  const char* const name = "localisation.flips_per_minute";
  const std::string advice = "record whole games: a pose flips seldom";
  if (minutes < kFewestMinutes) {
    report.kept.push_back(
        formatted("%s: expected at least %.0f minutes of robots that are unsure of their pose, got %.1f", name,
                  kFewestMinutes, minutes));
    report.needs.push_back(
        need_of(name, "minutes", static_cast<std::size_t>(minutes), static_cast<std::size_t>(kFewestMinutes), advice));
    return;
  }
  const auto seen = static_cast<std::size_t>(std::ranges::count_if(poses.flips, &PoseFlip::seen_begin));
  const CountInterval count = poisson_interval(seen);
  report.figures.push_back({.name = name,
                            .unit = "1/min",
                            .value = static_cast<double>(seen) / minutes,
                            .low = count.low / minutes,
                            .high = count.high / minutes,
                            .events = seen,
                            .kind = "flips",
                            .recordings = poses.recordings,
                            .domain = {.quantity = "unsure", .unit = "min", .from = 0, .to = minutes},
                            .widest = kWidestRate});
  // an interval of a rate shrinks with the root of the minutes
  const Figure& figure = report.figures.back();
  Need need = need_of(figure, kEnoughPerMinute, advice);
  if (seen == 0 && (figure.high - figure.low) / 2 > kEnoughPerMinute) need.more = 1, need.advice = advice;
  report.needs.push_back(need);
}

void add_flip_duration(const PoseErrors& poses, Report& report) {
  const char* const name = "localisation.flip_duration";
  std::size_t ended = 0;
  double total = 0, longest = 0, shortest = INFINITY;
  for (const PoseFlip& flip : poses.flips) {
    // an exponential duration has no memory: a flip whose begin was not seen counts from its first moment
    ended += flip.seen_end ? 1 : 0;
    total += flip.duration;
    longest = std::max(longest, flip.duration);
    shortest = std::min(shortest, flip.duration);
  }
  if (ended < kFewestFlips) {
    report.kept.push_back(
        formatted("%s: expected at least %zu flips whose end was seen, got %zu", name, kFewestFlips, ended));
    report.needs.push_back(need_of(name, "flips", ended, kFewestFlips, "record whole games: a pose flips seldom"));
    return;
  }
  const MeanDuration mean = mean_duration(ended, total);
  report.figures.push_back({.name = name,
                            .unit = "s",
                            .value = mean.value,
                            .low = mean.low,
                            .high = mean.high,
                            .events = ended,
                            .kind = "flips",
                            .recordings = poses.recordings,
                            .domain = {.quantity = "duration", .unit = "s", .from = shortest, .to = longest},
                            .widest = kWidestFlip});
  report.needs.push_back(need_of(report.figures.back(), kWidestFlip / 2, "record whole games: a pose flips seldom"));
}

// --- results ---

using Chosen = std::function<bool(const PoseError&)>;

void add_error_row(const std::string& name, const PoseErrors& poses, const Chosen& is_chosen, Results& results) {
  std::vector<double> places, headings;
  for (const auto& errors : poses.errors)
    for (const PoseError& error : errors) {
      if (!is_chosen(error)) continue;
      places.push_back(error.far());
      headings.push_back(std::abs(error.heading));
    }
  if (places.empty()) return;
  const lab::ErrorFigures place = lab::figures_of(std::move(places)), heading = lab::figures_of(std::move(headings));
  results.rows.push_back({name, formatted("%.0f", static_cast<double>(place.samples) / 30),
                          formatted("%.3f", place.mean), formatted("%.3f", place.median), formatted("%.3f", place.p95),
                          formatted("%.3f", heading.mean), formatted("%.3f", heading.median),
                          formatted("%.3f", heading.p95)});
}

void add_error_results(const PoseErrors& poses, Report& report) {
  Results results{.title = "Errors of the believed pose; of a flipped one beside the flipped truth",
                  .head = {"robots that", "poses / 30", "place: mean [m]", "median", "95 %", "heading: mean [rad]",
                           "median", "95 %"},
                  .rows = {}};
  const auto far = [](const PoseError& error) { return std::hypot(error.true_x, error.true_y); };
  const auto up = [](const PoseError& error) { return error.upright; };
  add_error_row("stand upright or walk", poses, up, results);
  add_error_row(
      "walk", poses, [](const PoseError& error) { return error.upright && error.walks; }, results);
  add_error_row(
      "stand", poses, [](const PoseError& error) { return error.upright && !error.walks; }, results);
  add_error_row(
      "lie or get up", poses, [](const PoseError& error) { return !error.upright; }, results);
  add_error_row(
      "fell or entered within 5 s", poses, [](const PoseError& error) { return error.upright && error.since < kFresh; },
      results);
  add_error_row(
      "did so earlier", poses, [](const PoseError& error) { return error.upright && error.since >= kFresh; }, results);
  add_error_row(
      "are within 1.5 m of the centre", poses,
      [&](const PoseError& error) { return error.upright && far(error) < 1.5; }, results);
  add_error_row(
      "are 1.5 to 3 m from it", poses,
      [&](const PoseError& error) { return error.upright && far(error) >= 1.5 && far(error) < 3; }, results);
  add_error_row(
      "are farther", poses, [&](const PoseError& error) { return error.upright && far(error) >= 3; }, results);
  report.results.push_back(std::move(results));
}

/// Adds how well the reported deviations fit the errors. A consistent filter has a mean of 1.
void add_honesty(const PoseErrors& poses, Report& report) {
  double place = 0, heading = 0, inside = 0, places = 0, headings = 0;
  for (const auto& errors : poses.errors)
    for (const PoseError& error : errors) {
      if (!error.upright || error.flipped) continue;
      if (error.deviation > 0) {
        const double square = error.far() * error.far() / (error.deviation * error.deviation);
        place += std::min(square, 100.) / 2;
        inside += square < 5.991 ? 1 : 0;
        ++places;
      }
      if (error.deviation_heading > 0)
        heading += std::min(100., std::pow(error.heading / error.deviation_heading, 2)), ++headings;
    }
  if (places == 0 || headings == 0) return;
  report.results.push_back(
      {.title = "Deviations that the robots report, beside their errors",
       .head = {"squared error / reported variance", "mean", "of an honest robot"},
       .rows = {{"place", formatted("%.2f", place / places), "1"},
                {"heading", formatted("%.2f", heading / headings), "1"},
                {"places inside the region of 95 %", formatted("%.0f %%", 100 * inside / places), "95 %"}}});
  report.scores.emplace_back("place_inside_95", inside / places);
}

void add_pose_notes(const PoseErrors& poses, Report& report) {
  report.notes.push_back(formatted(
      "%.0f minutes of poses beside the truth, %.0f of them of robots that are unsure (deviation above 0.1 m or 10°): "
      "%zu entrances, %zu falls, %zu flips",
      poses.watched_seconds / 60, poses.unsure_seconds / 60, poses.starts.size(), poses.falls.size(),
      poses.flips.size()));
  report.notes.push_back(formatted("the truth scatters by up to %.3f m on each axis and %.3f rad, which is taken off",
                                   poses.place_noise, poses.heading_noise));
  if (poses.falls_left_out > 0)
    report.notes.push_back(
        formatted("%zu falls left out: without a pose or a truth close before and after", poses.falls_left_out));
  if (poses.without_sides > 0)
    report.notes.push_back(formatted("%zu recordings do not say the direction of play; it is the one that fits best",
                                     poses.without_sides));
  if (poses.damaged > 0) report.notes.push_back(formatted("%zu damaged messages left out", poses.damaged));
}

/// Returns the field that a simulator recorded, else that of the league.
sim::field::Field field_of(const Evidence& evidence) {
  sim::field::Field field = kFieldOfTheLeague;
  for (const WatchedRobot& robot : evidence.robots) {
    bool found = false;
    logging::read_each<foresight::Simulation>(
        robot.session, memory::kSimulationTopic, [&](const foresight::Simulation& simulation, std::uint64_t) {
          const foresight::Field& read = simulation.field();
          if (found || !(read.length() > 2 && read.width() > 2 && read.length() < 30 && read.width() < 20)) return;
          found = true;
          field = {.length = read.length(),
                   .width = read.width(),
                   .border = read.border(),
                   .line_width = read.line_width(),
                   .centre_circle_radius = read.centre_circle_radius(),
                   .goal_area_length = read.goal_area_length(),
                   .goal_area_width = read.goal_area_width(),
                   .penalty_area_length = read.penalty_area_length(),
                   .penalty_area_width = read.penalty_area_width(),
                   .penalty_mark = read.penalty_mark(),
                   .goal_width = read.goal_width(),
                   .goal_depth = read.goal_depth(),
                   .post_radius = field.post_radius};
        });
    if (found) break;
  }
  return field;
}

Table table_of_shifts(const std::vector<PoseShift>& shifts, const PoseErrors& poses) {
  Table table{
      .columns = {"time [s]", "x [m]", "y [m]", "heading [rad]", "falls"}, .names = poses.recordings, .rows = {}};
  for (const PoseShift& shift : shifts)
    table.rows.push_back(
        {.recording = shift.recording, .values = {shift.at, shift.x, shift.y, shift.heading, shift.events}});
  return table;
}

}  // namespace

void add_poses(const WatchedMotion& motion, PoseEvidence& evidence) {
  const std::size_t before = evidence.poses.errors.size();
  add_pose_errors(motion, evidence.poses);
  if (evidence.poses.errors.size() > before)
    add_mark_walk(motion, evidence.poses.errors.back(), evidence.poses.noises.back(), evidence.marks);
}

Report localisation_report(const PoseEvidence& evidence, const sim::Models& base, const sim::field::Field& field) {
  const PoseErrors& poses = evidence.poses;
  Report report{.name = "localisation", .title = kLocalisationTitle};
  if (poses.recordings.empty()) {
    report.kept.emplace_back(
        "localisation: expected a recording with poses beside a truth with headings of the robot, got 0");
    report.needs.push_back(need_of("localisation.start_deviation", "entrances", 0, kFewestShifts,
                                   "record the pose, and a truth with the robots' headings"));
    return report;
  }
  add_shifts(kStarts, poses.starts, poses, "entrances", "let robots enter the field, after penalties too", report);
  add_shifts(kFalls, poses.falls, poses, "falls", "record games: robots fall in them", report);
  add_flip_rate(poses, report);
  add_flip_duration(poses, report);
  add_marks(evidence.marks, base, field, report);
  add_pose_pictures(poses, base.perception.localisation, report);
  add_error_results(poses, report);
  add_honesty(poses, report);
  add_pose_notes(poses, report);
  report.tables.emplace_back("entrances", table_of_shifts(poses.starts, poses));
  report.tables.emplace_back("falls", table_of_shifts(poses.falls, poses));
  return report;
}

Report fit_localisation(const Evidence& evidence, const sim::Models& base) {
  PoseEvidence poses;
  for (const WatchedRobot& robot : evidence.robots)
    add_poses(read_motion(robot, {.odometry = true, .poses = true, .heads = true}), poses);
  return localisation_report(poses, base, field_of(evidence));
}

}  // namespace robot::fit
