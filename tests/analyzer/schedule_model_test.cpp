#include "analyzer/schedule.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>

using namespace vitrine;
using namespace std::chrono_literals;
using Kind = Action::Kind;

namespace {

/// A folder, its catalogue and its children as plain maps, and somebody who does anything in any order. The
/// rules of the schedule are checked at each step, and in the end that the catalogue says what is in the
/// folder.
class Model {
  public:
    explicit Model(std::uint32_t seed) : random_(seed), schedule_(pace) {}

    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            act();
            now_ += std::chrono::milliseconds(number(0, 900));
            advance();
        }
        come_to_rest();
    }

  private:
    struct File {
        FileFacts facts;
        Schedule::Time changed{};
        Answer nature = Answer::final;  // what a child makes of this content
    };

    struct Record {
        FileFacts facts;
        Answer state = Answer::final;

        bool holds_for(const File& file) const {
            return is_same_content(facts, file.facts) && state == file.nature;
        }
    };

    static constexpr Pace pace{.children = 2};

    int number(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }

    std::string name() { return std::string(1, static_cast<char>('a' + number(0, 4))); }

    void act() {
        switch (number(0, 7)) {
        case 0:
        case 1:
            return write(name());
        case 2:
            return remove(name());
        case 3:
            return rename(name(), name());
        case 4:
            return rescan();
        case 5:
            return see(name());  // an event too many
        default:
            return end_child();
        }
    }

    void write(const std::string& path) {
        File& file = files_[path];
        if (file.facts.inode == 0) file.facts.inode = ++inodes_;
        file.facts.bytes = static_cast<std::uint64_t>(number(1, 100));
        file.facts.mtime_ns = ++clock_ns_;
        file.changed = now_;
        file.nature = std::array{Answer::final, Answer::final, Answer::waiting, Answer::died}.at(
            static_cast<std::size_t>(number(0, 3)));
        if (number(0, 3) > 0) see(path);  // else the kernel says nothing: a network share
    }

    void remove(const std::string& path) {
        files_.erase(path);
        if (number(0, 3) > 0) see(path);
    }

    void rename(const std::string& from, const std::string& to) {
        if (from == to || !files_.contains(from)) return;
        files_[to] = files_.at(from);
        files_.erase(from);
        if (number(0, 3) == 0) return;
        see(from);
        see(to);
    }

    void see(const std::string& path) {
        if (files_.contains(path))
            schedule_.saw(path, files_.at(path).facts, 0s, now_);
        else
            schedule_.gone(path, now_);
    }

    void rescan() {
        for (const std::string& path : schedule_.paths_below(""))
            if (!files_.contains(path)) see(path);
        for (const auto& [path, file] : files_)
            schedule_.saw(path, file.facts, now_ - file.changed, now_);
    }

    void end_child() {
        if (children_.empty()) return;
        const auto child = std::next(children_.begin(), number(0, static_cast<int>(children_.size()) - 1));
        const std::string path = child->first;
        const File analysed = child->second;
        children_.erase(child);
        see(path);  // as the daemon does
        const Verdict verdict = schedule_.finished(path, analysed.nature, now_);
        if (verdict == Verdict::discard || verdict == Verdict::retry) return;
        CHECK(files_.contains(path));
        CHECK((verdict == Verdict::quarantine) == (analysed.nature == Answer::died));
        catalogue_[path] = {analysed.facts, analysed.nature};
    }

    void advance() {
        for (const std::string& path : schedule_.to_look_at(now_))
            see(path);
        for (const Action& action : schedule_.step(now_))
            perform(action);
        CHECK(children_.size() <= pace.children);
    }

    void perform(const Action& action) {
        switch (action.kind) {
        case Kind::start:
            CHECK_FALSE(children_.contains(action.path));
            children_[action.path] = {action.facts, now_,
                                      files_.contains(action.path) ? files_.at(action.path).nature
                                                                   : Answer::final};
            return;
        case Kind::stop:
            CHECK(children_.contains(action.path));
            return;
        case Kind::hold:
            catalogue_[action.path] = {action.facts, Answer::waiting};
            return;
        case Kind::move:
            REQUIRE(catalogue_.contains(action.from));
            CHECK(is_same_content(catalogue_.at(action.from).facts, action.facts));
            catalogue_[action.path] = catalogue_.at(action.from);
            catalogue_.erase(action.from);
            return;
        case Kind::remove:
            catalogue_.erase(action.path);
            return;
        }
    }

    /// Nobody touches the folder any more.
    void come_to_rest() {
        for (int i = 0; i < 100 || !children_.empty(); ++i) {
            REQUIRE(i < 1000);
            now_ += 1min;
            rescan();
            advance();
            end_child();
        }
        CHECK(schedule_.is_idle());
        for (const auto& [path, file] : files_) {
            INFO(path);
            REQUIRE(catalogue_.contains(path));
            CHECK(catalogue_.at(path).holds_for(file));
        }
        CHECK(catalogue_.size() == files_.size());
    }

    std::mt19937 random_;
    Schedule schedule_;
    Schedule::Time now_{1h};
    std::map<std::string, File> files_;
    std::map<std::string, File> children_;
    std::map<std::string, Record> catalogue_;
    std::int64_t clock_ns_ = 0;
    std::uint64_t inodes_ = 0;
};

}  // namespace

TEST_CASE("whatever is done to a folder in whatever order, the catalogue says in the end what is in it") {
    for (std::uint32_t seed = 1; seed <= 400; ++seed) {
        CAPTURE(seed);
        Model(seed).run(60);
    }
}
