#include "link/broker_fault.hpp"

#include <doctest/doctest.h>
#include <mosquitto.h>

#include <cerrno>

using namespace vitrine::link;

TEST_CASE("each way in which a network fails has words of its own") {
    for (const int result : {MOSQ_ERR_KEEPALIVE, MOSQ_ERR_TIMEOUT, MOSQ_ERR_LOOKUP, MOSQ_ERR_EAI,
                             MOSQ_ERR_CONN_LOST, MOSQ_ERR_CONN_REFUSED, MOSQ_ERR_TLS, MOSQ_ERR_TLS_HANDSHAKE,
                             MOSQ_ERR_PROTOCOL, MOSQ_ERR_MALFORMED_PACKET, MOSQ_ERR_NO_CONN}) {
        CAPTURE(result);
        CHECK(broker_fault(result) != mosquitto_strerror(MOSQ_ERR_UNKNOWN));
    }
    CHECK(broker_fault(MOSQ_ERR_KEEPALIVE) == "it answers no more");
    errno = ECONNREFUSED;
    CHECK(broker_fault(MOSQ_ERR_ERRNO) == "Connection refused");
}
