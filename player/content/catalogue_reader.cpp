#include "player/content/catalogue_reader.hpp"

#include "base/hints/notice.hpp"
#include "base/state/record_json.hpp"
#include "base/system/atomic_file.hpp"

#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace fs = std::filesystem;

namespace {

template <typename T> void append(std::vector<T>& to, std::vector<T>& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// All of its pictures must be visible.
void show_whole(MediaRecord& record) {
    for (Shot& shot : record.shots) {
        const Box all = active_picture(record, shot);
        shot.region = {.polygon = {all.min, {all.max.x, all.min.y}, all.max, {all.min.x, all.max.y}},
                       .drift = {}};
    }
}

/// Adds what was read later to news that nobody has fetched yet.
CatalogueNews merged(CatalogueNews before, CatalogueNews after) {
    append(before.change.added, after.change.added);
    append(before.change.grown, after.change.grown);
    append(before.change.replaced, after.change.replaced);
    append(before.change.gone, after.change.gone);
    after.change = std::move(before.change);
    after.change.has_others = true;  // a file may be in two lists: whoever needs more looks at the records
    after.unreadable.merge(before.unreadable);
    return after;
}

}  // namespace

CatalogueReader::CatalogueReader(Catalogue catalogue, std::function<void()> on_news)
    : catalogue_(std::move(catalogue)), on_news_(std::move(on_news)), thread_([this] { run(); }) {}

CatalogueReader::~CatalogueReader() {
    {
        const std::lock_guard lock(mutex_);
        is_stopping_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

void CatalogueReader::request_files(const std::set<std::string>& names) {
    {
        const std::lock_guard lock(mutex_);
        request_.names.insert(names.begin(), names.end());
    }
    wake_.notify_all();
}

void CatalogueReader::request_all() {
    {
        const std::lock_guard lock(mutex_);
        request_.is_all = true;
    }
    wake_.notify_all();
}

void CatalogueReader::finish() {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, [this] { return request_.is_empty() && !is_reading_; });
}

std::optional<CatalogueNews> CatalogueReader::pop_news() {
    const std::lock_guard lock(mutex_);
    return std::exchange(news_, std::nullopt);
}

void CatalogueReader::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock, [this] { return is_stopping_ || !request_.is_empty(); });
        if (is_stopping_) return;
        Request request = std::exchange(request_, {});
        is_reading_ = true;
        lock.unlock();
        CatalogueNews news = read(std::move(request));
        const bool is_news = !news.change.is_empty() || !news.unreadable.empty();
        lock.lock();
        is_reading_ = false;
        if (is_news) news_ = news_ ? merged(std::move(*news_), std::move(news)) : std::move(news);
        wake_.notify_all();
        if (!is_news) continue;
        lock.unlock();
        on_news_();
        lock.lock();
    }
}

CatalogueNews CatalogueReader::read(Request request) {
    if (request.is_all) {
        for (const auto& [name, record] : records_)
            request.names.insert(name);
        std::error_code missing;
        for (const fs::directory_entry& entry : fs::directory_iterator(catalogue_.directory(), missing))
            request.names.insert(entry.path().filename().string());
    }
    CatalogueNews news;
    Records before, after;
    for (const std::string& name : request.names) {
        if (fs::path(name).extension() != ".json") continue;
        const auto known = records_.find(name);
        RecordList::Record record = read_record(name, news);
        if (known != records_.end()) {
            if (record && *record == *known->second) continue;
            before.push_back(known->second);
            records_.erase(known);
        }
        if (!record) continue;
        after.push_back(record);
        records_.emplace(name, std::move(record));
    }
    if (before.empty() && after.empty()) return news;
    update_list(before, after);
    news.change = change_between(RecordList(std::move(before)), RecordList(std::move(after)));
    news.records = list_;
    news.groups = groups_.groups();
    news.counts = counts_;
    return news;
}

void CatalogueReader::update_list(const Records& before, const Records& after) {
    RecordList::Changes changes;
    for (const RecordList::Record& record : before) {
        if (--counts_[record->state] == 0) counts_.erase(record->state);
        if (list_.find(record->path) == record) changes[record->path] = nullptr;
    }
    for (const RecordList::Record& record : after) {
        ++counts_[record->state];
        changes[record->path] = record;
    }
    list_.apply(changes);
    groups_.set_files(list_);
}

/// One unreadable record never hides the others.
RecordList::Record CatalogueReader::read_record(const std::string& name, CatalogueNews& news) {
    const fs::path file = catalogue_.directory() / name;
    std::error_code unknown;
    if (!fs::exists(file, unknown)) return nullptr;
    try {
        MediaRecord record = record_from_json(read_file(file));
        unreadable_.erase(name);
        if (notice_named(record.path)) show_whole(record);
        return std::make_shared<const MediaRecord>(std::move(record));
    } catch (const std::runtime_error& error) {  // damaged, or replaced just now
        if (unreadable_.insert(name).second) news.unreadable.emplace(file.string(), error.what());
        return nullptr;
    }
}

}  // namespace vitrine::player
