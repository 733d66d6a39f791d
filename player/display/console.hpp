#pragma once

#include "base/system/unique_fd.hpp"

namespace vitrine {

/// Keeps the kernel's text console from being drawn over the wall for as long as it lives; does nothing on a
/// machine without one, or where it is not ours.
class QuietConsole {
  public:
    QuietConsole();
    QuietConsole(const QuietConsole&) = delete;
    QuietConsole& operator=(const QuietConsole&) = delete;
    QuietConsole(QuietConsole&&) = delete;
    QuietConsole& operator=(QuietConsole&&) = delete;
    ~QuietConsole();

  private:
    UniqueFd terminal_;  // open while it is in graphics mode because of us
};

}  // namespace vitrine
