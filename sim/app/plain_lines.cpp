// The line editor of machines without its library: plain lines.
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <utility>

#include "sim/app/line_editor.h"

namespace sim::app {

LineEditor::LineEditor(Complete) : is_terminal_(isatty(STDIN_FILENO) != 0) {}

LineEditor::~LineEditor() = default;

std::optional<std::string> LineEditor::read(const std::string& prompt) {
  if (is_terminal_) std::fputs(prompt.c_str(), stdout), std::fflush(stdout);
  std::string line;
  return std::getline(std::cin, line) ? std::optional(std::move(line)) : std::nullopt;
}

}  // namespace sim::app
