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
  std::string atom;               // of an atom, without quotation marks
  std::vector<Expression> items;  // of a list
  bool is_list = false;

  /// Returns the second item of the first list in `items` that begins with the atom `key`: (key value). Null if absent.
  const Expression* find(std::string_view key) const;

  /// Returns the number in find(`key`), or nothing if there is none.
  std::optional<double> number(std::string_view key) const;
};

/// Parses one expression, which must be the whole `text` and at most 16 levels deep.
Result<Expression> parse_expression(std::string_view text);

}  // namespace robot::lab::nblog
