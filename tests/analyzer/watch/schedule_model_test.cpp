#include "analyzer/watch/schedule.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <random>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;
using Kind = Action::Kind;

namespace {

/// A folder, its catalogue and its children as plain maps, and somebody who does anything in any order: files
/// are created, written in parts, closed too early, renamed, overwritten, deleted; the kernel loses events;
/// the share goes and comes back; the analyzer starts anew; clocks are set; children end well, crash or hang.
/// The rules are checked at each step:
///
/// - what is not whole is never in the catalogue as ready. Of files whose half cannot be told from the whole
///   (`is_sly`: a transport stream) that can only hold while their writer neither pauses for as long as the
///   quiet time, nor closes or renames early;
/// - no more children than allowed, and none of a file that has one;
/// - once nobody touches the folder, all that is whole is ready and all that was deleted is gone, both soon.
class Model {
  public:
    explicit Model(std::uint32_t seed) : random_(seed) {}

    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            act();
            pass(std::chrono::milliseconds(number(0, 900)));
        }
        come_to_rest();
    }

  private:
    struct File {
        FileFacts facts;
        bool is_whole = false;
        bool is_sly = false;
        Answer nature = Answer::final;  // a child's answer once the file is whole

        Answer answer() const { return is_whole || is_sly ? nature : Answer::waiting; }
    };

    struct Writer {
        std::uint64_t inode = 0;
        int parts = 1;                 // still to come
        bool is_reserving = false;     // the size is the last from the beginning; only the blocks grow
        bool has_coarse_time = false;  // the file system's times are coarse: the mtime stays
        Schedule::Time written{};
    };

    struct Child {
        File file;  // the file at the child's start
        Schedule::Time start{};
    };

    struct Record {
        FileFacts facts;
        Answer state = Answer::final;
    };

    static constexpr Pace pace{.children = 2, .death_memory = {}};
    static constexpr auto run_time = 1s;  // the run of a child that nobody ends earlier

    int number(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }

    bool chance(int percent) { return number(1, 100) <= percent; }

    std::string name() { return std::string(1, static_cast<char>('a' + number(0, 4))); }

    void act() {
        switch (number(0, 13)) {
        case 0:
        case 1:
        case 2:
            return begin_to_write(name());
        case 3:
        case 4:
            return write_some();
        case 5:
            return remove(name());
        case 6:
            return rename(name(), name());
        case 7:
            return rescan();  // it follows an overflow of the queue
        case 8:
            return see(name(), LookKind::local);  // an event too many
        case 9:
            is_deaf_ = !is_deaf_;  // events are lost
            return;
        case 10:
            return go_or_return();
        case 11:
            clock_ns_ += chance(50) ? -5'000 : 5'000;  // the clock is set, be it to a time that was before
            return;
        case 12:
            return chance(20) ? restart() : end_child();
        default:
            return end_child();
        }
    }

    Writer* writer_of(const File& file) {
        const auto found = std::find_if(writers_.begin(), writers_.end(), [&](const Writer& writer) {
            return writer.inode == file.facts.inode;
        });
        return found == writers_.end() ? nullptr : &*found;
    }

    /// A new file, or an overwritten one: its inode stays.
    void begin_to_write(const std::string& path) {
        File& file = files_[path];
        if (writer_of(file) != nullptr) return;
        if (file.facts.inode == 0) file.facts.inode = ++inodes_;
        Writer writer{.inode = file.facts.inode,
                      .parts = number(1, 4),
                      .is_reserving = chance(30),
                      .has_coarse_time = chance(30),
                      .written = now_};
        file.is_whole = false;
        file.is_sly = chance(30);
        file.nature = chance(75) ? Answer::final : Answer::died;
        file.facts.bytes = writer.is_reserving ? ++sizes_ * 100 : 0;
        file.facts.blocks = 0;
        file.facts.mtime_ns = ++clock_ns_ * 1000 + static_cast<std::int64_t>(++sizes_);
        writers_.push_back(writer);
    }

    void write_some() {
        if (!writers_.empty())
            write_part(
                writers_.at(static_cast<std::size_t>(number(0, static_cast<int>(writers_.size()) - 1))));
    }

    void write_part(Writer& writer) {
        const auto found = std::find_if(files_.begin(), files_.end(), [&](const auto& candidate) {
            return candidate.second.facts.inode == writer.inode;
        });
        writer.written = now_;
        bool is_over = found == files_.end();  // deleted: it is written into nothing
        if (!is_over) {
            auto& [path, file] = *found;
            if (!writer.is_reserving) file.facts.bytes += ++sizes_;
            if (!writer.has_coarse_time)
                file.facts.mtime_ns = ++clock_ns_ * 1000 + static_cast<std::int64_t>(++sizes_);
            ++file.facts.blocks;
            is_over = file.is_whole = --writer.parts <= 0;
            if (is_over || (!file.is_sly && chance(20))) happens(path, LookKind::closed);
        }
        if (is_over)
            std::erase_if(writers_, [&, inode = writer.inode](const Writer& w) { return w.inode == inode; });
    }

    void remove(const std::string& path) {
        files_.erase(path);
        happens(path, LookKind::local);
    }

    void rename(const std::string& from, const std::string& to) {
        const auto file = files_.find(from);
        if (from == to || file == files_.end() || (file->second.is_sly && !file->second.is_whole)) return;
        files_[to] = file->second;
        files_.erase(from);
        happens(from, LookKind::local);
        happens(to, LookKind::closed);
    }

    /// The kernel reports it, unless events are being lost.
    void happens(const std::string& path, LookKind sight) {
        if (!is_deaf_) see(path, sight);
    }

    void see(const std::string& path, LookKind sight) {
        if (is_away_) return;
        if (files_.contains(path))
            schedule_.see_file(path, files_.at(path).facts, now_, sight);
        else
            schedule_.lose_file(path, now_);
    }

    void rescan() {
        if (is_away_) return;
        for (const std::string& path : schedule_.paths_below(""))
            if (!files_.contains(path)) see(path, LookKind::local);
        for (const auto& [path, file] : files_)
            see(path, LookKind::local);
    }

    /// The share is unmounted, or there again.
    void go_or_return() {
        is_away_ = !is_away_;
        rescan();
    }

    /// The analyzer was killed; all it has is the catalogue.
    void restart() {
        children_.clear();
        schedule_ = Schedule(pace);
        for (const auto& [path, record] : catalogue_) {
            const bool is_held = record.state == Answer::waiting;
            schedule_.add_recorded(path, {.bytes = record.facts.bytes, .mtime_ns = record.facts.mtime_ns},
                                   !is_held, is_held);
        }
        rescan();
    }

    void end_child() {
        if (children_.empty()) return;
        end(std::next(children_.begin(), number(0, static_cast<int>(children_.size()) - 1))->first);
    }

    void end(std::string path) {  // a copy: its owner is erased
        const Child child = children_.at(path);
        const bool is_there = files_.contains(path) && files_.at(path).facts.inode == child.file.facts.inode;
        children_.erase(path);
        see(path, LookKind::local);  // the daemon does the same
        const Answer answer = is_there && chance(50) ? files_.at(path).answer() : child.file.answer();
        const Verdict verdict = schedule_.finish_analysis(path, answer, now_);
        if (verdict == Verdict::discard || verdict == Verdict::retry) return;
        CHECK((verdict == Verdict::quarantine) == (answer == Answer::died));
        catalogue_[path] = {child.file.facts, answer};
    }

    void pass(std::chrono::milliseconds time) {
        now_ += time;
        for (std::size_t i = writers_.size(); i-- > 0;) {
            Writer& writer = writers_[i];
            const auto file = std::find_if(files_.begin(), files_.end(), [&](const auto& f) {
                return f.second.facts.inode == writer.inode;
            });
            const bool is_steady = file != files_.end() && file->second.is_sly;
            if (is_steady && now_ - writer.written > 900ms) write_part(writer);
        }
        for (const std::string& path : schedule_.files_to_look_at(now_))
            see(path, LookKind::local);
        for (const Action& action : schedule_.next_actions(now_))
            perform(action);
        CHECK(children_.size() <= pace.children + 1);  // an empty file is a small one
        check_nothing_half_is_ready();
    }

    void check_nothing_half_is_ready() {
        for (const auto& entry : catalogue_) {
            const std::string& path = entry.first;
            const auto& record = entry.second;
            const auto file = files_.find(path);
            if (record.state != Answer::final || file == files_.end()) continue;
            INFO(path);
            CHECK((file->second.is_whole || !is_same_content(record.facts, file->second.facts)));
        }
    }

    void perform(const Action& action) {
        switch (action.kind) {
        case Kind::start:
            CHECK_FALSE(children_.contains(action.path));
            children_[action.path] = {.file = files_.contains(action.path) ? files_.at(action.path) : File{},
                                      .start = now_};
            children_[action.path].file.facts = action.facts;
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

    bool is_settled() const {
        const bool has_all = std::all_of(files_.begin(), files_.end(), [&](const auto& entry) {
            const auto record = catalogue_.find(entry.first);
            return record != catalogue_.end() && is_same_content(record->second.facts, entry.second.facts) &&
                   record->second.state == entry.second.answer();
        });
        return has_all && catalogue_.size() == files_.size();
    }

    /// The writers end or die, nobody touches the folder any more, and the next rescan finds all there is.
    void come_to_rest() {
        while (!writers_.empty() && chance(70))
            write_some();
        for (const Writer& writer : writers_)  // died: of a sly file nobody could tell
            std::erase_if(files_, [&](const auto& f) {
                return f.second.is_sly && f.second.facts.inode == writer.inode;
            });
        writers_.clear();
        is_away_ = is_deaf_ = false;
        rescan();
        constexpr auto bound =
            2s + 2 * 5 * run_time + 500ms;  // the quiet time, each file dying twice, a rename's grace
        const Schedule::Time latest = now_ + bound;
        while (now_ < latest && !is_settled()) {
            pass(100ms);
            for (const std::string& path : ended())
                end(path);
        }
        for (const auto& entry : files_) {
            const std::string& path = entry.first;
            const auto& file = entry.second;
            INFO(path);
            REQUIRE(catalogue_.contains(path));
            CHECK(is_same_content(catalogue_.at(path).facts, file.facts));
            CHECK(catalogue_.at(path).state == file.answer());
        }
        CHECK(catalogue_.size() == files_.size());
    }

    std::vector<std::string> ended() const {
        std::vector<std::string> paths;
        for (const auto& [path, child] : children_)
            if (now_ - child.start >= run_time) paths.push_back(path);
        return paths;
    }

    std::mt19937 random_;
    Schedule schedule_{pace};
    Schedule::Time now_{1h};
    std::map<std::string, File> files_;
    std::vector<Writer> writers_;
    std::map<std::string, Child> children_;
    std::map<std::string, Record> catalogue_;
    std::int64_t clock_ns_ = 1'000'000;
    std::uint64_t inodes_ = 0, sizes_ = 0;
    bool is_deaf_ = false, is_away_ = false;
};

}  // namespace

TEST_CASE(
    "whatever is done to a folder in whatever order, nothing half is shown and the catalogue follows soon") {
    for (std::uint32_t seed = 1; seed <= 3000; ++seed) {
        CAPTURE(seed);
        Model(seed).run(60);
    }
}
