#include "player/words/word_loader.hpp"

#include "base/media/photo_file.hpp"
#include "base/media/still_picture.hpp"
#include "base/media/vips_steps.hpp"
#include "base/state/word_picture.hpp"

#include <algorithm>
#include <cstring>
#include <exception>
#include <system_error>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int max_width = 4096;  // px
constexpr int max_height = 512;
constexpr int bands = 4;

std::shared_ptr<const WordPicture> read_word(const std::filesystem::path& file) {
    start_vips();
    PhotoFile photo(file.string());
    const VipsPtr<VipsSource> source = open_source(photo);
    const VipsPtr<VipsImage> read =
        step([&](auto** out) { return vips_pngload_source(source.get(), out, nullptr); });
    const VipsPtr<VipsImage> image = step([&](auto** out) {  // an opaque picture comes without opacity
        return vips_image_hasalpha(read.get()) != 0 ? vips_copy(read.get(), out, nullptr)
                                                    : vips_addalpha(read.get(), out, nullptr);
    });
    const int width = vips_image_get_width(image.get());
    const int height = vips_image_get_height(image.get());
    if (width > max_width || height > max_height || vips_image_get_bands(image.get()) != bands ||
        vips_image_get_format(image.get()) != VIPS_FORMAT_UCHAR)
        return nullptr;
    const VipsPtr<VipsImage> whole =
        step([&](auto** out) { return (*out = vips_image_copy_memory(image.get())) != nullptr ? 0 : -1; });
    auto picture = std::make_shared<WordPicture>();
    picture->width = width;
    picture->height = height;
    picture->rgba.resize(static_cast<std::size_t>(width) * height * bands);
    std::memcpy(picture->rgba.data(), vips_image_get_data(whole.get()), picture->rgba.size());
    return picture;
}

}  // namespace

std::shared_ptr<const WordPicture> load_word(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return nullptr;
    try {
        return read_word(file);
    } catch (const std::exception&) {  // the wall goes without it
        return nullptr;
    }
}

WordLoader::WordLoader(std::filesystem::path state, std::chrono::milliseconds rest)
    : state_(std::move(state)), rest_(rest), thread_([this] { run(); }) {}

WordLoader::~WordLoader() {
    {
        const std::lock_guard lock(mutex_);
        is_stopping_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void WordLoader::want(std::set<std::string> texts) {
    {
        const std::lock_guard lock(mutex_);
        if (texts == wanted_) return;
        wanted_ = std::move(texts);
        std::erase_if(known_, [&](const std::string& text) { return !wanted_.contains(text); });
        has_news_ = true;
    }
    wake_.notify_one();
}

std::vector<LoadedWord> WordLoader::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(loaded_, {});
}

void WordLoader::run() {
    std::unique_lock lock(mutex_);
    while (!is_stopping_) {
        has_news_ = false;
        std::vector<std::string> lacking;
        std::ranges::set_difference(wanted_, known_, std::back_inserter(lacking));
        if (!lacking.empty()) {
            lock.unlock();
            std::vector<LoadedWord> words = read(lacking);
            lock.lock();
            for (LoadedWord& word : words) {
                known_.insert(word.text);
                loaded_.push_back(std::move(word));
            }
        }
        const auto is_due = [this] { return is_stopping_ || has_news_; };
        if (std::ranges::includes(known_, wanted_))
            wake_.wait(lock, is_due);
        else
            wake_.wait_for(lock, rest_, is_due);
    }
}

std::vector<LoadedWord> WordLoader::read(const std::vector<std::string>& texts) const {
    std::vector<LoadedWord> words;
    for (const std::string& text : texts)
        if (auto picture = load_word(word_picture(state_, text))) words.push_back({text, std::move(picture)});
    return words;
}

}  // namespace vitrine::player
