// A process table that is full: the next threads of this program cannot be created.
#pragma once

namespace tests {

/// Whether this program can refuse threads: a sanitizer has a pthread_create of its own.
#ifdef TESTS_WITH_SANITIZER
inline constexpr bool kCanRefuseThreads = false;
#else
inline constexpr bool kCanRefuseThreads = true;
#endif

/// Refuses the next `count` threads, with EAGAIN. 0: none. Any thread.
void refuse_threads(int count);

/// Returns the number of threads that were refused since the start. Any thread.
int refused_threads();

}  // namespace tests
