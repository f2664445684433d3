// The border for exceptions of libraries: memory that cannot be allocated, system errors.
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <type_traits>

#include "robot/core/result.h"

namespace robot {

/// Calls `work` and returns its Result<void>, if it has one. Returns an Error "PURPOSE failed: REASON" if an exception comes
/// out of it. The loops of threads use it, so that one message, one request or one client fails, and not the process.
template <class Work>
Result<void> attempt(std::string_view purpose, Work&& work) {
  try {
    if constexpr (std::is_same_v<decltype(work()), Result<void>>) {
      return work();
    } else {
      work();
      return {};
    }
  } catch (const std::exception& exception) {
    return Error{std::string(purpose) + " failed: " + exception.what()};
  }
}

}  // namespace robot
