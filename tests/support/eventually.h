// Waiting in tests: for a condition, with a deadline, and with a sentence when the condition never holds.
//
//   ASSERT_TRUE(eventually([&] { return memory->ball.read() != nullptr; }));
//   ASSERT_TRUE(eventually([&] { return link->status().lost == 2; }, kLongestWait, [&] { return link->status().problem; }));
//   ASSERT_TRUE(eventually_equal([&] { return newest_ns("/14/2/ball"); }, 7u));
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <utility>

namespace tests {

/// Longest wait for a condition. Only a failure takes this long, so there is room for a busy machine and sanitizers.
inline constexpr std::chrono::milliseconds kLongestWait = std::chrono::seconds(60);

/// Time between two looks at a condition.
inline constexpr std::chrono::milliseconds kLook{1};

/// Calls `predicate` until it returns true, or until `patience` has passed.
///
/// The failure's message holds the value that `seen` returns after the last call: anything that gtest can print.
template <class Predicate, class Seen>
::testing::AssertionResult eventually(Predicate&& predicate, std::chrono::milliseconds patience, Seen&& seen) {
  const auto end = std::chrono::steady_clock::now() + patience;
  // the look after the deadline counts: the machine may have stood still for longer than `patience`
  for (bool late = false; !predicate(); late = std::chrono::steady_clock::now() > end) {
    if (late)
      return ::testing::AssertionFailure() << "the condition did not hold within " << patience.count()
                                           << " ms; last seen: " << ::testing::PrintToString(seen());
    std::this_thread::sleep_for(kLook);
  }
  return ::testing::AssertionSuccess();
}

/// The same without a value to print.
template <class Predicate>
::testing::AssertionResult eventually(Predicate&& predicate, std::chrono::milliseconds patience = kLongestWait) {
  return eventually(std::forward<Predicate>(predicate), patience, [] { return "the condition is false"; });
}

/// Calls `get` until it returns `expected`; the failure's message holds the last value and the expected one.
template <class Get, class Value>
::testing::AssertionResult eventually_equal(Get&& get, const Value& expected,
                                            std::chrono::milliseconds patience = kLongestWait) {
  auto last = get();
  ::testing::AssertionResult result =
      eventually([&] { return (last = get()) == expected; }, patience, [&] { return last; });
  return result ? result : result << ", expected " << ::testing::PrintToString(expected);
}

}  // namespace tests
