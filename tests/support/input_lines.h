// Lines on the standard input, as far as they have arrived.
#pragma once

#include <unistd.h>

#include <array>
#include <string>

namespace tests {

class InputLines {
 public:
  /// Reads once and calls see(line) for each whole line. Returns false at the end of the input.
  template <class See>
  bool read(See&& see) {
    std::array<char, 4096> block;
    const ssize_t n = ::read(STDIN_FILENO, block.data(), block.size());
    if (n <= 0) return false;
    input_.append(block.data(), static_cast<std::size_t>(n));
    for (std::size_t end = input_.find('\n'); end != std::string::npos; end = input_.find('\n')) {
      see(input_.substr(0, end));
      input_.erase(0, end + 1);
    }
    return true;
  }

 private:
  std::string input_;
};

}  // namespace tests
