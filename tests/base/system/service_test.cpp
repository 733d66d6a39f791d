#include "base/system/service.hpp"

#include "base/system/unique_fd.hpp"
#include "tests/temporary_directory.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <utility>

using namespace vitrine;

namespace {

UniqueFd socket_at(const std::string& path) {
    UniqueFd fd(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    REQUIRE(path.size() < sizeof address.sun_path);
    std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
    REQUIRE(::bind(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
    return fd;
}

std::string received(const UniqueFd& fd) {
    std::array<char, 512> buffer;
    const ssize_t n = ::recv(fd.get(), buffer.data(), buffer.size(), MSG_DONTWAIT);
    return n < 0 ? "" : std::string(buffer.data(), static_cast<std::size_t>(n));
}

/// The next message, and the descriptor that comes with it.
std::pair<std::string, UniqueFd> received_with_descriptor(const UniqueFd& fd) {
    std::array<char, 512> text{};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int)) + CMSG_SPACE(sizeof(ucred))> control{};
    iovec part{.iov_base = text.data(), .iov_len = text.size()};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    const ssize_t n = ::recvmsg(fd.get(), &message, MSG_DONTWAIT | MSG_CMSG_CLOEXEC);
    if (n < 0) return {};
    UniqueFd taken;
    for (cmsghdr* part_of = CMSG_FIRSTHDR(&message); part_of; part_of = CMSG_NXTHDR(&message, part_of)) {
        if (part_of->cmsg_level != SOL_SOCKET || part_of->cmsg_type != SCM_RIGHTS) continue;
        int sent = -1;
        std::memcpy(&sent, CMSG_DATA(part_of), sizeof sent);
        taken.reset(sent);
    }
    return {std::string(text.data(), static_cast<std::size_t>(n)), std::move(taken)};
}

bool is_same_file(int a, int b) {
    struct stat first {};

    struct stat second {};

    return ::fstat(a, &first) == 0 && ::fstat(b, &second) == 0 && first.st_ino == second.st_ino &&
           first.st_dev == second.st_dev;
}

}  // namespace

TEST_CASE("systemd is told what the service does, in one line, and where there is none nothing happens") {
    const TemporaryDirectory directory;
    const std::string path = (directory.path / "notify").string();
    const UniqueFd systemd = socket_at(path);
    ::unsetenv("NOTIFY_SOCKET");
    service::ready("nobody hears this");
    CHECK(received(systemd).empty());

    ::setenv("NOTIFY_SOCKET", path.c_str(), 1);
    service::ready("3 files\nFDSTORE=1");
    CHECK(received(systemd) == "READY=1\nSTATUS=3 files FDSTORE=1");
    service::feed_watchdog();
    CHECK(received(systemd) == "WATCHDOG=1");
    service::stopping();
    CHECK(received(systemd) == "STOPPING=1");
    ::unsetenv("NOTIFY_SOCKET");
}

TEST_CASE("the watchdog's interval is what systemd set, or nothing") {
    ::unsetenv("WATCHDOG_USEC");
    CHECK_FALSE(service::watchdog_interval().has_value());
    ::setenv("WATCHDOG_USEC", "20000000", 1);
    CHECK(service::watchdog_interval() == std::chrono::seconds(20));
    ::unsetenv("WATCHDOG_USEC");
}

TEST_CASE("systemd is given a descriptor to hold in place of the one before, and told to let go of it") {
    const TemporaryDirectory directory;
    const std::string path = (directory.path / "notify").string();
    const UniqueFd systemd = socket_at(path);
    ::setenv("NOTIFY_SOCKET", path.c_str(), 1);
    const UniqueFd file(::open(directory.write("card", "x").c_str(), O_RDWR | O_CLOEXEC));

    service::hold("card", file.get());

    CHECK(received(systemd) == "FDSTOREREMOVE=1\nFDNAME=card");
    const auto [told, held] = received_with_descriptor(systemd);
    CHECK(told == "FDSTORE=1\nFDNAME=card");
    CHECK(is_same_file(held.get(), file.get()));
    service::forget("card");
    CHECK(received(systemd) == "FDSTOREREMOVE=1\nFDNAME=card");
    ::unsetenv("NOTIFY_SOCKET");
}

TEST_CASE("what the process before had held is found by its name, all else that was handed over is closed") {
    const TemporaryDirectory directory;
    const UniqueFd card(::open(directory.write("card", "x").c_str(), O_RDWR | O_CLOEXEC));
    const UniqueFd other(::open(directory.write("other", "x").c_str(), O_RDWR | O_CLOEXEC));
    const pid_t child = ::fork();  // whose descriptors are as systemd leaves them
    if (child == 0) {
        const UniqueFd far_card(::fcntl(card.get(), F_DUPFD, 20));
        const UniqueFd far_other(::fcntl(other.get(), F_DUPFD, 20));
        ::dup2(far_other.get(), 3);
        ::dup2(far_card.get(), 4);
        ::setenv("LISTEN_PID", std::to_string(::getpid()).c_str(), 1);
        ::setenv("LISTEN_FDS", "2", 1);
        ::setenv("LISTEN_FDNAMES", "other:card", 1);
        const UniqueFd found = service::held("card");
        const bool is_closed = ::fcntl(3, F_GETFD) < 0;
        const bool is_taken_once = !service::held("card").is_open();
        ::_exit(is_same_file(found.get(), far_card.get()) && is_closed && is_taken_once ? 0 : 1);
    }
    int status = -1;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(status == 0);
}
