// A value, or a sentence that says why there is none.
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace robot {

/// Why something could not be done: one sentence for the person who must fix it.
/// It tells what, where, what was expected and what came.
struct Error {
  std::string sentence;
};

/// A `T`, or the `Error` that says why there is none. Never throws.
/// `value()` of an error and `error()` of a value are bugs of the caller (asserted).
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

  explicit operator bool() const { return content_.index() == 0; }

  T& value() & { return *get(); }
  const T& value() const& { return *const_cast<Result*>(this)->get(); }
  T&& value() && { return std::move(*get()); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return get(); }
  const T* operator->() const { return const_cast<Result*>(this)->get(); }

  const std::string& error() const {
    assert(!*this && "error() of a Result that holds a value");
    return std::get<1>(content_).sentence;
  }

 private:
  T* get() {
    assert(*this && "value() of a Result that holds an error");
    return std::get_if<0>(&content_);
  }

  std::variant<T, Error> content_;
};

/// Done, or the sentence that says why not.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  explicit operator bool() const { return !error_; }

  const std::string& error() const {
    assert(error_ && "error() of a Result that holds a value");
    return error_->sentence;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace robot
