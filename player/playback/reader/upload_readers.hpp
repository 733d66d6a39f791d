#pragma once

#include "player/playback/film_feed.hpp"
#include "player/playback/photo_load.hpp"
#include "player/playback/reader/reader_host.hpp"
#include "player/playback/shot_source.hpp"

#include <memory>
#include <string>

namespace vitrine::player {

/// Plays a part of a film of the media folder by a reader.
/// @param host  outlives the film
/// @param root  the media folder; the part's file is below it
std::unique_ptr<FilmFeed> make_remote_film(ReaderHost& host, const std::string& root, const FilmPart& part,
                                           SampleQueue& queue, const FilmOptions& options);

/// Reads a photo of the media folder by a reader.
/// @param host  outlives the photo
/// @param root  the media folder; the wish's file is below it
std::unique_ptr<PhotoFeed> make_remote_photo(ReaderHost& host, const std::string& root, const PhotoWish& wish,
                                             SampleQueue& queue);

/// The factories for all files of the media folder, so that none of them is decoded in this process.
/// @param host  shared with the factories
UploadFactories upload_readers(const std::shared_ptr<ReaderHost>& host, const std::string& root);

}  // namespace vitrine::player
