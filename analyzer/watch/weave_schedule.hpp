#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// What is to be done to the weaving child.
struct WeaveAction {
    enum class Kind {
        start,  // one for `path`; finished() must follow
        pause,  // it stands still
        go_on,
        stop,  // its film changed or went; finished() must follow
    };

    Kind kind = Kind::start;
    std::string path;

    friend bool operator==(const WeaveAction&, const WeaveAction&) = default;
};

/// Decides which film's tapestry is woven when: one at a time, the newest first, and only while nothing is to
/// be analysed. Pure: sees no file and no clock.
class WeaveSchedule {
  public:
    static constexpr int most_tries = 2;  // a content

    /// The film has no tapestry yet. What is said of it a second time counts nothing.
    void want(const std::string& path, std::uint64_t bytes, std::int64_t mtime_ns);

    /// It is gone, or its tapestry is not wanted any more.
    void forget(const std::string& path);

    /// The child of that film has ended. @param is_woven  its tapestry is there
    void finished(const std::string& path, bool is_woven);

    /// @param is_free  nothing is to be analysed
    /// @return what to do now, in this order. Each action is given once
    std::vector<WeaveAction> step(bool is_free);

    /// The film whose child there is; "" for none.
    const std::string& running() const { return running_; }

    /// Nothing is woven, and nothing will be.
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
    bool is_outdated_ = false;  // what runs is not wanted any more
    bool is_stopping_ = false;
};

}  // namespace vitrine::analyzer
