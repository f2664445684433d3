// A value, or a sentence with the reason why there is none.
//
//   Result<Config> load(const std::filesystem::path& file) {
//     const Result<std::string> text = read_file(file);
//     if (!text) return text.failure();                   // hands the error on as it is
//     const Result<Config> config = parse(*text);
//     if (!config) return config.failure(file.string());  // puts "FILE: " before its sentence
//     return *config;
//   }
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace robot {

/// The reason of a failure: one sentence for the person who must fix it.
/// It says what is wrong, where, what was expected and what came.
struct Error {
  std::string sentence;
};

/// A `T`, or the `Error` with the reason why there is none. Never throws.
/// To call `value()` on an error, or `error()` or `failure()` on a value, is a bug of the caller (asserted).
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
    assert(!*this && "error() or failure() of a Result that holds a value");
    return std::get<1>(content_).sentence;
  }

  /// Returns the error so that a function with another `Result` type can return it.
  [[nodiscard]] Error failure() const { return {error()}; }

  /// Returns the error with its place before it: "PLACE: sentence".
  [[nodiscard]] Error failure(std::string_view place) const { return {std::string(place) + ": " + error()}; }

 private:
  T* get() {
    assert(*this && "value() of a Result that holds an error");
    return std::get_if<0>(&content_);
  }

  std::variant<T, Error> content_;
};

/// Success, or the `Error` with the reason why not.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  explicit operator bool() const { return !error_; }

  const std::string& error() const {
    assert(error_ && "error() or failure() of a Result that holds a value");
    return error_->sentence;
  }

  /// Returns the error so that a function with another `Result` type can return it.
  [[nodiscard]] Error failure() const { return {error()}; }

  /// Returns the error with its place before it: "PLACE: sentence".
  [[nodiscard]] Error failure(std::string_view place) const { return {std::string(place) + ": " + error()}; }

 private:
  std::optional<Error> error_;
};

}  // namespace robot
