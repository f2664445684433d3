#include "robot/fit/localisation/odometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robot/core/text.h"
#include "robot/fit/localisation/odometry_fit.h"

namespace robot::fit {
namespace {

constexpr std::size_t kFewestWindows = 40, kWindowsOfBlock = 20, kOdometryFolds = 5;
constexpr double kDriftOutlier = 4.5;  // standard deviations: such a window hardly counts

/// A figure of the odometry and the half of the widest useful interval.
struct NoiseFigure {
  const char* name;
  const char* unit;
  double widest;
};
constexpr NoiseFigure kTranslation{"localisation.translation_noise", "m^0.5", 0.03};
constexpr NoiseFigure kRotation{"localisation.rotation_noise", "rad^0.5", 0.05};
constexpr NoiseFigure kRotationPerMetre{"localisation.rotation_per_metre", "rad/m^0.5", 0.03};
constexpr NoiseFigure kBias{"localisation.bias", "", 0.03};
constexpr const char* kWalkAdvice = "let robots walk and turn alone beside the truth, a minute each";
constexpr const char* kMoreRobots = "record more robots, and each of them in other games";

OdometryModel odometry_model_of(const sim::perception::Localisation& base, const OdometryModel& errors_of_truth) {
  return {.bias = base.bias,
          .translation_noise = base.translation_noise,
          .rotation_noise = base.rotation_noise,
          .rotation_per_metre = base.rotation_per_metre,
          .place_error = errors_of_truth.place_error,
          .heading_error = errors_of_truth.heading_error};
}

bool is_walk(const DriftWindow& window) { return window.way > 0 || window.turned > 0; }

std::size_t count_walk_windows(const std::vector<DriftWindow>& windows) {
  return static_cast<std::size_t>(std::ranges::count_if(windows, is_walk));
}

/// Returns the windows in blocks of consecutive ones of a recording.
std::vector<Group> drift_blocks_of(const std::vector<DriftWindow>& windows) {
  std::vector<Group> blocks;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (i == 0 || windows[i].recording != windows[i - 1].recording || blocks.back().size() == kWindowsOfBlock)
      blocks.emplace_back();
    blocks.back().push_back(i);
  }
  return blocks;
}

Domain drift_domain_of(const std::vector<DriftWindow>& windows, const char* quantity, const char* unit,
                       double DriftWindow::*amount) {
  double least = INFINITY, most = 0;
  for (const DriftWindow& window : windows)
    if (is_walk(window)) least = std::min(least, window.*amount), most = std::max(most, window.*amount);
  return {.quantity = quantity, .unit = unit, .from = least, .to = most};
}

Figure noise_figure_of(const NoiseFigure& part, const RootInterval& root, std::size_t events, const std::string& kind,
                       const Drift& drift, Domain domain) {
  return {.name = part.name,
          .unit = part.unit,
          .value = root.value,
          .low = root.low,
          .high = root.high,
          .events = events,
          .kind = kind,
          .recordings = drift.recordings,
          .domain = std::move(domain),
          .widest = part.widest};
}

void add_noise_figures(const Drift& drift, const OdometryFit& fit, Report& report) {
  const std::vector<RootInterval> intervals = noise_intervals(drift, fit);
  const std::size_t events = count_walk_windows(drift.windows);
  const auto add = [&](const NoiseFigure& part, const RootInterval& root, const Domain& domain) {
    if (!std::isfinite(root.high))
      return report.kept.push_back(
          formatted("%s: expected windows in which the robots walk and turn by different amounts, got %zu alike",
                    part.name, events));
    report.figures.push_back(noise_figure_of(part, root, events, "windows", drift, domain));
    report.needs.push_back(need_of(report.figures.back(), part.widest / 2, kWalkAdvice));
  };
  const Domain way = drift_domain_of(drift.windows, "way", "m", &DriftWindow::way);
  add(kTranslation, intervals[0], way);
  add(kRotation, intervals[1], drift_domain_of(drift.windows, "turn", "rad", &DriftWindow::turned));
  add(kRotationPerMetre, intervals[2], way);
}

void add_bias_figure(const Drift& drift, const OdometryFit& fit, Report& report) {
  const std::size_t known = known_scales(fit);
  if (known < kFewestScales) {
    report.kept.push_back(
        formatted("localisation.bias: expected at least %zu known scales, two of each robot and game, got %zu",
                  kFewestScales, known));
    report.needs.push_back(need_of(kBias.name, "scales", known, kFewestScales, kMoreRobots));
    return;
  }
  double least = INFINITY, most = -INFINITY;
  for (const auto* scales : {&fit.walking, &fit.turning})
    for (const OdometryScale& scale : *scales)
      if (scale.is_known()) least = std::min(least, scale.value), most = std::max(most, scale.value);
  report.figures.push_back(noise_figure_of(kBias, bias_interval(fit), known, "scales", drift,
                                           {.quantity = "scale", .unit = "", .from = least, .to = most}));
  report.needs.push_back(need_of(report.figures.back(), kBias.widest / 2, kMoreRobots));
}

// --- pictures ---

/// The errors of windows over an amount, and their root mean squares in bins of half an octave.
class DriftGrowth {
 public:
  void add(double amount, double squares, double freedom) {
    if (!(amount > 0.1)) return;
    dots_.x.push_back(amount);
    dots_.y.push_back(std::sqrt(squares / freedom));
    const auto bin = static_cast<std::size_t>(std::lround(2 * std::log2(amount / 0.1)));
    if (bin >= bins_.size()) bins_.resize(bin + 1);
    bins_[bin].squares.push_back(squares / freedom), bins_[bin].amount += amount;
  }

  double most() const { return dots_.x.empty() ? 1 : *std::ranges::max_element(dots_.x); }

  Mark dots() const {
    Mark mark = dots_;
    mark.label = "a window";
    return mark;
  }

  /// Returns the root mean squares, by bins with at least ten windows. One in a hundred is left out as bad.
  Mark means() const {
    Mark mark{.role = Mark::Role::robot, .label = "root mean square of the windows", .x = {}, .y = {}, .high = {}};
    for (const Bin& bin : bins_) {
      if (bin.squares.size() < 10) continue;
      std::vector<double> squares = bin.squares;
      std::ranges::sort(squares);
      double sum = 0;
      const std::size_t kept = squares.size() - squares.size() / 100;
      for (std::size_t i = 0; i < kept; ++i) sum += squares[i];
      mark.x.push_back(bin.amount / static_cast<double>(bin.squares.size()));
      mark.y.push_back(std::sqrt(sum / static_cast<double>(kept)));
    }
    return mark;
  }

 private:
  struct Bin {
    std::vector<double> squares;
    double amount = 0;
  };
  Mark dots_{.label = "", .x = {}, .y = {}, .high = {}};
  std::vector<Bin> bins_;
};

template <class DeviationAt>
Mark deviation_curve(Mark::Role role, const std::string& label, double most, DeviationAt&& deviation_at) {
  Mark mark{.shape = Mark::Shape::line, .role = role, .label = label, .x = {}, .y = {}, .high = {}};
  for (int i = 0; i <= 80; ++i) {
    mark.x.push_back(most * i / 80);
    mark.y.push_back(deviation_at(most * i / 80));
  }
  return mark;
}

/// Returns a picture of a growing error with the curve of the fit and that of the present models.
template <class DeviationOf>
Picture growth_picture_of(const std::string& title, const std::string& x_label, const std::string& y_label,
                          const DriftGrowth& growth, DeviationOf&& deviation_of) {
  Picture picture{.title = title, .x_label = x_label, .y_label = y_label, .axes = {}, .marks = {}};
  picture.marks.push_back(growth.dots());
  picture.marks.push_back(deviation_curve(Mark::Role::other, "models so far", growth.most(),
                                          [&](double x) { return deviation_of(x, false); }));
  picture.marks.push_back(
      deviation_curve(Mark::Role::fitted, "fitted", growth.most(), [&](double x) { return deviation_of(x, true); }));
  picture.marks.push_back(growth.means());
  const double top = 2.5 * std::max(deviation_of(growth.most(), true), deviation_of(growth.most(), false));
  picture.axes = {.left = 0, .right = growth.most(), .bottom = 0, .top = top};
  return picture;
}

void add_place_picture(const Drift& drift, const OdometryFit& fit, const OdometryModel& before, Report& report) {
  DriftGrowth growth;
  const auto errors = place_errors(drift.growth, fit.walking);
  for (std::size_t i = 0; i < errors.size(); ++i) growth.add(drift.growth[i].way, errors[i].squares, 2);
  report.pictures.push_back(growth_picture_of("How far the believed place drifts", "way walked [m]",
                                              "error of each axis, beside the robot's own scale [m]", growth,
                                              [&](double way, bool fitted) {
                                                const OdometryModel& model = fitted ? fit.model : before;
                                                return std::sqrt(model.place_variance({.way = way, .grown_way = way}));
                                              }));
}

void add_heading_picture(const Drift& drift, const OdometryFit& fit, const OdometryModel& before, Report& report) {
  DriftGrowth growth;
  double way = 0, turned = 0;
  const auto errors = heading_errors(drift.growth, fit.turning);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    growth.add(drift.growth[i].way, errors[i].squares, 1);
    if (drift.growth[i].way > 0.1) way += drift.growth[i].way, turned += drift.growth[i].turned;
  }
  // the curve is that of a walk with the mean turn for each metre
  const double turn = way > 0 ? turned / way : 0;
  report.pictures.push_back(growth_picture_of(
      "How far the believed heading drifts", "way walked [m]",
      formatted("error beside the robot's own scale [rad], at %.1f rad turned for each metre", turn), growth,
      [&](double amount, bool fitted) {
        const OdometryModel& model = fitted ? fit.model : before;
        return std::sqrt(model.heading_variance({.grown_way = amount, .grown_turned = turn * amount}));
      }));
}

void add_scale_picture(const OdometryFit& fit, Report& report) {
  Picture picture{.title = "Scales of the odometry",
                  .x_label = "number of the recording",
                  .y_label = "believed / true",
                  .axes = {},
                  .marks = {}};
  double most = 0.05;
  const auto count = static_cast<double>(fit.walking.size());
  if (std::isfinite(fit.model.bias)) {
    picture.marks.push_back({.shape = Mark::Shape::band,
                             .role = Mark::Role::fitted,
                             .label = "one standard deviation: the bias",
                             .x = {0, count + 1},
                             .y = {1 - fit.model.bias, 1 - fit.model.bias},
                             .high = {1 + fit.model.bias, 1 + fit.model.bias}});
    most = std::max(most, 2 * fit.model.bias);
  }
  const auto add = [&](const std::vector<OdometryScale>& scales, double shift, Mark::Role role, const char* label) {
    Mark dots{.role = role, .label = label, .x = {}, .y = {}, .high = {}};
    for (std::size_t i = 0; i < scales.size(); ++i) {
      if (!scales[i].is_known()) continue;
      const double x = static_cast<double>(i) + 1 + shift, half = 1.96 * scales[i].deviation;
      dots.x.push_back(x);
      dots.y.push_back(scales[i].value);
      picture.marks.push_back({.shape = Mark::Shape::line,
                               .role = role,
                               .label = "",
                               .x = {x, x},
                               .y = {scales[i].value - half, scales[i].value + half},
                               .high = {}});
      most = std::max(most, std::abs(scales[i].value - 1) + half);
    }
    picture.marks.push_back(std::move(dots));
  };
  add(fit.walking, -0.1, Mark::Role::truth, "walking, with its 95 % interval");
  add(fit.turning, 0.1, Mark::Role::robot, "turning");
  picture.axes = {.left = 0, .right = count + 1, .bottom = 1 - 1.1 * most, .top = 1 + 1.1 * most};
  report.pictures.push_back(std::move(picture));
}

// --- results ---

void add_scale_results(const Drift& drift, const OdometryFit& fit, Report& report) {
  Results results{.title = "Scales of each recording: believed / true, with one standard deviation",
                  .head = {"recording", "walking", "turning", "way [m]", "turned [rad]"},
                  .rows = {}};
  const auto text = [](const OdometryScale& scale) {
    return scale.is_known() ? formatted("%.3f ± %.3f", scale.value, scale.deviation) : "not known";
  };
  std::vector<double> way(drift.recordings.size()), turned(drift.recordings.size());
  for (const DriftWindow& window : drift.windows)
    way[window.recording] += window.way, turned[window.recording] += window.turned;
  for (std::size_t i = 0; i < drift.recordings.size(); ++i)
    results.rows.push_back({drift.recordings[i], text(fit.walking[i]), text(fit.turning[i]), formatted("%.0f", way[i]),
                            formatted("%.0f", turned[i])});
  report.results.push_back(std::move(results));
}

/// The fit of windows of one fold, scored by models that do not know them.
struct HeldOutDrift {
  double place = 0, heading = 0;  // sums of the negative logarithms of densities
  std::size_t windows = 0, inside = 0,
              turned_inside = 0;  // within one standard deviation (39 % of places, 68 % of turns)

  void add(const OdometryModel& model, const DriftWindow& window) {
    if (!is_walk(window)) return;
    const double bias = std::isfinite(model.bias) ? model.bias * model.bias : 0;
    const double of_place =
        model.place_variance(window) + bias / 2 * (std::pow(window.true_x, 2) + std::pow(window.true_y, 2));
    const double of_turn = model.heading_variance(window) + bias * std::pow(window.true_turn, 2);
    const double squares = std::pow(window.error_x, 2) + std::pow(window.error_y, 2);
    const double square = std::pow(window.error_turn, 2);
    if (!std::isfinite(squares + square)) return;
    // single bad windows do not decide
    place += std::log(of_place) + std::min(squares / of_place, kDriftOutlier * kDriftOutlier) / 2;
    heading += std::log(of_turn) / 2 + std::min(square / of_turn, kDriftOutlier * kDriftOutlier) / 2;
    ++windows;
    inside += squares <= of_place ? 1 : 0;
    turned_inside += square <= of_turn ? 1 : 0;
  }

  std::vector<std::string> row(const std::string& name) const {
    const auto count = static_cast<double>(windows);
    return {name, formatted("%.3f", place / count), formatted("%.0f %%", 100 * static_cast<double>(inside) / count),
            formatted("%.3f", heading / count), formatted("%.0f %%", 100 * static_cast<double>(turned_inside) / count)};
  }
};

void add_drift_scores(const Drift& drift, const OdometryModel& before, Report& report) {
  const std::vector<Group> blocks = drift_blocks_of(drift.windows);
  std::vector<std::size_t> fold_of(drift.windows.size());
  for (std::size_t block = 0; block < blocks.size(); ++block)
    for (const std::size_t i : blocks[block])
      fold_of[i] = (drift.recordings.size() > 1 ? drift.windows[i].recording : block) % kOdometryFolds;
  HeldOutDrift fitted, default_one;
  for (std::size_t fold = 0; fold < kOdometryFolds; ++fold) {
    std::vector<DriftWindow> others;
    for (std::size_t i = 0; i < fold_of.size(); ++i)
      if (fold_of[i] != fold) others.push_back(drift.windows[i]);
    if (others.size() == fold_of.size() || others.size() < kFewestWindows) continue;
    OdometryModel model = fit_drift(others, drift.recordings.size()).model;
    if (!std::isfinite(model.bias)) model.bias = before.bias;
    for (std::size_t i = 0; i < fold_of.size(); ++i) {
      if (fold_of[i] != fold) continue;
      fitted.add(model, drift.windows[i]);
      default_one.add(before, drift.windows[i]);
    }
  }
  if (fitted.windows == 0) return;
  report.results.push_back(
      {.title = "Windows held out: negative logarithm of the density (less is better), share within one deviation",
       .head = {"model", "place", "inside (39 %)", "turn", "inside (68 %)"},
       .rows = {fitted.row("fitted to the other recordings"), default_one.row("models so far")}});
  const auto count = static_cast<double>(fitted.windows);
  report.scores = {{"place_log_loss", fitted.place / count},
                   {"place_log_loss_before", default_one.place / count},
                   {"heading_log_loss", fitted.heading / count},
                   {"heading_log_loss_before", default_one.heading / count}};
}

void add_drift_notes(const Drift& drift, const OdometryFit& fit, Report& report) {
  const DriftLosses& losses = drift.losses;
  report.notes.push_back(formatted(
      "%zu windows of a walk, %zu of a robot that stands. A displacement in the truth is wrong by %.3f m on each "
      "axis, a turn by %.3f rad; both are taken off",
      count_walk_windows(drift.windows), drift.windows.size() - count_walk_windows(drift.windows),
      fit.model.place_error, fit.model.heading_error));
  if (losses.lying + losses.carried + losses.crowded + losses.unseen + losses.damaged > 0)
    report.notes.push_back(
        formatted("moments left out: %zu beside another robot, %zu lying or getting up, %zu penalised or carried, %zu "
                  "without truth, %zu damaged",
                  losses.crowded, losses.lying, losses.carried, losses.unseen, losses.damaged));
  const auto errors = place_errors(drift.windows, fit.walking);
  std::size_t bad = 0;
  for (const SquaredError& error : errors)
    bad += error.squares > kDriftOutlier * kDriftOutlier * fit.place.variance_of(error) ? 1 : 0;
  if (bad > 0)
    report.notes.push_back(
        formatted("%zu windows are more than %.1f standard deviations off and hardly count", bad, kDriftOutlier));
}

Table table_of_windows(const Drift& drift) {
  Table table{.columns = {"time [s]", "duration [s]", "way [m]", "turned [rad]", "true x [m]", "true y [m]",
                          "error x [m]", "error y [m]", "true turn [rad]", "error of the turn [rad]"},
              .names = drift.recordings,
              .rows = {}};
  for (const DriftWindow& window : drift.windows)
    table.rows.push_back(
        {.recording = window.recording,
         .values = {window.at, window.duration, window.way, window.turned, window.true_x, window.true_y, window.error_x,
                    window.error_y, window.true_turn, window.error_turn}});
  return table;
}

}  // namespace

std::vector<RootInterval> noise_intervals(const Drift& drift, const OdometryFit& fit) {
  const std::vector<Group> blocks = drift_blocks_of(drift.windows);
  const auto place = root_intervals(place_errors(drift.windows, fit.walking), blocks, 2, fit.place);
  const auto heading = root_intervals(heading_errors(drift.windows, fit.turning), blocks, 3, fit.heading);
  return {place[0], heading[0], heading[1]};
}

Drift read_drift(const Evidence& evidence, std::vector<std::string>& problems) {
  Drift drift;
  std::size_t with_odometry = 0, with_heading = 0;
  for (const WatchedRobot& robot : evidence.robots) {
    const WatchedMotion motion = read_motion(robot, {.odometry = true});
    with_odometry += motion.odometry.empty() ? 0 : 1;
    with_heading += motion.truth.empty() ? 0 : 1;
    if (!motion.odometry.empty() && !motion.truth.empty()) add_drift(motion, drift);
  }
  if (evidence.robots.empty())
    problems.emplace_back("localisation.bias and its noises: expected a robot beside the truth, got 0");
  else if (with_heading == 0)
    problems.emplace_back("localisation.bias and its noises: expected the robots' headings in the truth, got 0");
  else if (with_odometry == 0)
    problems.emplace_back("localisation.bias and its noises: expected a recording with odometry, got 0");
  return drift;
}

Report odometry_report(const Drift& drift, const sim::Models& base) {
  Report report{.name = "odometry", .title = "How the robots' odometry drifts"};
  const std::size_t walked = count_walk_windows(drift.windows);
  if (walked < kFewestWindows) {
    report.kept.push_back(
        formatted("localisation.translation_noise, rotation_noise, rotation_per_metre and bias: "
                  "expected at least %zu windows of a walk that nobody disturbs, got %zu",
                  kFewestWindows, walked));
    report.needs.push_back(need_of(kTranslation.name, "windows", walked, kFewestWindows, kWalkAdvice));
    return report;
  }
  const OdometryFit fit = fit_drift(drift.windows, drift.recordings.size());
  const OdometryModel before = odometry_model_of(base.perception.localisation, fit.model);
  add_noise_figures(drift, fit, report);
  add_bias_figure(drift, fit, report);
  add_place_picture(drift, fit, before, report);
  add_heading_picture(drift, fit, before, report);
  add_scale_picture(fit, report);
  add_scale_results(drift, fit, report);
  add_drift_scores(drift, before, report);
  add_drift_notes(drift, fit, report);
  report.tables.emplace_back("odometry", table_of_windows(drift));
  return report;
}

Report fit_odometry(const Evidence& evidence, const sim::Models& base) {
  std::vector<std::string> problems;
  const Drift drift = read_drift(evidence, problems);
  if (problems.empty()) return odometry_report(drift, base);
  Report report{.name = "odometry", .title = "How the robots' odometry drifts"};
  report.kept = std::move(problems);
  report.needs.push_back(need_of(kTranslation.name, "windows", 0, kFewestWindows, kWalkAdvice));
  return report;
}

}  // namespace robot::fit
