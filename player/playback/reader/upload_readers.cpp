#include "player/playback/reader/upload_readers.hpp"

#include "player/playback/reader/reading.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

/// Pictures of a film that are neither waiting in the queue nor free: drawn, about to be drawn, and written.
constexpr std::size_t further_slots = 4;

/// The path below the media folder of a file in it.
std::string path_below(const std::string& root, const std::string& file) {
    return file.substr(std::min(file.size(), root.size() + 1));
}

class RemoteFilm final : public FilmFeed {
  public:
    RemoteFilm(ReaderHost& host, ReaderOrder order, SampleQueue& queue)
        : queue_(queue), reading_(host, std::move(order), queue.capacity() + further_slots, queue) {}

    void resize(int width, int height) override {
        if (reading_.link() != nullptr) reading_.link()->resize(width, height);
    }

    void play_from(Detail detail, std::chrono::nanoseconds at) override {
        if (reading_.link() != nullptr) reading_.link()->play_from(detail, at);
    }

    std::chrono::nanoseconds spent() const override { return reading_.spent(); }

    void stop() override {
        queue_.close();
        reading_.stop();
    }

    bool has_ended() const override { return reading_.has_ended(); }

    std::optional<std::string> failure() const override { return reading_.failure(); }

    bool has_crashed() const override { return reading_.has_crashed(); }

  private:
    SampleQueue& queue_;  // outlives this
    Reading reading_;
};

class RemotePhoto final : public PhotoFeed {
  public:
    RemotePhoto(ReaderHost& host, ReaderOrder order, SampleQueue& queue)
        : reading_(host, std::move(order), 1, queue) {}

    void stop() override { reading_.stop(); }

    bool has_ended() const override { return reading_.has_ended(); }

    std::optional<std::string> failure() const override { return reading_.failure(); }

    bool has_crashed() const override { return reading_.has_crashed(); }

  private:
    Reading reading_;
};

}  // namespace

std::unique_ptr<FilmFeed> make_remote_film(ReaderHost& host, const std::string& root, const FilmPart& part,
                                           SampleQueue& queue, const FilmOptions& options) {
    ReaderOrder order{.kind = MediaKind::film,
                      .root = root,
                      .path = path_below(root, part.file),
                      .width = part.width,
                      .height = part.height,
                      .form = options.form,
                      .begin = part.begin,
                      .end = part.end,
                      .at = part.at};
    return std::make_unique<RemoteFilm>(host, std::move(order), queue);
}

std::unique_ptr<PhotoFeed> make_remote_photo(ReaderHost& host, const std::string& root, const PhotoWish& wish,
                                             SampleQueue& queue) {
    ReaderOrder order{.kind = MediaKind::photo,
                      .root = root,
                      .path = path_below(root, wish.file),
                      .width = wish.width,
                      .height = wish.height,
                      .background = wish.background,
                      .form = PictureForm::bgra};
    return std::make_unique<RemotePhoto>(host, std::move(order), queue);
}

UploadFactories upload_readers(const std::shared_ptr<ReaderHost>& host, const std::string& root) {
    return {.make_film =
                [host, root](const FilmPart& part, SampleQueue& queue, const FilmOptions& options) {
                    return make_remote_film(*host, root, part, queue, options);
                },
            .make_photo = [host,
                           root](const PhotoWish& wish,
                                 SampleQueue& queue) { return make_remote_photo(*host, root, wish, queue); }};
}

}  // namespace vitrine::player
