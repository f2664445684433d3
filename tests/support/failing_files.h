// A disk that refuses: chosen calls for files fail in this program.
#pragma once

namespace tests {

/// Whether this program can let calls fail: a sanitizer has functions of its own.
#ifdef TESTS_WITH_SANITIZER
inline constexpr bool kCanFailFiles = false;
#else
inline constexpr bool kCanFailFiles = true;
#endif

/// A function of the system for files. `cut`: what an append leaves cannot be cut off either.
enum class FileCall { create, append, cut, write, store, rename };

/// Lets `count` calls of a function fail as on a full disk, after `before` calls that succeed. Ends earlier orders. Any thread.
void fail_files(FileCall call, int before, int count);

/// Lets all calls succeed again. Any thread.
void mend_files();

/// Returns how many calls have failed since the last fail_files(). Any thread.
int failed_files();

}  // namespace tests
