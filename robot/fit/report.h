// A fit as its readers see it: figures, pictures, results, and the recordings that it still needs.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "robot/fit/figure.h"
#include "robot/fit/text_plot.h"

namespace robot::fit {

/// Things that are drawn in one picture and mean the same.
struct Mark {
  enum class Shape {
    dots,  // at (x, y)
    line,  // through (x, y)
    band,  // from y up to `high`
    bars,  // from x to x + `width`, up to y
  };
  /// The meaning, which sets the colour on a page and the sign in a terminal.
  enum class Role {
    truth,   // observations, or what is true: '.'
    robot,   // the robot's own view: 'o'
    fitted,  // '#'
    other,   // something to compare with: '-'
  };

  Shape shape = Shape::dots;
  Role role = Role::truth;
  std::string label;         // for the key; empty: not in it
  std::vector<double> x, y;  // of equal length
  std::vector<double> high;  // of a band: as long as x
  double width = 0;          // of bars
};

struct Picture {
  std::string title;             // "Deceleration of free rolls over their speed"
  std::string x_label, y_label;  // with the unit: "speed at the begin [m/s]"
  TextPlot::Axes axes;
  std::vector<Mark> marks;  // the first is drawn first
};

/// Results in rows, such as scores on recordings held out.
struct Results {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  // as long as `head`

  /// Reports whether a column has words, by its first row. The others have numbers.
  bool has_words(std::size_t column) const;
};

/// The state of one figure, or of one range of a curve: what is still to be recorded.
struct Need {
  std::string figure;      // "ball.deceleration", "ball distance at 1.0-2.0 m"
  std::string kind;        // of the events: "free rolls"
  std::size_t events = 0;  // recorded
  double loose = 0;        // half the 95 % interval [unit]; 0: not known yet
  double wanted = 0;       // half the interval that is enough [unit]
  std::string unit = "%";  // "%": a share of the value
  std::size_t more = 0;    // events that are still missing; 0: enough
  std::string advice;      // how to record them; empty if there are enough
};

/// Returns the need of a fitted figure: an interval shrinks with the square root of the events.
Need need_of(const Figure& figure, double wanted, const std::string& advice);

/// Returns the need of a figure that cannot be fitted yet, of `enough` events.
Need need_of(const std::string& figure, const std::string& kind, std::size_t events, std::size_t enough,
             const std::string& advice);

/// One fit.
struct Report {
  std::string name;   // for --only: "rolling"
  std::string title;  // "How the turf slows the ball"
  std::vector<Figure> figures;
  std::vector<Picture> pictures;
  std::vector<Results> results;
  std::vector<std::string> notes;                      // sentences about the observations
  std::vector<std::string> kept;                       // sentences about models that stay as they are, with the reason
  std::vector<std::pair<std::string, Table>> tables;   // the observations, by the name of their file
  std::vector<std::pair<std::string, double>> scores;  // for --json: {"log_loss", 0.31}
  std::vector<Need> needs;

  /// Reports whether nothing could be fitted.
  bool empty() const { return figures.empty(); }
  /// Returns the figure with that name, or null.
  const Figure* figure(const std::string& figure_name) const;
};

/// Formats a picture for a terminal.
std::string to_text(const Picture& picture);
/// Formats a report for a terminal: the first picture, the figures, the results, the notes.
std::string to_text(const Report& report);

}  // namespace robot::fit
