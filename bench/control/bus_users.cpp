// Users who ask the player over the system bus without a pause; users.py runs them.
//   bus_users USERS SECONDS
// Five of ten users ask for the status, four ask why a file of a long name is not shown, and one asks for a
// screenshot. It prints how many answers came, how many were refusals, and the longest time of one.

#include "player/control/control_client.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

using namespace vitrine::player;

namespace {

using Clock = std::chrono::steady_clock;

const Command& method(std::string_view name) {
    return *std::ranges::find(commands(), name, &Command::method);
}

struct Figures {
    std::mutex mutex;
    long answers = 0, refusals = 0;
    double longest_ms = 0;
};

/// Asks until the end. @param number  of the user
void ask(int number, Clock::time_point end, Figures& figures) {
    const char* const what = number % 10 == 0 ? "Screenshot" : number % 10 < 5 ? "Why" : "Status";
    std::string name = "picture.png";
    while (name.size() < 4'000)
        name.insert(0, "a folder of a long name that is not there at all, but could well be/");
    const CommandCall call{.file = number % 10 == 0 ? "" : name, .folder = "/"};
    for (ControlClient client; Clock::now() < end;) {
        const auto begin = Clock::now();
        bool is_refused = false;
        try {
            (void)client.call(method(what), call);
        } catch (const ControlError&) {
            is_refused = true;
        }
        const double ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
        const std::lock_guard lock(figures.mutex);
        ++(is_refused ? figures.refusals : figures.answers);
        figures.longest_ms = std::max(figures.longest_ms, ms);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return std::fprintf(stderr, "bus_users USERS SECONDS\n"), 1;
    const auto end = Clock::now() + std::chrono::seconds(std::atoi(argv[2]));
    Figures figures;
    std::atomic<int> without = 0;
    std::vector<std::thread> users;
    for (int i = 0; i < std::atoi(argv[1]); ++i)
        users.emplace_back([&, i] {
            try {
                ask(i, end, figures);
            } catch (const ControlError&) {
                ++without;
            }
        });
    for (std::thread& user : users)
        user.join();
    fmt::print("{} answers, {} refusals, {:.0f} ms the longest, {} users without a bus\n", figures.answers,
               figures.refusals, figures.longest_ms, without.load());
}
