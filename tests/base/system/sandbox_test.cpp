#include "base/system/sandbox.hpp"

#include "base/system/unique_fd.hpp"
#include "tests/missing_call.hpp"
#include "tests/taken_over.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

using namespace vitrine;

namespace {

namespace fs = std::filesystem;
using taken_over::call_tries;
using taken_over::file_tries;
using taken_over::is_opened;
using taken_over::Try;

using Tries = std::vector<Try>;

/// The tries that reach what they want, in a process of its own that has entered a sandbox; "the end" comes
/// last, unless the process ended before.
std::string reached_in_sandbox(const SandboxRules& rules, const Tries& tries) {
    std::array<int, 2> ends{};
    REQUIRE(::pipe2(ends.data(), O_CLOEXEC) == 0);
    const UniqueFd read(ends[0]);
    UniqueFd write(ends[1]);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        std::string reached;
        try {
            (void)enter_sandbox(rules);
            for (const Try& one : tries)
                if (one.reaches()) reached += one.name + "; ";
            reached += "the end";
        } catch (const std::exception& error) {
            reached += error.what();
        }
        if (::write(write.get(), reached.data(), reached.size()) < 0) ::_exit(1);
        ::_exit(0);
    }
    write.reset();
    std::string reached;
    std::array<char, 4096> buffer{};
    for (ssize_t n = 0; (n = ::read(read.get(), buffer.data(), buffer.size())) > 0;)
        reached.append(buffer.data(), static_cast<std::size_t>(n));
    ::waitpid(child, nullptr, 0);
    return reached;
}

/// A reader's place: the file to read, the folder to write, and all that it may not touch.
struct Desk {
    Desk() {
        fs::create_directories(home.path / "folder");
        fs::create_symlink(record, home.path / "folder/link");
        read.reset(::open(media.c_str(), O_RDONLY | O_CLOEXEC));
        folder.reset(::open((home.path / "folder").c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::strncpy(address.sun_path, (home.path / "socket").c_str(), sizeof address.sun_path - 1);
        listening.reset(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
        REQUIRE(::bind(listening.get(), reinterpret_cast<const sockaddr*>(&address),  // NOLINT
                       sizeof address) == 0);
        REQUIRE(::listen(listening.get(), 1) == 0);
        unconnected.reset(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    }

    SandboxRules rules() const { return {.readable = {read.get()}, .writable = {folder.get()}}; }

    taken_over::Prey prey() const {
        return {.media = media,
                .record = record,
                .folder = home.path / "folder",
                .socket = home.path / "socket",
                .descriptor = read.get(),
                .unconnected = unconnected.get()};
    }

    fs::path path(const char* name) const { return home.path / "folder" / name; }

    std::string again() const { return "/proc/self/fd/" + std::to_string(read.get()); }

    TemporaryDirectory home;
    fs::path media = home.write("media/a.jpg", "picture");
    fs::path record = home.write("catalogue/b.json", "record");
    UniqueFd read, folder, listening, unconnected;
};

bool copies(const UniqueFd& from, const std::string& wanted) {
    std::array<char, 64> bytes{};
    const ssize_t got = ::pread(from.get(), bytes.data(), bytes.size(), 0);
    return got >= 0 && std::string(bytes.data(), static_cast<std::size_t>(got)) == wanted;
}

/// Sends a descriptor through a connected socket.
bool hands_over(int socket, int fd) {
    char letter = 'x';
    iovec data{&letter, 1};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
    msghdr message{
        .msg_iov = &data, .msg_iovlen = 1, .msg_control = control.data(), .msg_controllen = control.size()};
    cmsghdr* head = CMSG_FIRSTHDR(&message);
    head->cmsg_level = SOL_SOCKET;
    head->cmsg_type = SCM_RIGHTS;
    head->cmsg_len = CMSG_LEN(sizeof fd);
    std::memcpy(CMSG_DATA(head), &fd, sizeof fd);
    return ::sendmsg(socket, &message, 0) == 1;
}

/// A reader needs each of these.
Tries needs(const Desk& desk, int socket) {
    return {
        {"file", [&] { return copies(desk.read, "picture"); }},
        {"file again", [&] { return copies(UniqueFd(::open(desk.again().c_str(), O_RDONLY)), "picture"); }},
        {"new file",
         [&] {
             std::ofstream(desk.path("a.new")) << "clip";
             const UniqueFd made(::open(desk.path("a.new").c_str(), O_RDWR | O_CLOEXEC));
             return copies(made, "clip") && ::fsync(made.get()) == 0 && ::fchmod(made.get(), 0644) == 0 &&
                    ::ftruncate(made.get(), 2) == 0 &&
                    ::rename(desk.path("a.new").c_str(), desk.path("a").c_str()) == 0;
         }},
        {"new folder",
         [&] {
             fs::create_directories(desk.path("tiles/0"));
             fs::copy_file(desk.path("a"), desk.path("tiles/0/a"));
             return fs::remove_all(desk.path("tiles")) == 3;
         }},
        {"threads",
         [] {
             int sum = 0;
             for (int i = 0; i < 4; ++i)
                 std::thread([&] { sum += i; }).join();
             return sum == 6;
         }},
        {"memory", [] { return std::vector<char>(std::size_t{64} << 20U, 'x').back() == 'x'; }},
        {"clocks",
         [] {
             const auto before = std::chrono::steady_clock::now();
             std::this_thread::sleep_for(std::chrono::milliseconds(1));
             return std::chrono::steady_clock::now() > before;
         }},
        {"waiting",
         [] {
             const UniqueFd event(::eventfd(1, EFD_CLOEXEC));
             pollfd wanted{.fd = event.get(), .events = POLLIN, .revents = 0};
             return ::poll(&wanted, 1, 1000) == 1;
         }},
        {"pictures in memory, handed over",
         [socket] {
             const UniqueFd memory(::memfd_create("picture", MFD_CLOEXEC));
             if (::ftruncate(memory.get(), 4096) != 0) return false;
             void* const pixels = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, memory.get(), 0);
             return pixels != MAP_FAILED && hands_over(socket, memory.get());
         }},
        {"signals to itself",
         [] {
             std::signal(SIGUSR1, SIG_IGN);
             return ::kill(::getpid(), SIGUSR1) == 0 && std::raise(SIGUSR1) == 0;
         }},
        {"its name", [] { return ::prctl(PR_SET_NAME, "reader") == 0; }},
    };
}

std::string names_of(const Tries& tries) {
    std::string names;
    for (const Try& one : tries)
        names += one.name + "; ";
    return names + "the end";
}

}  // namespace

TEST_CASE("in a sandbox nothing can be opened or changed but what it was given") {
    if (!available_sandbox().limits_files) {
        MESSAGE("skipped: this kernel has no Landlock");
        return;
    }
    const Desk desk;
    CHECK(reached_in_sandbox(desk.rules(), file_tries(desk.prey())) == "the end");
    CHECK(fs::file_size(desk.record) == 6);
    CHECK(reached_in_sandbox({}, {{"its folder", [&] {
                                       return is_opened(desk.path("x"), O_WRONLY | O_CREAT);
                                   }}}) == "the end");
}

TEST_CASE("in a sandbox there are no sockets, signals, processes and programs") {
    if (!available_sandbox().limits_calls) {
        MESSAGE("skipped: this kernel has no seccomp");
        return;
    }
    const Desk desk;
    CHECK(reached_in_sandbox(desk.rules(), call_tries(desk.prey())) == "the end");
    CHECK(fs::file_size(desk.record) == 6);
}

TEST_CASE("in a sandbox a reader has what it needs") {
    const Desk desk;
    std::array<int, 2> pair{};
    REQUIRE(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, pair.data()) == 0);
    const UniqueFd here(pair[0]);
    const UniqueFd there(pair[1]);
    const Tries wanted = needs(desk, there.get());
    CHECK(reached_in_sandbox(desk.rules(), wanted) == names_of(wanted));
    CHECK(fs::exists(desk.path("a")));
}

TEST_CASE("a kernel without Landlock limits the calls all the same, and the sandbox says so") {
    if (!available_sandbox().limits_calls) return;
    const Desk desk;
    CHECK(holds_without_call(SYS_landlock_create_ruleset, ENOSYS, [&] {
        const Sandbox sandbox = enter_sandbox(desk.rules());
        return !sandbox.limits_files && sandbox.limits_calls && is_opened(desk.record, O_RDONLY) &&
               ::kill(::getppid(), 0) != 0;
    }));
}

TEST_CASE("a log line says which parts of the sandbox hold") {
    CHECK(in_words(Sandbox{.limits_files = true, .limits_calls = true}).find("no files but") !=
          std::string::npos);
    CHECK(in_words(Sandbox{.limits_calls = true}).find("no Landlock") != std::string::npos);
    CHECK(in_words(Sandbox{.limits_files = true}).find("no seccomp") != std::string::npos);
    CHECK(in_words(Sandbox{}).find("in no sandbox") != std::string::npos);
}
