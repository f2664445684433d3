// A disk that refuses or stands still: chosen calls for files fail in this program, or wait.
#pragma once

namespace tests {

/// Whether this program can let calls fail or wait: a sanitizer has functions of its own.
#ifdef TESTS_WITH_SANITIZER
inline constexpr bool kCanFailFiles = false;
#else
inline constexpr bool kCanFailFiles = true;
#endif

/// A function of the system for files. `cut`: what an append leaves cannot be cut off either.
enum class FileCall { create, append, cut, write, store, rename };

/// Lets `count` calls of a function fail as on a full disk, after `before` calls that succeed. Ends earlier orders. Any thread.
void fail_files(FileCall call, int before, int count);

/// Lets all calls wait until mend_files(), as on a disk that stands still. Any thread.
void stop_files();

/// Returns how many calls wait. Any thread.
int waiting_files();

/// Lets all calls succeed again. Any thread.
void mend_files();

/// Returns how many calls have failed since the last fail_files(). Any thread.
int failed_files();

}  // namespace tests
