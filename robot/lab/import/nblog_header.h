// The text at the head of an nblog file: S-expressions, such as (nblog (version 7) (contents (...) (...))).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/core/result.h"

namespace robot::lab::nblog {

/// An atom ("7", "a text") or a list.
struct Expression {
  std::string atom;               // of an atom; without its quotation marks
  std::vector<Expression> items;  // of a list
  bool is_list = false;

  /// The second item of the list among `items` that begins with the atom `key`: (key value). Null without one.
  const Expression* find(std::string_view key) const;

  /// The number that find(`key`) holds; nothing without one.
  std::optional<double> number(std::string_view key) const;
};

/// One expression, alone in `text`. At most 16 deep.
Result<Expression> parse_expression(std::string_view text);

}  // namespace robot::lab::nblog
