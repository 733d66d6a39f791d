#include "link/broker_client.hpp"

#include "base/system/event_file.hpp"
#include "base/system/handle.hpp"
#include "base/wall/broken_line.hpp"
#include "link/backoff.hpp"
#include "link/broker_fault.hpp"

#include <fmt/format.h>
#include <mosquitto.h>
#include <poll.h>
#include <sys/epoll.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace vitrine::link {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int keepalive = 10;       // seconds; a box that is cut off is gone after half as many again
constexpr int at_least_once = 1;    // MQTT's QoS
constexpr int max_on_the_way = 20;  // messages that the broker has not confirmed
constexpr int tick = 1000;          // ms between two looks at the connection's timers
constexpr std::string_view gone = R"({"gone":true})";

void check(int result, const char* what) {
    if (result != MOSQ_ERR_SUCCESS)
        throw std::runtime_error(fmt::format("{}: {}", what, broker_fault(result)));
}

}  // namespace

/// The client of libmosquitto. The thread alone uses it.
struct BrokerClient::Connection {
    explicit Connection(BrokerClient& its_owner);

    void on_connect(int code);
    void on_message(const mosquitto_message& message);
    void send_waiting();

    BrokerClient& owner;  // outlives this
    Handle<mosquitto, &mosquitto_destroy> client;
    std::string refusal;  // the broker has refused the connection
    int on_the_way = 0;
    std::optional<Clock::time_point> since;
};

BrokerClient::Connection::Connection(BrokerClient& its_owner) : owner(its_owner) {
    const BrokerAccount& account = owner.account_;
    const WallPlace& place = account.place;
    const std::string id = place.wall + "/" + place.box;
    client.reset(mosquitto_new(id.c_str(), true, this));
    if (!client) throw std::runtime_error("make a client of MQTT: no memory");
    check(mosquitto_tls_psk_set(client.get(), account.key.c_str(), place.wall.c_str(), nullptr),
          "use the key");
    const std::string topic = broker_topic(place, {.kind = WallTopic::Kind::box, .box = place.box});
    check(mosquitto_will_set(client.get(), topic.c_str(), static_cast<int>(gone.size()), gone.data(),
                             at_least_once, true),
          "set the last will");
    mosquitto_connect_callback_set(client.get(), [](mosquitto*, void* self, int code) {
        static_cast<Connection*>(self)->on_connect(code);
    });
    mosquitto_message_callback_set(client.get(),
                                   [](mosquitto*, void* self, const mosquitto_message* message) {
                                       static_cast<Connection*>(self)->on_message(*message);
                                   });
    mosquitto_publish_callback_set(
        client.get(), [](mosquitto*, void* self, int) { --static_cast<Connection*>(self)->on_the_way; });
}

void BrokerClient::Connection::on_connect(int code) {
    if (code != 0) {
        refusal = mosquitto_connack_string(code);
        return;
    }
    for (const std::string& topic : subscriptions_of(owner.account_.place))
        mosquitto_subscribe(client.get(), nullptr, topic.c_str(), at_least_once);
    since = Clock::now();
    owner.tell(true, fmt::format("connected to '{}'", owner.account_.host));
}

void BrokerClient::Connection::on_message(const mosquitto_message& message) {
    const std::string_view payload(static_cast<const char*>(message.payload),
                                   static_cast<std::size_t>(message.payloadlen));
    try {
        WallMessage read = received(owner.account_.place, message.topic, payload);
        const std::lock_guard lock(owner.shared_.mutex);
        owner.shared_.in.put(std::move(read));
    } catch (const std::exception& error) {  // this is called from C
        const std::lock_guard lock(owner.shared_.mutex);
        owner.shared_.fault = error.what();
    }
    ring(owner.to_loop_.get());
}

void BrokerClient::Connection::send_waiting() {
    while (since && on_the_way < max_on_the_way) {
        std::optional<WallMessage> message;
        {
            const std::lock_guard lock(owner.shared_.mutex);
            message = owner.shared_.out.take();
        }
        if (!message) return;
        const std::string topic = broker_topic(owner.account_.place, message->topic);
        const int result =
            mosquitto_publish(client.get(), nullptr, topic.c_str(), static_cast<int>(message->payload.size()),
                              message->payload.data(), at_least_once, is_kept(message->topic.kind));
        if (result == MOSQ_ERR_SUCCESS) ++on_the_way;
    }
}

BrokerClient::BrokerClient(EventLoop& loop, BrokerAccount account, Handlers handlers)
    : account_(std::move(account)),
      handlers_(std::move(handlers)),
      to_loop_(event_file()),
      to_thread_(event_file()),
      source_(loop.watch(to_loop_.get(), EPOLLIN, [this](std::uint32_t) { deliver(); })) {
    mosquitto_lib_init();
    thread_ = std::thread([this] { run(); });
}

BrokerClient::~BrokerClient() {
    {
        const std::lock_guard lock(shared_.mutex);
        shared_.is_stopped = true;
    }
    shared_.stops.notify_all();
    ring(to_thread_.get());
    thread_.join();
    mosquitto_lib_cleanup();
}

void BrokerClient::publish(const WallMessage& message) {
    {
        const std::lock_guard lock(shared_.mutex);
        if (is_of_a_moment(message.topic.kind) && !shared_.is_connected) return;
        shared_.out.put(message);
    }
    ring(to_thread_.get());
}

void BrokerClient::tell(bool is_connected, const std::string& says) {
    {
        const std::lock_guard lock(shared_.mutex);
        shared_.is_connected = is_connected;
        shared_.says = says;
    }
    ring(to_loop_.get());
}

/// The thread: connects, serves, and tries again, until it is stopped.
void BrokerClient::run() {
    Backoff backoff;
    while (true) {
        Backoff::Duration held{0};
        std::string why;
        try {
            Connection connection(*this);
            why = serve(connection);
            if (connection.since)
                held = std::chrono::duration_cast<Backoff::Duration>(Clock::now() - *connection.since);
            if (connection.since && held < Backoff::held)  // the broker ends the older of two with one name
                why +=
                    fmt::format("; if that goes on, another box may be called '{}' too", account_.place.box);
        } catch (const std::exception& error) {  // it ends this connection and not the thread
            why = error.what();
        }
        tell(false, fmt::format("no connection to '{}': {}", account_.host, why));
        std::unique_lock lock(shared_.mutex);
        if (shared_.stops.wait_for(lock, backoff.next(held), [this] { return shared_.is_stopped; })) return;
    }
}

/// Serves one connection to its end. @return  the reason of its end
std::string BrokerClient::serve(Connection& connection) {
    mosquitto* const client = connection.client.get();
    int result = mosquitto_connect(client, account_.host.c_str(), port, keepalive);
    while (result == MOSQ_ERR_SUCCESS) {
        {
            const std::lock_guard lock(shared_.mutex);
            if (shared_.is_stopped) return "this program ends";
        }
        connection.send_waiting();
        const short events = mosquitto_want_write(client) ? POLLIN | POLLOUT : POLLIN;
        std::array<pollfd, 2> files{pollfd{.fd = mosquitto_socket(client), .events = events},
                                    pollfd{.fd = to_thread_.get(), .events = POLLIN}};
        if (::poll(files.data(), files.size(), tick) < 0 && errno != EINTR) break;
        if (files[1].revents != 0) quiet(to_thread_.get());
        if (files[0].revents != 0) result = mosquitto_loop_read(client, 1);
        if (result == MOSQ_ERR_SUCCESS && mosquitto_want_write(client))
            result = mosquitto_loop_write(client, 1);
        if (result == MOSQ_ERR_SUCCESS) result = mosquitto_loop_misc(client);
    }
    return connection.refusal.empty() ? broker_fault(result) : connection.refusal;
}

/// In the loop's thread: hands over all that came.
void BrokerClient::deliver() {
    quiet(to_loop_.get());
    std::unique_lock lock(shared_.mutex);
    const bool is_connected = shared_.is_connected;
    const auto says = std::exchange(shared_.says, std::nullopt);
    const auto fault = std::exchange(shared_.fault, std::nullopt);
    MessageQueue came = std::exchange(shared_.in, {});
    lock.unlock();
    if (says) handlers_.state(is_connected, *says);
    if (fault) handlers_.refused(*fault);
    while (const auto message = came.take())
        handlers_.message(*message);
}

}  // namespace vitrine::link
