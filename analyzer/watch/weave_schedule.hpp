#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// One thing to do to the weaving child.
struct WeaveAction {
    enum class Kind {
        start,  // one for `path`; finish_weaving() must follow
        pause,  // it stands still
        go_on,  // after a pause
        stop,   // its film changed or went; finish_weaving() must follow
    };

    Kind kind = Kind::start;
    std::string path;

    bool operator==(const WeaveAction&) const = default;
};

/// Decides which film's tapestry is woven when: one at a time, the newest first, and only while nothing is to
/// be analysed. Pure: sees no file and no clock.
class WeaveSchedule {
  public:
    static constexpr int max_tries = 2;  // for one content

    /// The film has no tapestry yet. A second request for the same content changes nothing.
    void request_film(const std::string& path, std::uint64_t bytes, std::int64_t mtime_ns);

    /// The film is gone, or its tapestry is not wanted any more.
    void forget_film(const std::string& path);

    /// The child of that film has ended. @param is_woven  its tapestry is there
    void finish_weaving(const std::string& path, bool is_woven);

    /// @param is_free  nothing is to be analysed
    /// @return the actions to perform now, in this order. Each is given once
    std::vector<WeaveAction> next_actions(bool is_free);

    /// The film that has a child; "" for none.
    const std::string& running_film() const { return running_; }

    /// True where nothing is woven, and nothing will be.
    bool is_idle() const;

  private:
    struct Wish {
        std::uint64_t bytes = 0;
        std::int64_t mtime_ns = 0;
        int tries = 0;
    };

    std::map<std::string, Wish> wishes_;
    std::string running_;
    bool is_paused_ = false;
    bool is_outdated_ = false;  // the running film is not wanted any more
    bool is_stopping_ = false;
};

}  // namespace vitrine::analyzer
