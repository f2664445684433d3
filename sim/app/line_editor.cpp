#include "sim/app/line_editor.h"

// the library's header needs FILE
#include <cstdio>
// clang-format off
#include <editline/readline.h>
// clang-format on
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <utility>

namespace sim::app {
namespace {

LineEditor::Complete g_complete;   // of the only editor
std::vector<std::string> g_words;  // that complete the present word
std::size_t g_next = 0;            // of g_words

/// Returns the next completion as memory of malloc, or nullptr: the library's protocol.
char* next_word(const char*, int state) {
  if (state == 0) g_next = 0;
  return g_next < g_words.size() ? strdup(g_words[g_next++].c_str()) : nullptr;
}

char** complete(const char* word, int, int end) {
  rl_attempted_completion_over = 1;  // no names of files
  g_words = g_complete(std::string_view(rl_line_buffer).substr(0, static_cast<std::size_t>(end)));
  return g_words.empty() ? nullptr : rl_completion_matches(word, next_word);
}

}  // namespace

LineEditor::LineEditor(Complete completions) : is_terminal_(isatty(STDIN_FILENO) != 0) {
  if (!is_terminal_) return;
  g_complete = std::move(completions);
  rl_readline_name = const_cast<char*>("foresight-sim");
  rl_attempted_completion_function = complete;
  using_history();
}

LineEditor::~LineEditor() {
  if (!is_terminal_) return;
  rl_attempted_completion_function = nullptr;
  g_complete = nullptr;
  clear_history();
}

std::optional<std::string> LineEditor::read(const std::string& prompt) {
  std::string line;
  if (!is_terminal_) return std::getline(std::cin, line) ? std::optional(std::move(line)) : std::nullopt;
  char* const typed = readline(prompt.c_str());
  if (!typed) return {};
  line = typed;
  std::free(typed);
  if (!line.empty()) add_history(line.c_str());
  return line;
}

}  // namespace sim::app
