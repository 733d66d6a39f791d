#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

/// One thing to do to the weaving child.
struct WeaveAction {
    enum class Kind {
        start,  // one for `path`; finish_weaving() must follow
        pause,  // it stands still
        go_on,  // after a pause
        stop,   // its film changed or went, or gives way to another; finish_weaving() must follow
    };

    Kind kind = Kind::start;
    std::string path;

    bool operator==(const WeaveAction&) const = default;
};

/// The films that may be woven now.
enum class WeaveScope {
    none,    // the films are not there
    wanted,  // something is analysed: only the film that a visitor waits for
    all,     // nothing is to be analysed
};

/// Decides which film's tapestry is woven when: one at a time, the newest first, and only while nothing is to
/// be analysed. The film that a visitor waits for comes before all others, also while something is analysed.
/// Pure: sees no file and no clock.
class WeaveSchedule {
  public:
    static constexpr int max_tries = 2;  // for one content

    /// The film has no tapestry yet. A second request for the same version changes nothing.
    /// @param choice  key of the keyframes that a person has chosen; such films come before others
    void request_film(const std::string& path, std::uint64_t bytes, std::int64_t mtime_ns,
                      const std::string& choice = "");

    /// The film is gone, or its tapestry is not wanted any more.
    void forget_film(const std::string& path);

    /// A visitor waits for the tapestry of this film; "": nobody waits.
    void want_film(const std::string& path) { wanted_ = path; }

    const std::string& wanted_film() const { return wanted_; }

    /// The child of that film has ended. @param is_woven  its tapestry is there
    void finish_weaving(const std::string& path, bool is_woven);

    /// @return the actions to perform now, in this order. Each is given once
    std::vector<WeaveAction> next_actions(WeaveScope scope);

    /// The film that has a child; "" for none.
    const std::string& running_film() const { return running_; }

    /// True where nothing is woven, and nothing will be.
    bool is_idle() const;

  private:
    struct Wish {
        std::uint64_t bytes = 0;
        std::int64_t mtime_ns = 0;
        std::string choice;
        int tries = 0;

        /// Later ones are woven first.
        auto rank() const { return std::pair(!choice.empty(), mtime_ns); }
    };

    using Wishes = std::map<std::string, Wish>;

    std::vector<WeaveAction> next_for_running(WeaveScope scope);
    bool gives_way() const;
    Wishes::iterator next_wish(WeaveScope scope);

    Wishes wishes_;
    std::string running_;
    std::string wanted_;
    bool is_paused_ = false;
    bool is_outdated_ = false;  // the running film is not wanted any more
    bool is_stopping_ = false;
};

}  // namespace vitrine::analyzer
