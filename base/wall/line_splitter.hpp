#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

/// Puts lines together from the pieces in which a stream delivers them.
class LineSplitter {
  public:
    explicit LineSplitter(std::size_t max_line) : max_line_(max_line) {}

    /// The lines that this piece completes, without their newlines.
    /// @throws BrokenLine if a line is longer than max_line, whether it is complete or not
    std::vector<std::string> push(std::string_view piece);

  private:
    std::size_t max_line_;
    std::string begun_;
};

}  // namespace vitrine
