#include "player/control/cec_standby.hpp"

#include "base/system/log.hpp"

#include <sys/wait.h>

#include <array>
#include <csignal>
#include <cstring>

#include <spawn.h>
#include <unistd.h>

namespace vitrine::player {

namespace {

// Its words are of no use in the journal, and it must not read our terminal.
struct Silence {
    Silence() {
        ::posix_spawn_file_actions_init(&files);
        for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
            ::posix_spawn_file_actions_addopen(&files, fd, "/dev/null", fd == STDIN_FILENO ? 0 : 1, 0);
    }

    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;
    Silence(Silence&&) = delete;
    Silence& operator=(Silence&&) = delete;

    ~Silence() { ::posix_spawn_file_actions_destroy(&files); }

    posix_spawn_file_actions_t files{};
};

}  // namespace

CecStandby::~CecStandby() {
    look();
    if (tool_ < 0) return;
    (void)::kill(tool_, SIGKILL);
    (void)::waitpid(tool_, nullptr, 0);
}

void CecStandby::ask(bool is_on) {
    look();
    if (tool_ >= 0) {  // it hangs since the last change
        (void)::kill(tool_, SIGKILL);
        (void)::waitpid(tool_, nullptr, 0);
        tool_ = -1;
    }
    std::array<char, 8> name{"cec-ctl"};
    std::array<char, 11> role{"--playback"};
    std::array<char, 7> receiver{"--to=0"};
    std::array<char, 16> wake{"--image-view-on"};
    std::array<char, 10> sleep{"--standby"};
    const std::array<char*, 5> words{name.data(), role.data(), receiver.data(),
                                     is_on ? wake.data() : sleep.data(), nullptr};
    const Silence silence;
    pid_t tool = -1;
    const int error = ::posix_spawnp(&tool, name.data(), &silence.files, nullptr, words.data(), environ);
    if (error == 0) tool_ = tool;
    log::debug("cec-ctl {}: {}", is_on ? "wake" : "standby", error == 0 ? "asked" : std::strerror(error));
}

void CecStandby::look() {
    if (tool_ >= 0 && ::waitpid(tool_, nullptr, WNOHANG) != 0) tool_ = -1;
}

}  // namespace vitrine::player
