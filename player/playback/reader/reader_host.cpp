#include "player/playback/reader/reader_host.hpp"

#include "base/system/error.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

/// Owns the lists that posix_spawn reads.
struct SpawnLists {
    SpawnLists() {
        ::posix_spawn_file_actions_init(&files);
        ::posix_spawnattr_init(&attributes);
    }

    SpawnLists(const SpawnLists&) = delete;
    SpawnLists& operator=(const SpawnLists&) = delete;
    SpawnLists(SpawnLists&&) = delete;
    SpawnLists& operator=(SpawnLists&&) = delete;

    ~SpawnLists() {
        ::posix_spawn_file_actions_destroy(&files);
        ::posix_spawnattr_destroy(&attributes);
    }

    posix_spawn_file_actions_t files{};
    posix_spawnattr_t attributes{};
};

}  // namespace

ReaderHost::ReaderHost(std::vector<std::string> command) : command_(std::move(command)) {
    start();
}

ReaderHost::~ReaderHost() {
    end();
}

MessageSocket ReaderHost::start_reader(const ReaderOrder& order, const UniqueFd& memory) {
    auto [ours, theirs] = message_sockets();
    const std::vector<std::byte> message = to_message(order);
    const std::array<int, 2> files{theirs.fd(), memory.get()};
    if (message.size() > MessageSocket::max_bytes) throw std::runtime_error("its name is too long");
    if (orders_ && orders_->send(message, files)) return std::move(ours);
    if (is_running()) throw std::runtime_error("the reader host takes no orders");
    end();
    start();
    if (!orders_->send(message, files)) throw std::runtime_error("no reader can be started");
    return std::move(ours);
}

void ReaderHost::start() {
    auto [ours, theirs] = message_sockets();
    SpawnLists lists;
    ::posix_spawn_file_actions_adddup2(&lists.files, theirs.fd(), STDIN_FILENO);
    sigset_t none;
    ::sigemptyset(&none);
    ::posix_spawnattr_setsigmask(&lists.attributes, &none);
    ::posix_spawnattr_setflags(&lists.attributes, POSIX_SPAWN_SETSIGMASK);
    std::vector<char*> words;
    for (std::string& word : command_)
        words.push_back(word.data());
    words.push_back(nullptr);
    const int failed =
        ::posix_spawn(&process_, words.front(), &lists.files, &lists.attributes, words.data(), environ);
    if (failed != 0) {
        process_ = -1;
        errno = failed;
        throw_errno("start the reader host '{}'", command_.front());
    }
    orders_.emplace(std::move(ours));
}

void ReaderHost::end() {
    orders_.reset();
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    process_ = -1;
}

/// False: it has ended, or was never started.
bool ReaderHost::is_running() {
    if (process_ <= 0) return false;
    if (::waitpid(process_, nullptr, WNOHANG) == 0) return true;
    process_ = -1;
    return false;
}

}  // namespace vitrine::player
