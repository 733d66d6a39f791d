#include "link/broker_fault.hpp"

#include <mosquitto.h>

#include <cerrno>
#include <system_error>

namespace vitrine::link {

std::string broker_fault(int result) {
    switch (result) {
    case MOSQ_ERR_ERRNO:
        return std::generic_category().message(errno);
    case MOSQ_ERR_TLS:
        return "it does not take this key";
    case MOSQ_ERR_KEEPALIVE:
        return "it answers no more";
    case MOSQ_ERR_TIMEOUT:
        return "it does not answer";
    case MOSQ_ERR_EAI:
    case MOSQ_ERR_LOOKUP:
        return "no address is known for this name";
    case MOSQ_ERR_MALFORMED_PACKET:
        return "it sends what is no message of MQTT";
    default:
        return mosquitto_strerror(result);
    }
}

}  // namespace vitrine::link
