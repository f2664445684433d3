// The page of foresight-lab fit.
#include <algorithm>
#include <cmath>

#include "robot/app/fit/fits.h"
#include "robot/app/fit/report_page.h"
#include "robot/core/text.h"
#include "sim/report/page.h"
#include "sim/report/plot.h"

namespace robot::app {
namespace {

using sim::report::escaped, sim::report::Plot;

const std::string kStyle = std::string(kMarkStyle) + R"(
h2 { font-size: 19px; margin: 30px 0 8px; } p { max-width: 75ch; }
.plots { display: grid; gap: 14px; grid-template-columns: repeat(auto-fill, minmax(min(100%, 440px), 1fr)); }
.tables { display: grid; gap: 0 14px; grid-template-columns: repeat(auto-fit, minmax(min(100%, 440px), 1fr)); align-items: start; }
figure { margin: 0; } figcaption { font-size: 13.5px; color: var(--soft); margin: 4px 0; } figcaption b { color: var(--ink); }
svg { display: block; width: 100%; height: auto; }
.grid { stroke: var(--line); } .tick, .axis, .label { fill: var(--soft); font-size: 12px; }
.tick.y { text-anchor: end; } .tick.x, .axis { text-anchor: middle; }
.wide { overflow-x: auto; margin-top: 14px; } .whole { grid-column: 1 / -1; } td, th { text-align: right; padding: 4px 0 4px 16px; white-space: nowrap; }
td:first-child, th:first-child { text-align: left; padding-left: 0; }
ul { padding-left: 20px; margin: 6px 0; } tr.loose td { color: var(--soft); }
nav { display: flex; flex-wrap: wrap; gap: 4px 16px; margin: 8px 0 0; } a { color: var(--blue); }
)";

using Points = std::vector<std::pair<double, double>>;

std::string figure_of(const std::string& svg, const std::string& caption) {
  return "<figure class=\"card\"><figcaption>" + caption + "</figcaption>" + svg + "</figure>\n";
}

constexpr const char* kDistanceKeys =
    "<span class=\"key truth\"></span>truth<span class=\"key robot\"></span>the robot's vision"
    "<span class=\"key line fitted\"></span>fitted, with its 95 % band";

/// Draws the distance over the radius: figure 11 of the thesis.
std::string curve_plot(const fit::BallDistance& fit) {
  double top = 0;
  Points truth, believed, fitted, power;
  for (const fit::BallSize& size : fit.seen.sizes) {
    top = std::max(top, size.distance);
    truth.emplace_back(size.radius, size.distance);
    believed.emplace_back(size.radius, size.believed);
  }
  std::vector<double> radii, low, high;
  for (const fit::CurvePoint& point : fit.curve) {
    radii.push_back(point.radius);
    low.push_back(point.low);
    high.push_back(point.high);
    fitted.emplace_back(point.radius, point.distance);
    power.emplace_back(point.radius, fit.power_law.distance(point.radius));
  }
  Plot plot(0, 1.02 * fit.most_radius, 0, 1.1 * top);
  plot.band("fitted", radii, low, high);
  plot.dots("robot", thinned(believed));
  plot.dots("truth", thinned(truth));
  plot.line("other", power);
  plot.line("fitted", fitted);
  return figure_of(
      plot.svg("distance of the ball over its radius", "radius in the image [px of 640]"),
      std::string("Distance [m] over the radius.") + kDistanceKeys + "<span class=\"key line other\"></span>power law");
}

/// Draws what the robot and the curve say over what is true.
std::string truth_plot(const fit::BallDistance& fit) {
  double most = 0;
  Points believed, fitted;
  for (const fit::BallSize& size : fit.seen.sizes) {
    most = std::max(most, size.distance);
    believed.emplace_back(size.distance, size.believed);
    fitted.emplace_back(size.distance, fit.pinhole.distance(size.radius));
  }
  Plot plot(0, 1.05 * most, 0, 1.1 * most);
  plot.line("even", {{0, 0}, {1.05 * most, 1.05 * most}});
  plot.dots("robot", thinned(believed));
  plot.dots("truth", thinned(fitted));
  return figure_of(plot.svg("estimated over true distance", "true distance [m]"),
                   "Estimated distance [m] over the truth; on the line nothing is wrong."
                   "<span class=\"key robot\"></span>the robot's vision<span class=\"key truth\"></span>fitted curve");
}

std::string held_out_table(const fit::BallDistance& fit) {
  const auto curves = fit::by_curve(fit.held_out);
  std::string text = "<div class=\"card wide\"><table>\n<tr><th>mean error [cm] at</th>";
  for (const fit::HeldOut& bin : curves.front()) text += "<th>" + range_of(bin) + (bin.is_whole ? "" : " m") + "</th>";
  text += "<th>median</th><th>95 %</th><th>bias</th></tr>\n";
  for (const std::vector<fit::HeldOut>& bins : curves) {
    const fit::HeldOut& all = bins.front();
    text += "<tr><td>" + escaped(all.curve) + "</td>";
    for (const fit::HeldOut& bin : bins)
      text += formatted("<td title=\"%zu images\">%.1f</td>", bin.errors.samples, 100 * bin.errors.mean);
    text += formatted("<td>%.1f</td><td>%.1f</td><td>%+.1f</td></tr>\n", 100 * all.errors.median, 100 * all.errors.p95,
                      100 * all.bias);
  }
  return text + "</table></div>\n";
}

std::string part_of(const fit::BallDistance& fit) {
  return "<h2 id=\"ball_distance\">Distance of the ball from its size</h2>\n<div class=\"plots\">\n" + curve_plot(fit) +
         truth_plot(fit) + "</div>\n" +
         formatted(
             "<p class=\"soft\">Errors on images held out, %s. %zu images: left out were %zu without truth, %zu cut by "
             "the border, %zu damaged and %zu like others of their pass.</p>\n",
             fit.parts.c_str(), fit.seen.sizes.size(), fit.seen.without_truth, fit.seen.cut, fit.seen.damaged,
             fit.seen.thinned) +
         held_out_table(fit);
}

/// The bars of a histogram, from 0 to `most`.
struct Bars {
  double most;
  int bars;
  const char* unit;  // of the counts: "rolls"
};

/// Draws how often values lie in each bar. Values beyond the bars are left out.
std::string histogram(const std::vector<double>& values, const Bars& bars, const std::string& about,
                      const std::string& x_label) {
  const double width = bars.most / bars.bars;
  std::vector<int> counts(static_cast<std::size_t>(bars.bars));
  for (const double value : values)
    if (value >= 0 && value < bars.most) ++counts[static_cast<std::size_t>(value / width)];
  Plot plot(0, bars.most, 0, 1.1 * *std::ranges::max_element(counts));
  for (int i = 0; i < bars.bars; ++i)
    if (const int count = counts[static_cast<std::size_t>(i)]; count > 0)
      plot.bar("truth", i * width, (i + 1) * width, count, formatted("%d %s", count, bars.unit));
  return plot.svg(about, x_label);
}

std::string part_of(const fit::Rolling& fit) {
  const fit::Figure& figure = fit.deceleration;
  Points rolls;
  for (const fit::Roll& roll : fit.rolls) rolls.emplace_back(roll.speed, roll.deceleration);
  Plot plot(0, 1.05 * figure.domain.to, 0, 3 * figure.value);
  plot.band("fitted", {0, 1.05 * figure.domain.to}, {figure.low, figure.low}, {figure.high, figure.high});
  plot.dots("truth", thinned(rolls));
  plot.line("fitted", {{0, figure.value}, {1.05 * figure.domain.to, figure.value}});
  std::vector<double> decelerations;
  for (const fit::Roll& roll : fit.rolls) decelerations.push_back(roll.deceleration);
  const std::string bars = histogram(decelerations, {.most = 3 * figure.value, .bars = 24, .unit = "rolls"},
                                     "free rolls by deceleration", "deceleration [m/s²]");
  return "<h2 id=\"rolling\">How the turf slows the ball</h2>\n<div class=\"plots\">\n" +
         figure_of(plot.svg("deceleration of free rolls over speed", "speed at the begin [m/s]"),
                   "Deceleration [m/s²].<span class=\"key truth\"></span>a free roll<span class=\"key line "
                   "fitted\"></span>fitted, "
                   "with its 95 % band") +
         figure_of(bars, "Number of free rolls.") + "</div>\n";
}

/// Draws where the kicked balls would come to rest: ahead and to the left of the foot, mirrored for the right one.
std::string landing_plot(const fit::KickFit& kick) {
  const double range = kick.figures.front().value, mean = kick.model.speed;
  Points landed;
  double farthest = range, widest = range / 4;
  for (const fit::TrackedKick& one : kick.kicks) {
    const double way = range * one.speed * one.speed / (mean * mean);
    landed.emplace_back(way * std::cos(one.direction), way * std::sin(one.direction));
    farthest = std::max(farthest, landed.back().first);
    widest = std::max(widest, std::abs(landed.back().second));
  }
  Plot plot(std::min(0., -0.2 * farthest), 1.05 * farthest, -1.1 * widest, 1.1 * widest);
  plot.line("even", {{0, 0}, {1.05 * farthest, 1.05 * farthest * std::tan(kick.model.direction)}});
  plot.dots("truth", thinned(landed));
  return figure_of(plot.svg("landing points of the kick " + escaped(kick.kind), "ahead of the foot [m]"),
                   "Where " + escaped(kick.kind) + " lands [m], to the left upwards; right foot mirrored.");
}

std::string speed_plot(const fit::KickFit& kick) {
  std::vector<double> speeds;
  for (const fit::TrackedKick& one : kick.kicks) speeds.push_back(one.speed);
  const double most = 1.05 * *std::ranges::max_element(speeds);
  return figure_of(histogram(speeds, {.most = most, .bars = 20, .unit = "kicks"},
                             "speeds of the kick " + escaped(kick.kind), "speed of the ball [m/s]"),
                   formatted("Number of kicks; a full hit of the mean range has %.2f m/s.", kick.model.speed));
}

std::string part_of(const fit::Kicks& kicks) {
  std::string text = "<span id=\"kicks\"></span>";
  for (const fit::KickFit& kick : kicks.fits)
    text +=
        "<h2>Kick " + escaped(kick.kind) + "</h2>\n<div class=\"plots\">\n" + landing_plot(kick) + speed_plot(kick) +
        formatted(
            "</div>\n<p class=\"soft\">%zu kicks in place that nobody disturbs; left out were %zu out of place, %zu "
            "disturbed and %zu missed. On kicks held out, %.0f %% land in the region of 90 %%; the landing distance "
            "has a CRPS of %.2f m, a constant %.2f m.</p>\n",
            kick.kicks.size(), kick.out_of_place, kick.disturbed, kick.missed, 100 * kick.covered, kick.crps,
            kick.constant_error);
  return text;
}

std::string figures_table(const Fits& fits) {
  std::string text =
      "<h2 id=\"figures\">All figures</h2>\n<div class=\"card wide\"><table>\n<tr><th>figure</th><th>value</th><th>95 "
      "%</th><th>unit</th><th>events</th><th>recordings</th><th>valid for</th></tr>\n";
  for (const fit::Figure& figure : fits.figures())
    text += formatted(
        "<tr%s><td>%s</td><td>%.4g</td><td>%.4g .. %.4g</td><td>%s</td><td>%zu %s</td><td title=\"%s\">%zu</td>"
        "<td>%s %.2f .. %.2f %s</td></tr>\n",
        figure.is_known() ? "" : " class=\"loose\" title=\"known too loosely: the models keep theirs\"",
        escaped(figure.name).c_str(), figure.value, figure.low, figure.high, escaped(figure.unit).c_str(),
        figure.events, escaped(figure.kind).c_str(), escaped(joined(figure.recordings, ", ")).c_str(),
        figure.recordings.size(), escaped(figure.domain.quantity).c_str(), figure.domain.from, figure.domain.to,
        escaped(figure.domain.unit).c_str());
  return text + "</table></div>\n";
}

/// Returns the names of all recordings behind the figures, each once.
std::vector<std::string> recordings_of(const Fits& fits) {
  std::vector<std::string> names;
  for (const fit::Figure& figure : fits.figures())
    for (const std::string& name : figure.recordings)
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

/// Returns the title: how much was fitted.
std::string headline_of(const Fits& fits) {
  const auto figures = fits.figures();
  if (figures.empty()) return "The recordings carry no model";
  const auto known = std::ranges::count_if(figures, [](const fit::Figure& figure) { return figure.is_known(); });
  return formatted("%zu figures fitted, %td of them known well", figures.size(), known);
}

/// Returns links to the parts of the page.
std::string links_to(const std::vector<std::pair<std::string, std::string>>& parts) {
  std::string links = "<nav>";
  for (const auto& [name, title] : parts)
    links += formatted("<a href=\"#%s\">%s</a>", name.c_str(), escaped(title).c_str());
  return links + "</nav>\n";
}

std::string list_of(const std::string& title, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string text = "<h2>" + title + "</h2>\n<ul>\n";
  for (const std::string& sentence : sentences) text += "<li>" + escaped(sentence) + "</li>\n";
  return text + "</ul>\n";
}

}  // namespace

std::string page_of_check(const fit::Report& report, const std::string& base) {
  const bool is_good =
      std::ranges::find(report.scores, std::pair<std::string, double>("outside", 0)) != report.scores.end();
  const std::string body =
      std::string("<h1>") +
      (is_good ? "The models agree with the recordings" : "The models differ from the recordings") +
      "</h1>\n<p class=\"soft\">Checked: " + escaped(base) + "</p>\n" + part_of(report);
  return sim::report::html_page("Checked models", kStyle.c_str(), body);
}

std::string page_of(const Fits& fits) {
  std::vector<std::pair<std::string, std::string>> parts;
  std::string shown;
  const auto show = [&](const std::string& name, const std::string& title, const std::string& part) {
    parts.emplace_back(name, title);
    shown += part;
  };
  if (fits.ball_distance) show("ball_distance", "Distance of the ball from its size", part_of(*fits.ball_distance));
  for (const fit::Report& report : fits.reports)
    if (!report.pictures.empty()) show(report.name, report.title, part_of(report));
  if (fits.rolling) show("rolling", "How the turf slows the ball", part_of(*fits.rolling));
  if (fits.kicks) show("kicks", "How kicks send the ball", part_of(*fits.kicks));
  parts.emplace_back("figures", "All figures");
  std::string body = "<h1>" + headline_of(fits) + "</h1>\n" + links_to(parts) + shown;
  if (!fits.empty()) body += figures_table(fits);
  body += list_of("Kept as it was", fits.kept) + list_of("Recordings left out", fits.left_out) +
          list_of("Recordings", recordings_of(fits));
  return sim::report::html_page("Fitted models", kStyle.c_str(), body);
}

}  // namespace robot::app
