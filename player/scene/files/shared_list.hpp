#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// Items, ordered by their path, that several parts of the player and several of its threads keep at the same
/// time. Copies share the items in blocks, and an item never changes. So for n items a copy costs about n /
/// 128 steps, a changed item the copy of one block, and a comparison of two versions looks only into the
/// blocks that differ.
/// @tparam Item  has a member `path`; no two items of a list have the same
template <typename Item> class SharedList {
  public:
    using Entry = std::shared_ptr<const Item>;

    /// The new entry of each path. None: the path has none any more.
    using Changes = std::map<std::string, Entry>;

    static constexpr std::size_t max_block = 256;

  private:
    using Block = std::vector<Entry>;  // never empty
    using Blocks = std::vector<std::shared_ptr<const Block>>;

  public:
    class Iterator {
      public:
        using iterator_category = std::forward_iterator_tag;
        using value_type = Entry;
        using difference_type = std::ptrdiff_t;
        using pointer = const Entry*;
        using reference = const Entry&;

        Iterator() = default;

        explicit Iterator(typename Blocks::const_iterator block) : block_(block) {}

        reference operator*() const { return (**block_)[at_]; }

        pointer operator->() const { return &**this; }

        Iterator& operator++() {
            if (++at_ == (*block_)->size()) skip_block();
            return *this;
        }

        Iterator operator++(int) {
            Iterator before = *this;
            ++*this;
            return before;
        }

        bool operator==(const Iterator&) const = default;

        /// True: from here on both lists share a block.
        bool begins_same_block(const Iterator& other) const {
            return at_ == 0 && other.at_ == 0 && *block_ == *other.block_;
        }

        void skip_block() {
            ++block_;
            at_ = 0;
        }

      private:
        typename Blocks::const_iterator block_{};
        std::size_t at_ = 0;  // in the block
    };

    SharedList() = default;

    /// Orders the entries. Of several with the same path the first stays.
    explicit SharedList(std::vector<Entry> entries) {
        const auto is_before = [](const Entry& a, const Entry& b) { return a->path < b->path; };
        if (!std::ranges::is_sorted(entries, is_before)) std::ranges::stable_sort(entries, is_before);
        const auto have_same_path = [](const Entry& a, const Entry& b) { return a->path == b->path; };
        entries.erase(std::unique(entries.begin(), entries.end(), have_same_path), entries.end());
        append(blocks_, std::move(entries));
        count();
    }

    /// Replaces, adds and removes entries.
    void apply(const Changes& changes) {
        Blocks blocks;
        blocks.reserve(blocks_.size() + 1);
        auto change = changes.begin();
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            const bool is_last = i + 1 == blocks_.size();
            const auto end = is_last ? changes.end() : changes.lower_bound(first_path(blocks_[i + 1]));
            if (change == end)
                blocks.push_back(blocks_[i]);
            else
                append(blocks, merged(*blocks_[i], change, end));
            change = end;
        }
        if (change != changes.end()) append(blocks, merged({}, change, changes.end()));
        blocks_ = std::move(blocks);
        count();
    }

    /// None: no entry has this path.
    Entry find(const std::string& path) const {
        const auto after = std::ranges::upper_bound(blocks_, path, {}, first_path);
        if (after == blocks_.begin()) return nullptr;
        const Block& block = **std::prev(after);
        const auto found = std::ranges::lower_bound(block, path, {}, path_of);
        return found != block.end() && (*found)->path == path ? *found : nullptr;
    }

    bool contains(const std::string& path) const { return find(path) != nullptr; }

    /// @pre not empty
    const Entry& last() const { return blocks_.back()->back(); }

    /// The entries whose paths are not before `first`, and before `end`.
    SharedList between(const std::string& first, const std::string& end) const {
        SharedList part;
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            const bool is_last = i + 1 == blocks_.size();
            if (!is_last && first_path(blocks_[i + 1]) <= first) continue;
            if (first_path(blocks_[i]) >= end) break;
            const Block& block = *blocks_[i];
            const auto from = std::ranges::lower_bound(block, first, {}, path_of);
            const auto to = std::ranges::lower_bound(block, end, {}, path_of);
            if (from == block.begin() && to == block.end())
                part.blocks_.push_back(blocks_[i]);
            else
                append(part.blocks_, {from, to});
        }
        part.count();
        return part;
    }

    /// Calls use(before, now) for each path that has another entry than in an earlier version of the list, in
    /// the order of paths. An entry that is missing in one of the two is none there.
    template <typename Use> void for_each_change(const SharedList& earlier, const Use& use) const {
        Iterator before = earlier.begin(), now = begin();
        const Iterator before_end = earlier.end(), now_end = end();
        while (before != before_end || now != now_end) {
            if (before != before_end && now != now_end && before.begins_same_block(now)) {
                before.skip_block();
                now.skip_block();
                continue;
            }
            const int order = before == before_end ? 1
                              : now == now_end     ? -1
                                                   : (*before)->path.compare((*now)->path);
            const Entry none;
            if (order != 0 || *before != *now) use(order > 0 ? none : *before, order < 0 ? none : *now);
            if (order <= 0) ++before;
            if (order >= 0) ++now;
        }
    }

    Iterator begin() const { return Iterator(blocks_.begin()); }

    Iterator end() const { return Iterator(blocks_.end()); }

    std::size_t size() const { return size_; }

    bool is_empty() const { return size_ == 0; }

  private:
    static const std::string& path_of(const Entry& entry) { return entry->path; }

    static const std::string& first_path(const std::shared_ptr<const Block>& block) {
        return block->front()->path;
    }

    static Block merged(const Block& block, typename Changes::const_iterator change,
                        typename Changes::const_iterator end) {
        Block all;
        all.reserve(block.size() + static_cast<std::size_t>(std::distance(change, end)));
        auto old = block.begin();
        for (; change != end; ++change) {
            for (; old != block.end() && (*old)->path < change->first; ++old)
                all.push_back(*old);
            if (old != block.end() && (*old)->path == change->first) ++old;
            if (change->second) all.push_back(change->second);
        }
        all.insert(all.end(), old, block.end());
        return all;
    }

    /// Appends the entries in blocks of about the same size.
    static void append(Blocks& blocks, Block entries) {
        if (entries.empty()) return;
        const std::size_t pieces = (entries.size() + max_block - 1) / max_block;
        auto from = std::make_move_iterator(entries.begin());
        for (std::size_t i = 0; i < pieces; ++i) {
            const auto to = std::make_move_iterator(
                entries.begin() + static_cast<std::ptrdiff_t>((i + 1) * entries.size() / pieces));
            blocks.push_back(std::make_shared<const Block>(from, to));
            from = to;
        }
    }

    void count() {
        size_ = 0;
        for (const auto& block : blocks_)
            size_ += block->size();
    }

    Blocks blocks_;
    std::size_t size_ = 0;
};

}  // namespace vitrine::player
