// Cells of CSV files (RFC 4180).
#pragma once

#include <string>

namespace robot {

/// Returns the text as a cell: in quotes if a comma, a quote or a line end is in it.
inline std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string all = "\"";
  for (const char c : text) all.append(c == '"' ? 2 : 1, c);
  return all + "\"";
}

}  // namespace robot
