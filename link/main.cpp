#include "base/settings/setting_keys.hpp"
#include "base/settings/setting_options.hpp"
#include "base/settings/settings_file.hpp"
#include "base/system/log.hpp"
#include "base/system/machine.hpp"
#include "base/system/service.hpp"
#include "base/system/stop_request.hpp"
#include "link/link.hpp"
#include "link/wall_key.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <stdexcept>
#include <string>

// vitrine-link: the one program of Vitrine that speaks to the network, for the boxes of one wall.

namespace {

using namespace vitrine;

/// @throws std::runtime_error with a sentence for what is missing or wrong
link::BrokerAccount account_of(const Settings& settings) {
    if (settings.wall.role == WallRole::alone)
        throw std::runtime_error(
            "this box is no part of a wall: `vitrinectl wall lead NAME` or `vitrinectl wall join NAME "
            "KEYFILE` makes it one");
    const bool is_leader = settings.wall.role == WallRole::lead;
    if (settings.wall.name.empty()) throw std::runtime_error("wall.name is missing: the name of the wall");
    if (!is_leader && settings.wall.leader.empty())
        throw std::runtime_error("wall.leader is missing: the address of the leader");
    return {.place = {.wall = settings.wall.name,
                      .box = settings.wall.box.empty() ? host_name() : settings.wall.box,
                      .is_leader = is_leader},
            .host = is_leader ? "127.0.0.1" : settings.wall.leader,
            .key = link::read_wall_key(settings.wall.key)};
}

void serve(const Settings& settings) {
    log::set_level(settings.log.level);
    const link::BrokerAccount account = account_of(settings);
    EventLoop loop;
    const StopRequest stop(loop, {.patience = std::chrono::seconds(3)}, [&] {
        service::stopping();
        loop.quit();
    });
    EventLoop::Source watchdog;
    if (const auto interval = service::watchdog_interval()) {
        watchdog = loop.timer([&watchdog, interval = *interval] {
            service::feed_watchdog();
            watchdog.arm(interval / 3);
        });
        watchdog.arm(std::chrono::seconds(0));
    }
    log::info("box '{}' {} the wall '{}'", account.place.box,
              account.place.is_leader ? "leads" : "follows on", account.place.wall);
    const link::Link link(loop, account, settings.wall.socket);
    service::ready("not connected yet");
    loop.run();
}

/// Prints the value of one setting as it is, for scripts.
int show(const std::string& name, const Settings& settings) {
    const SettingKey* const key = find_setting_key(name);
    if (key == nullptr) throw std::runtime_error(fmt::format("there is no setting '{}'", name));
    std::string text = key->text(settings);
    if (text.size() >= 2 && text.front() == '"') text = text.substr(1, text.size() - 2);
    fmt::print("{}\n", text);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Carries messages between the player of this box and the other boxes of its wall",
                 "vitrine-link");
    SettingOptions options;
    std::string shown;
    options.add_to(app);
    app.add_option("--show", shown, "Prints the value of this setting, such as wall.role, and ends");
    CLI11_PARSE(app, argc, argv);
    try {
        const Settings settings = options.settings();
        if (!shown.empty()) return show(shown, settings);
        serve(settings);
        return 0;
    } catch (const std::exception& error) {
        log::error("{}", error.what());
        return 1;
    }
}
