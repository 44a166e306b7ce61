// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace lightcuts {

/// A terminal without a screen.
class Terminal {
public:
  Terminal() : fd_(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (fd_ < 0 || grantpt(fd_) != 0 || unlockpt(fd_) != 0)
      throw std::runtime_error("no pseudo terminal");
  }
  ~Terminal() { close(fd_); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Where to write to it.
  [[nodiscard]] std::filesystem::path path() const { return ptsname(fd_); }

  /// Waits for text that was written to it; empty once whoever wrote has ended and all is read.
  [[nodiscard]] std::string next() const {
    char part[256];
    const ssize_t n = read(fd_, part, sizeof part);
    return n > 0 ? std::string(part, std::size_t(n)) : std::string();
  }

private:
  int fd_;
};

} // namespace lightcuts
