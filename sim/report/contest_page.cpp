#include "sim/report/contest_page.h"

#include <algorithm>
#include <cmath>

#include "robot/core/json_library.h"
#include "robot/core/text.h"
#include "sim/report/contest_report.h"
#include "sim/report/page.h"
#include "sim/report/plot.h"

namespace sim::report {
namespace {

using robot::formatted;

constexpr const char* kContestStyle = R"(
:root { --b: var(--blue); --a: #b8500a; --even: #9aa3b0; --code: #eef1f5; }
@media (prefers-color-scheme: dark) { :root { --a: #f0974f; --even: #5f6978; --code: #222934; } }
h2 { font-size: 15px; margin: 0; } h2 + p { margin: 2px 0 8px; color: var(--soft); font-size: 13.5px; }
.chip { display: inline-block; padding: 2px 12px; border-radius: 99px; font-weight: 600; font-size: 13.5px;
  color: var(--card); background: var(--open); }
.chip.better { background: var(--good); } .chip.not-better { background: var(--bad); }
.chip.identical { background: var(--soft); }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr)); gap: 12px; margin: 22px 0 16px; }
.facts b { display: block; font-size: 23px; line-height: 1.25; font-weight: 650; white-space: nowrap; }
.facts .card { padding: 11px 15px; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 460px), 1fr)); gap: 16px; }
.wide { grid-column: 1 / -1; }
svg { display: block; width: 100%; height: auto; overflow: visible; }
svg text { font: 12px system-ui, "DejaVu Sans", sans-serif; fill: var(--soft); font-variant-numeric: tabular-nums; }
.tick.y { text-anchor: end; } .tick.x, .axis { text-anchor: middle; } .grid { stroke: var(--line); }
polyline { fill: none; stroke-width: 2; stroke-linejoin: round; }
.path, .mean { stroke: var(--b); } circle.end { fill: var(--b); stroke: none; }
.interval { fill: var(--b); opacity: .16; } .zero { stroke: var(--soft); } .up { stroke: var(--good); }
.down { stroke: var(--bad); } .up, .down, .goal { stroke-dasharray: 5 4; stroke-width: 1.5; } .goal { stroke: var(--soft); }
.for-b { fill: var(--b); } .for-a { fill: var(--a); } .for-none { fill: var(--even); }
.split { display: flex; gap: 2px; height: 30px; margin: 10px 0 6px; border-radius: 6px; overflow: hidden; }
.split span { background: var(--even); min-width: 1px; } .split .b { background: var(--b); } .split .a { background: var(--a); }
.split .half { opacity: .55; }
td, th { padding: 4px 10px 4px 0; text-align: right; vertical-align: top; }
td:first-child, th:first-child { text-align: left; color: var(--soft); }
th.a { color: var(--a); } th.b { color: var(--b); }
.keys td { text-align: left; overflow-wrap: anywhere; } .keys td:first-child { white-space: nowrap; width: 1%; padding-right: 22px; }
.scroll { overflow-x: auto; } code { font: 12.5px/1.5 ui-monospace, "DejaVu Sans Mono", monospace; }
.replay td { text-align: left; } .replay td:first-child { text-align: right; font-weight: 600; padding-right: 16px; width: 1%; }
.replay code { display: block; background: var(--code); border-radius: 6px; padding: 5px 9px; margin: 2px 0; overflow-wrap: anywhere;
  user-select: all; }
.replay a { color: var(--b); }
.gain-b { color: var(--b) !important; } .gain-a { color: var(--a) !important; }
)";

double number(const Json& json) { return json.is_number() ? json.get<double>() : NAN; }

/// Returns a figure marked with its key in the JSON, so that tests can compare the two.
std::string figure(const char* key, const char* format, const Json& value) {
  const std::string shown = value.is_number() ? formatted(format, value.get<double>()) : "–";
  return formatted("<span data-of=\"%s\">%s</span>", key, shown.c_str());
}

std::string interval(const char* key, const Json& gain) {
  const std::string of = key;
  return figure((of + ".low").c_str(), "%+.3f", gain.at("low")) + " … " +
         figure((of + ".high").c_str(), "%+.3f", gain.at("high"));
}

std::string card(const std::string& title, const std::string& about, const std::string& content,
                 const char* style = "") {
  return formatted("<section class=\"card %s\"><h2>", style) + title + "</h2><p>" + about + "</p>\n" + content +
         "</section>\n";
}

std::string fact(const std::string& value, const std::string& about) {
  return "<div class=\"card\"><b>" + value + "</b><span class=\"soft\">" + about + "</span></div>\n";
}

std::string unit_of(const Json& report) {
  const std::string metric = report.at("run").at("metric");
  if (metric == "goals") return "goals per game";
  if (metric == "conceded") return "fewer conceded goals per game";
  if (metric == "ball_advance") return "metres of the ball's way per game";
  return metric == "first_goal" ? "of the first goal" : "of scoring in time";
}

std::string verdict_plot(const Json& report) {
  const double low = report.at("bounds").at(0), high = report.at("bounds").at(1);
  double bottom = low, top = high;
  std::vector<std::pair<double, double>> path = {{0, 0}};
  for (const Json& mark : report.at("marks")) {
    if (!mark.at(2).is_number()) continue;
    path.emplace_back(mark.at(0).get<double>(), mark.at(2).get<double>());
    bottom = std::min(bottom, path.back().second), top = std::max(top, path.back().second);
  }
  const double room = 0.12 * (top - bottom);
  Plot plot(0, path.back().first, bottom - room, top + room);
  plot.level("zero", 0, "");
  plot.level("up", high, formatted("better by %.3g: %+.2f", number(report.at("h1")), high));
  plot.level("down", low, formatted("better by %.3g at most: %+.2f", number(report.at("h0")), low), Plot::Label::below);
  plot.line("path", path);
  return plot.svg("the log-likelihood ratio over the pairs played, and the bounds of the test", "pairs of games");
}

std::string mean_plot(const Json& report) {
  std::vector<std::pair<double, double>> mean;
  std::vector<double> pairs, low, high;
  double largest = number(report.at("h1"));
  for (const Json& mark : report.at("marks")) {
    if (!mark.at(3).is_number()) continue;
    mean.emplace_back(mark.at(0).get<double>(), mark.at(1).get<double>());
    pairs.push_back(mark.at(0)), low.push_back(mark.at(3)), high.push_back(mark.at(4));
  }
  if (mean.empty()) return "";
  // the first few intervals are too wide for the scale
  const std::size_t settled = std::min(mean.size() - 1, mean.size() / 8);
  double bottom = 0;
  for (std::size_t i = settled; i < mean.size(); ++i)
    largest = std::max(largest, high[i]), bottom = std::min(bottom, low[i]);
  const double room = 0.08 * (largest - bottom);
  Plot plot(0, mean.back().first, bottom - room, largest + room);
  plot.band("interval", pairs, low, high);
  plot.level("zero", 0, "");
  plot.level("goal", number(report.at("h1")), formatted("asked for: %+.3g", number(report.at("h1"))));
  plot.line("mean", mean);
  return plot.svg("the mean gain over the pairs played, with its 95 % interval", "pairs of games");
}

std::string histogram_plot(const Json& report) {
  const Json& histogram = report.at("histogram");
  const double from = histogram.at("from"), column = histogram.at("column");
  const auto counts = histogram.at("pairs").get<std::vector<double>>();
  // only the columns that hold pairs, and the same number on both sides
  std::size_t middle = counts.size() / 2, reach = 2;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) reach = std::max(reach, i > middle ? i - middle : middle - i);
  const double edge = (static_cast<double>(reach) + 0.5) * column;
  Plot plot(-edge, edge, 0, 1.08 * *std::ranges::max_element(counts));
  for (std::size_t i = middle - reach; i <= middle + reach; ++i) {
    const double at = from + static_cast<double>(i) * column;
    const char* style = at > 0 ? "for-b" : at < 0 ? "for-a" : "for-none";
    plot.bar(style, at - column / 2, at + column / 2, counts[i], formatted("%+g: %.0f pairs", at, counts[i]));
  }
  return plot.svg("how many pairs ended with which gain of B over A", "gain of B in both games of a pair");
}

std::string split_bar(const std::vector<double>& shares, const std::vector<const char*>& styles) {
  std::string all = "<div class=\"split\" aria-hidden=\"true\">";
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (shares[i] > 0) all += formatted("<span class=\"%s\" style=\"flex:%g\"></span>", styles[i], shares[i]);
  return all + "</div>\n";
}

std::string results(const Json& report) {
  const auto points = report.at("b_points_of_pairs").get<std::vector<double>>();
  const auto games = report.at("b_won_drawn_lost").get<std::vector<double>>();
  std::string all = split_bar({games[0], games[1], games[2]}, {"b", "", "a"});
  all += "<p>games: B won " + figure("b_won_drawn_lost.0", "%.0f", games[0]) + ", drew " +
         figure("b_won_drawn_lost.1", "%.0f", games[1]) + ", lost " + figure("b_won_drawn_lost.2", "%.0f", games[2]) +
         "</p>";
  all += split_bar({points[4], points[3], points[2], points[1], points[0]}, {"b", "b half", "", "a half", "a"});
  all += "<p>pairs by B's points: ";
  for (int i = 4; i >= 0; --i)
    all += formatted("%d: ", i) +
           figure(formatted("b_points_of_pairs.%d", i).c_str(), "%.0f", points[static_cast<std::size_t>(i)]) +
           (i > 0 ? " · " : "");
  return all + "</p>\n";
}

std::string goals_table(const Json& report) {
  const Json &run = report.at("run"), &a = report.at("a"), &b = report.at("b");
  std::string all = "<div class=\"scroll\"><table><tr><th></th><th class=\"a\">A: " + escaped(run.at("a")) +
                    "</th><th class=\"b\">B: " + escaped(run.at("b")) + "</th></tr>\n";
  const auto row = [&](const char* what, const std::string& of_a, const std::string& of_b) {
    all += formatted("<tr><td>%s</td><td>", what) + of_a + "</td><td>" + of_b + "</td></tr>\n";
  };
  row("goals for, per game", figure("a.goals", "%.3f", a.at("goals")), figure("b.goals", "%.3f", b.at("goals")));
  row("goals against, per game", figure("a.conceded", "%.3f", a.at("conceded")),
      figure("b.conceded", "%.3f", b.at("conceded")));
  row("a decision costs [µs]", figure("decision_us.0", "%.2f", report.at("decision_us").at(0)),
      figure("decision_us.1", "%.2f", report.at("decision_us").at(1)));
  return all + "</table></div>\n";
}

std::string keys(const Json& report) {
  const Json& run = report.at("run");
  std::string all = "<table class=\"keys\">\n";
  const auto row = [&](const std::string& what, const std::string& value) {
    if (!value.empty()) all += "<tr><td>" + escaped(what) + "</td><td>" + value + "</td></tr>\n";
  };
  const auto code = [](const std::string& value) {
    return value.empty() ? value : "<code>" + escaped(value) + "</code>";
  };
  row("rules", code(run.at("rules")));
  row("models", code(run.at("models")) + " – not fitted to robots of yours");
  row("conditions", escaped(run.at("conditions")));
  row("against", code(run.at("vs")));
  row("games begin", run.at("situation").get<std::string>().empty()
                         ? "with the kick-off"
                         : code(run.at("situation")) + (run.at("fuzz") == true ? ", varied" : ""));
  row("changed players", run.at("changed") == 0 ? "" : "1 .. " + run.at("changed").dump());
  row("longest game", run.at("seconds") == 0 ? "" : formatted("%g s", number(run.at("seconds"))));
  row("measured by", code(run.at("metric")));
  row("seeds",
      formatted("%.0f … %.0f", number(run.at("seed")), number(run.at("seed")) + number(report.at("pairs")) - 1));
  row("program", "foresight-sim " + escaped(run.at("version")) + ", games' hash " + code(run.at("build")));
  if (run.contains("files"))
    for (const auto& [file, hash] : run.at("files").items()) row("content of " + file, code(hash));
  row("took", formatted("%.1f s", number(report.at("seconds"))));
  return all + "</table>\n";
}

/// Returns the commands of a pair: to watch its recording, or else to make one.
std::string commands(const Json& pair) {
  const auto code = [](const std::string& command) { return "<code>" + escaped(command) + "</code>"; };
  const std::string game = pair.value("game", "");
  if (game.empty()) return code(pair.at("replay"));
  return "<a href=\"" + escaped(game) + "\">" + escaped(game) + "</a>" + code("foresight-lab play " + game) +
         code(pair.at("replay"));
}

std::string decisive(Json report) {
  std::string all = "<table class=\"replay\">\n";
  for (const Json* pair : shown_pairs(report)) {
    const double gain = number(pair->at("gain"));
    all += formatted("<tr><td class=\"%s\">%+g</td><td>", gain > 0 ? "gain-b" : "gain-a", gain) + commands(*pair) +
           "</td></tr>\n";
  }
  return all + "</table>\n";
}

std::string about_decisive(const Json& report) {
  const bool saved = report.at("decisive").front().contains("game");
  return saved ? "B's gain; the recorded game in which B is at home; and the command that plays it again. The links "
                 "open the viewer if <code>foresight-lab play</code> serves this page."
               : "B's gain, and the command that plays the game in which B is at home; "
                 "<code>foresight-lab play game.mcap</code> shows it.";
}

}  // namespace

std::vector<Json*> shown_pairs(Json& report) {
  constexpr std::size_t kShown = 5;
  std::vector<Json*> pairs;
  for (Json& pair : report.at("decisive")) pairs.push_back(&pair);
  std::ranges::stable_sort(pairs, std::greater<>(),
                           [](const Json* pair) { return std::abs(number(pair->at("gain"))); });
  pairs.resize(std::min(kShown, pairs.size()));
  return pairs;
}

std::string page_of(const Json& report) {
  const std::string sentence = report.at("sentence");
  std::string style = report.at("verdict");
  const std::string verdict = style == "not better" && report.value("worse", false) ? "worse" : style;
  std::ranges::replace(style, ' ', '-');
  // the sentence's figures are shown below
  const std::string headline = sentence.substr(0, sentence.find(": "));
  std::string all = "<header><span class=\"chip " + style + "\">" + escaped(verdict) + "</span>\n<h1>" +
                    escaped(headline) + "</h1>\n<p class=\"soft\" data-of=\"sentence\">" + escaped(sentence) +
                    "</p></header>\n";

  const Json& gain = report.at("gain");
  all += "<div class=\"facts\">\n";
  all += fact(figure("gain.mean", "%+.3f", gain.at("mean")), unit_of(report) + "<br>95 %: " + interval("gain", gain));
  if (report.at("unbiased_gain").is_object())
    all += fact(figure("unbiased_gain.mean", "%+.3f", report.at("unbiased_gain").at("mean")),
                "corrected for the early stop<br>95 %: " + interval("unbiased_gain", report.at("unbiased_gain")));
  all += fact(figure("games", "%.0f", report.at("games")),
              "games in " + figure("pairs", "%.0f", report.at("pairs")) + " pairs,<br>" +
                  figure("different_pairs", "%.0f", report.at("different_pairs")) + " of them different");
  all += fact(figure("pairing_gain", "%.2f", report.at("pairing_gain")),
              "pairing gain: the same interval takes<br>" + games_without_pairs(number(report.at("pairing_gain"))) +
                  " without pairs");
  const Json& home = report.at("home_advantage");
  const bool kick_off = report.at("run").at("situation").get<std::string>().empty();
  all += fact(figure("home_advantage.mean", "%+.3f", home.at("mean")),
              std::string(kick_off ? "home advantage" : "worth of the home side's place") +
                  "<br>95 %: " + interval("home_advantage", home));
  all += "</div>\n<div class=\"plots\">\n";

  all += card("The test",
              "Log-likelihood ratio; without a fixed length the test ends at a bound. Now " +
                  figure("llr", "%+.2f", report.at("llr")) + ".",
              verdict_plot(report));
  all += card("The gain", "Running mean per game, with its 95 % interval.", mean_plot(report));
  all += card("Pairs", "How often B gained how much in the two games of a pair.", histogram_plot(report));
  all +=
      card("Results", "As B sees them: <span class=\"gain-b\">won</span>, drawn, <span class=\"gain-a\">lost</span>.",
           results(report) + goals_table(report));
  if (!report.at("decisive").empty())
    all += card("The most decisive pairs", about_decisive(report), decisive(report), "wide");
  all += card("What this holds for", "The verdict is about these games and no others.", keys(report), "wide");
  return html_page(headline, kContestStyle, all + "</div>\n");
}

}  // namespace sim::report
