#pragma once

#include "base/system/event_loop.hpp"
#include "base/system/unique_fd.hpp"
#include "link/message_queue.hpp"
#include "link/message_rules.hpp"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace vitrine::link {

/// The way to the broker of a wall.
struct BrokerAccount {
    WallPlace place;
    std::string host;
    std::string key;  // read_wall_key()
};

/// A connection to the broker by MQTT over TLS, which is made again whenever it is gone. A thread of its own
/// makes and serves it, as looking up a name and connecting may take long.
class BrokerClient {
  public:
    static constexpr int port = 8883;

    struct Handlers {
        std::function<void(bool is_connected, const std::string& says)> state;
        std::function<void(const WallMessage& message)> message;  // received(), its payload not yet read
        std::function<void(const std::string& fault)> refused;    // a message was not received()
    };

    /// @param loop  outlives this; the handlers are called from it
    /// @throws std::system_error, std::runtime_error
    BrokerClient(EventLoop& loop, BrokerAccount account, Handlers handlers);
    BrokerClient(const BrokerClient&) = delete;
    BrokerClient& operator=(const BrokerClient&) = delete;
    ~BrokerClient();

    /// Sends a message now or, within the bounds of a MessageQueue, when there is a connection. A touch is
    /// dropped while there is none.
    void publish(const WallMessage& message);

  private:
    struct Connection;

    /// All that both threads use, guarded by mutex.
    struct Shared {
        std::mutex mutex;
        std::condition_variable stops;
        bool is_stopped = false;
        bool is_connected = false;
        std::optional<std::string> says;  // the state has changed
        std::optional<std::string> fault;
        MessageQueue in, out;
    };

    void run();
    std::string serve(Connection& connection);
    void tell(bool is_connected, const std::string& says);
    void deliver();

    BrokerAccount account_;
    Handlers handlers_;
    Shared shared_;
    UniqueFd to_loop_, to_thread_;  // something is there for the other
    EventLoop::Source source_;
    std::thread thread_;
};

}  // namespace vitrine::link
