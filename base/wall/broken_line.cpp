#include "base/wall/broken_line.hpp"

namespace vitrine {

BrokenLine::~BrokenLine() = default;

}  // namespace vitrine
