// Lines from a terminal, with history and completion; or from a pipe or a file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim::app {

/// Reads lines from standard input. There is one at a time, because the library keeps its state in globals.
class LineEditor {
 public:
  using Complete = std::function<std::vector<std::string>(std::string_view line)>;

  /// `complete` returns the words that can end a line with that beginning.
  explicit LineEditor(Complete complete);
  ~LineEditor();
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;

  /// Returns the next line without its end, or nothing at the end of the input. A prompt is shown on a terminal only.
  std::optional<std::string> read(const std::string& prompt);

  /// Reports whether a person types the lines.
  bool is_terminal() const { return is_terminal_; }

 private:
  const bool is_terminal_;
};

}  // namespace sim::app
