#include "base/state/fault.hpp"

#include <cerrno>

namespace vitrine {

FaultOwner fault_owner(int error) {
    switch (error) {
    case ENOMEM:
    case EMFILE:
    case ENFILE:
    case EAGAIN:
    case ENOBUFS:
    case ENOSPC:
        return FaultOwner::machine;
    default:
        return FaultOwner::transport;
    }
}

}  // namespace vitrine
