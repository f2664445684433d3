#include "robot/lab/import/nblog_header.h"

#include <charconv>
#include <cmath>

namespace robot::lab::nblog {
namespace {

constexpr int kMaxDepth = 16;

constexpr std::string_view kSpace = " \t\r\n";

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Result<Expression> parse() {
    Expression expression;
    if (!read(expression, 0)) return wrong();
    skip_space();
    if (at_ != text_.size()) problem_ = "expected the end of the text";
    if (!problem_.empty()) return wrong();
    return expression;
  }

 private:
  bool read(Expression& expression, int depth) {
    skip_space();
    if (at_ == text_.size()) return fail("expected more text");
    if (text_[at_] == ')') return fail("a list is closed that was never opened");
    if (text_[at_] == '"') return read_quoted(expression);
    if (text_[at_] == '(') return read_list(expression, depth);
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n()\"", at_), text_.size());
    expression.atom = text_.substr(at_, end - at_);
    at_ = end;
    return true;
  }

  bool read_quoted(Expression& expression) {
    const std::size_t end = text_.find('"', at_ + 1);
    if (end == std::string_view::npos) return fail("a quotation mark is never closed");
    expression.atom = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    return true;
  }

  bool read_list(Expression& expression, int depth) {
    if (depth == kMaxDepth) return fail("lists are nested too deep");
    expression.is_list = true;
    ++at_;
    for (skip_space(); at_ < text_.size() && text_[at_] != ')'; skip_space())
      if (!read(expression.items.emplace_back(), depth + 1)) return false;
    if (at_ == text_.size()) return fail("a list is never closed");
    ++at_;
    return true;
  }

  void skip_space() { at_ = std::min(text_.find_first_not_of(kSpace, at_), text_.size()); }

  bool fail(std::string problem) {
    problem_ = std::move(problem);
    return false;
  }

  Error wrong() const { return Error{"at character " + std::to_string(at_) + ": " + problem_}; }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string problem_;
};

}  // namespace

const Expression* Expression::find(std::string_view key) const {
  for (const Expression& item : items)
    if (item.items.size() >= 2 && !item.items[0].is_list && item.items[0].atom == key) return &item.items[1];
  return nullptr;
}

std::optional<double> Expression::number(std::string_view key) const {
  const Expression* value = find(key);
  if (value == nullptr || value->is_list) return std::nullopt;
  double number = 0;
  const char* end = value->atom.data() + value->atom.size();
  const auto [stopped, error] = std::from_chars(value->atom.data(), end, number);
  if (error != std::errc{} || stopped != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

Result<Expression> parse_expression(std::string_view text) { return Parser(text).parse(); }

}  // namespace robot::lab::nblog
