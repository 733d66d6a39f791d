#include "base/wall/broken_line.hpp"
#include "base/wall/line_connection.hpp"
#include "link/message_queue.hpp"
#include "link/message_rules.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <random>
#include <string>

using namespace vitrine;
using namespace vitrine::link;

namespace {

constexpr int sample = 2000;  // VITRINE_MESSAGES in its place: the test with the label `long`

int count_of_messages() {
    const char* const text = std::getenv("VITRINE_MESSAGES");
    return text == nullptr ? sample : std::atoi(text);
}

/// Messages as a stranger or a box that has gone wrong may send them: whole ones, damaged ones, and any
/// bytes.
struct Hostile {
    std::mt19937 chance;

    std::size_t below(std::size_t end) {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(chance);
    }

    std::string bytes(std::size_t most) {
        std::string made(below(most + 1), '\0');
        for (char& c : made)
            c = static_cast<char>(below(256));
        return made;
    }

    std::string payload() {
        static const std::string whole =
            R"({"version":1,"generation":12,"at":1795591329.152378,"shots":[{"id":"a3","x":0.1,"y":-2e-9,"outline":[[0,0],[1,0],[1,1]]}],"name":"Z\u00fcrich"})";
        switch (below(6)) {
        case 0:
            return bytes(300);
        case 1:
            return std::string(below(3000), "[{\"0-"[below(5)]);
        case 2:
            return "{\"version\":" + std::string(below(400), '9') + "}";
        default:
            return damaged(whole);
        }
    }

    std::string damaged(std::string text) {
        for (std::size_t k = below(6); k > 0 && !text.empty(); --k) {
            const std::size_t at = below(text.size());
            switch (below(4)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.erase(at, 1 + below(20));
                break;
            case 2:
                text.insert(at, text.substr(below(text.size()), 1 + below(40)));
                break;
            default:
                text.insert(at, bytes(8));
            }
        }
        return text;
    }

    std::string topic() {
        static const std::vector<std::string> whole{"vitrine/lobby/act", "vitrine/lobby/prepare",
                                                    "vitrine/lobby/box/left", "vitrine/lobby/ready/left",
                                                    "vitrine/lobby/touch/left"};
        const std::string& one = whole[below(whole.size())];
        return below(4) == 0 ? damaged(one) : one;
    }
};

}  // namespace

TEST_CASE("hostile messages are refused or come out as one line that can be read again") {
    const int count = count_of_messages();
    Hostile hostile{.chance = std::mt19937(20)};
    MessageQueue queue;
    int passed = 0;
    for (int k = 0; k < count; ++k) {
        const WallPlace place{.wall = "lobby", .box = "right", .is_leader = k % 2 == 0};
        try {
            const WallMessage message = checked(received(place, hostile.topic(), hostile.payload()));
            const std::string line = line_of(message);
            const WallMessage again = wall_message(line);
            CHECK(line.find('\n') == std::string::npos);
            CHECK(again.payload == message.payload);
            queue.put(message);
            ++passed;
        } catch (const BrokenLine& broken) {
            CHECK(std::string_view(broken.what()).size() > 0);
        }
    }
    MESSAGE(passed, " of ", count, " messages passed");
    CHECK(passed > count / 50);
    CHECK(passed < count);
    CHECK(queue.size() <= MessageQueue::max_messages);
}

TEST_CASE("hostile lines of a player are refused or read") {
    Hostile hostile{.chance = std::mt19937(21)};
    const WallPlace place{.wall = "lobby", .box = "right", .is_leader = false};
    LineSplitter splitter(max_wall_line);
    int passed = 0;
    for (int k = 0; k < count_of_messages(); ++k) {
        const std::string whole =
            R"({"topic":"touch/right","retain":false,"payload":)" + hostile.payload() + "}\n";
        for (const std::string& line : splitter.push(hostile.below(2) == 0 ? hostile.damaged(whole) : whole))
            try {
                const WallMessage message = wall_message(line);
                check_sent(place, message);
                ++passed;
            } catch (const BrokenLine&) {
            }
    }
    CHECK(passed > 0);
}
