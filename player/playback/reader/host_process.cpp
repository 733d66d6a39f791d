#include "player/playback/reader/host_process.hpp"

#include "base/media/decoder_table.hpp"
#include "base/media/gst_ptr.hpp"
#include "base/media/still_picture.hpp"
#include "base/system/error.hpp"
#include "base/system/log.hpp"
#include "base/system/message_socket.hpp"
#include "player/playback/reader/reader_messages.hpp"
#include "player/playback/reader/reader_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

constexpr std::size_t max_readers = 64;  // those that a share keeps from ending are counted, too

struct StartedReader {
    pid_t process = -1;
    UniqueFd watch;         // of the process
    MessageSocket its_end;  // a copy: with it the host tells how the reader ended
    bool is_killed = false;
};

class HostProcess {
  public:
    explicit HostProcess(UniqueFd orders) : orders_(std::move(orders)) {}

    /// Returns when the player has closed its end.
    void serve() {
        while (wait_for_news()) {
        }
    }

  private:
    /// False: the player has gone.
    bool wait_for_news() {
        std::vector<pollfd> waits{{.fd = orders_.fd(), .events = POLLIN, .revents = 0}};
        for (const StartedReader& reader : readers_) {
            waits.push_back({.fd = reader.watch.get(), .events = POLLIN, .revents = 0});
            waits.push_back(
                {.fd = reader.is_killed ? -1 : reader.its_end.fd(), .events = POLLRDHUP, .revents = 0});
        }
        if (::poll(waits.data(), waits.size(), -1) < 0) return errno == EINTR;
        auto wait = waits.begin() + 1;
        for (auto reader = readers_.begin(); reader != readers_.end(); wait += 2) {
            if (wait[1].revents != 0) kill(*reader);
            reader = wait[0].revents != 0 ? reap(reader) : std::next(reader);
        }
        return waits.front().revents == 0 || take_order();
    }

    /// The player needs it no more.
    static void kill(StartedReader& reader) {
        ::kill(reader.process, SIGKILL);
        reader.is_killed = true;
    }

    std::list<StartedReader>::iterator reap(std::list<StartedReader>::iterator reader) {
        int status = 0;
        if (::waitpid(reader->process, &status, WNOHANG) == 0) return std::next(reader);
        const EndNote end{.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0,
                          .exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0};
        reader->its_end.send(to_message(end));
        return readers_.erase(reader);
    }

    bool take_order() {
        std::optional<Message> message = orders_.receive(2);
        if (!message) return false;
        const std::optional<ReaderOrder> order = order_in(message->bytes);
        if (!order || message->files.size() != 2) return true;
        MessageSocket its_end(std::move(message->files[0]));
        if (readers_.size() >= max_readers)
            its_end.send(to_message(EndNote{.error = EAGAIN}));
        else
            start(*order, std::move(its_end), std::move(message->files[1]));
        return true;
    }

    void start(const ReaderOrder& order, MessageSocket its_end, UniqueFd memory) {
        const pid_t host = ::getpid();
        const pid_t process = ::fork();
        if (process == 0) {
            readers_.clear();  // their sockets are not this reader's
            orders_ = MessageSocket(UniqueFd());
            become_reader(order, {.player = its_end, .memory = memory, .host = host});
        }
        UniqueFd watch(process < 0 ? -1 : static_cast<int>(::syscall(SYS_pidfd_open, process, 0)));
        if (!watch.is_open()) {
            its_end.send(to_message(EndNote{.error = errno}));
            if (process > 0) ::kill(process, SIGKILL), ::waitpid(process, nullptr, 0);
            return;
        }
        readers_.push_back({.process = process, .watch = std::move(watch), .its_end = std::move(its_end)});
    }

    MessageSocket orders_;
    std::list<StartedReader> readers_;
};

/// Loads all that a reader may need. What is not installed is missing when a film asks for it.
void load_libraries() {
    start_gstreamer();
    std::vector<std::string> elements = decoding_elements();
    for (const char* shaping : {"videoconvertscale", "videoflip", "capsfilter", "appsink"})
        elements.emplace_back(shaping);
    for (const std::string& element : elements) {
        try {
            make_element(element.c_str());
        } catch (const std::exception& error) {
            log::debug("reader host: {}", error.what());
        }
    }
    init_vips();
}

/// Leaves the signals to the player: systemd sends them to all processes of a service.
void ignore_signals() {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGPIPE})
        ::signal(signal, SIG_IGN);
}

}  // namespace

void serve_orders() {
    constexpr int orders = STDERR_FILENO + 1;
    const int taken = ::fcntl(STDIN_FILENO, F_DUPFD, orders);
    const int nothing = ::open("/dev/null", O_RDWR);
    if (taken < 0 || nothing < 0 || ::dup2(nothing, STDIN_FILENO) < 0 || ::dup2(taken, orders) < 0)
        throw_errno("take the orders of the player");
    ::close_range(orders + 1, ~0U, 0);
    for (const char* name : {"NOTIFY_SOCKET", "WATCHDOG_PID", "WATCHDOG_USEC", "LISTEN_PID", "LISTEN_FDS"})
        ::unsetenv(name);
    ::prctl(PR_SET_NAME, "vitrine-host", 0, 0, 0);
    ignore_signals();
    load_libraries();
    HostProcess{UniqueFd(orders)}.serve();
}

}  // namespace vitrine::player
