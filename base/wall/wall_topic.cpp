#include "base/wall/wall_topic.hpp"

#include "base/wall/wall_name.hpp"

#include <array>

namespace vitrine {

namespace {

struct KindWord {
    std::string_view word;
    WallTopic::Kind kind;
    bool has_box;
};

constexpr std::array kinds{
    KindWord{"act", WallTopic::Kind::act, false},       KindWord{"prepare", WallTopic::Kind::prepare, false},
    KindWord{"lifted", WallTopic::Kind::lifted, false}, KindWord{"ready", WallTopic::Kind::ready, true},
    KindWord{"touch", WallTopic::Kind::touch, true},    KindWord{"box", WallTopic::Kind::box, true},
    KindWord{"link", WallTopic::Kind::link, false},
};

}  // namespace

std::optional<WallTopic> wall_topic(std::string_view text) {
    const std::size_t slash = text.find('/');
    const std::string_view box =
        slash == std::string_view::npos ? std::string_view() : text.substr(slash + 1);
    for (const KindWord& kind : kinds) {
        if (text.substr(0, slash) != kind.word || kind.has_box != (slash != std::string_view::npos)) continue;
        if (kind.has_box && !is_wall_name(box)) return std::nullopt;
        return WallTopic{.kind = kind.kind, .box = std::string(box)};
    }
    return std::nullopt;
}

std::string text_of(const WallTopic& topic) {
    for (const KindWord& kind : kinds)
        if (kind.kind == topic.kind) {
            std::string text(kind.word);
            if (kind.has_box) text += "/" + topic.box;
            return text;
        }
    return "";
}

bool is_of_leader(WallTopic::Kind kind) {
    return kind == WallTopic::Kind::act || kind == WallTopic::Kind::prepare ||
           kind == WallTopic::Kind::lifted;
}

}  // namespace vitrine
