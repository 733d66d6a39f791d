#pragma once

#include <string>

namespace vitrine::link {

/// The reason why a connection to the broker ended or did not come about, in words that come after a colon.
/// @param result  of a function of libmosquitto, whose own words lack some; errno is read for MOSQ_ERR_ERRNO
std::string broker_fault(int result);

}  // namespace vitrine::link
