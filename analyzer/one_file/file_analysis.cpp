#include "analyzer/one_file/file_analysis.hpp"

#include "analyzer/film/reader_sandbox.hpp"
#include "analyzer/lettering/font_places.hpp"
#include "analyzer/one_file/analysed_file.hpp"
#include "analyzer/one_file/analyze.hpp"
#include "analyzer/one_file/explain_sheet.hpp"
#include "analyzer/one_file/inner_film.hpp"
#include "analyzer/origin/motion_photo.hpp"
#include "analyzer/status/thumbnail.hpp"
#include "analyzer/store/store_writer.hpp"
#include "analyzer/tapestry/tapestry_state.hpp"
#include "analyzer/tapestry/weave/kept_frames.hpp"
#include "base/media/file_bytes.hpp"
#include "base/media/media_type.hpp"
#include "base/media/stream_end.hpp"
#include "base/state/catalogue.hpp"
#include "base/state/media_error.hpp"
#include "base/state/record_json.hpp"
#include "base/system/error.hpp"
#include "base/system/log.hpp"
#include "base/system/unique_fd.hpp"

#include <fcntl.h>
#include <opencv2/core.hpp>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <new>
#include <optional>
#include <string_view>
#include <utility>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

/// Runs one task before each frame of a source and another with the frame.
class ObservedSource : public FrameSource {
  public:
    /// @param info  that of the source, with the origin
    ObservedSource(FrameSource& source, MediaInfo info, std::function<void()> before,
                   std::function<void(const FilmFrame&)> with)
        : source_(source), info_(std::move(info)), before_(std::move(before)), with_(std::move(with)) {}

    const MediaInfo& info() const override { return info_; }

    std::optional<FilmFrame> next() override {
        before_();
        std::optional<FilmFrame> frame = source_.next();
        if (frame) with_(*frame);
        return frame;
    }

  private:
    FrameSource& source_;  // outlives this
    MediaInfo info_;
    std::function<void()> before_;
    std::function<void(const FilmFrame&)> with_;
};

/// The record of a film that broke off; the last shot ends where the damage begins, or earlier.
MediaRecord shortened_record(MediaRecord known, const MediaError& error) {
    using std::chrono::seconds;
    const auto end = std::chrono::floor<seconds>(known.shots.back().end).count();
    known.reason =
        fmt::format("shown up to {}:{:02}:{:02}: {}", end / 3600, end / 60 % 60, end % 60, error.what());
    known.is_complete = true;
    known.duration = known.shots.back().end;
    return known;
}

MediaRecord record_without_shots(const MediaError& error) {
    MediaRecord record;
    record.state = error.state();
    record.reason = error.what();
    record.fault.owner = error.owner();
    return record;
}

AnalysisSettings settings_for(const AnalysedFile& file, const AnalysisOutputs& outputs) {
    AnalysisSettings settings = analysis_settings(file.settings().analyzer);
    settings.looks_at_photos = outputs.network;
    return settings;
}

bool lacks_tapestry(const AnalysedFile& file) {
    const MediaFile& media = file.media();
    return tapestry_state(file.tapestry(), media.bytes(), media.mtime_ns()) == TapestryState::lacking;
}

/// The analysis of one file with its by-products.
class FileAnalysis {
  public:
    FileAnalysis(const AnalysedFile& file, const AnalysisOutputs& outputs, const AnalysisEvents& events)
        : file_(file), outputs_(outputs), events_(events) {
        if (outputs.thumbnail) thumbnail_.emplace(file.thumbnail());
    }

    /// Every file has a record, with the reason where it has no shots.
    MediaRecord record() {
        try {
            return analyse();
        } catch (const MediaError& error) {
            return record_after(error);
        } catch (const cv::Exception& error) {  // its words mean nothing to an operator
            log::debug("not analysed: {}", error.what());
            return record_without_shots(
                {MediaState::failed, "pictures of this size or shape cannot be analysed"});
        } catch (const std::bad_alloc&) {
            return record_without_shots({MediaState::failed, fmt::format("it needs more memory than {} MiB",
                                                                         file_.settings().analyzer.memory)});
        }
    }

  private:
    /// A film that is damaged at some place is shown up to there. A library may take a share that fails for
    /// damage, so the file is read once by plain calls first.
    MediaRecord record_after(const MediaError& error) {
        if (error.state() != MediaState::failed) return record_without_shots(error);
        try {
            require_readable(file_.media().name());
        } catch (const MediaError& fault) {
            return record_without_shots(fault);
        }
        if (known_.shots.empty()) return record_without_shots(error);
        known_ = shortened_record(std::move(known_), error);
        finish_outputs(known_);
        return known_;
    }

    MediaRecord analyse() {
        if (!outputs_.accepts_cut)
            require_whole_packets(file_.media().name(), media_format(file_.media().name()));
        const std::unique_ptr<FrameSource> source = file_.open();
        begin_outputs(source->info());
        MediaInfo info = source->info();
        info.origin = file_.origin();
        ObservedSource observed(
            *source, std::move(info), [this] { report_places(); },
            [this](const FilmFrame& frame) {
                if (events_.progressed) events_.progressed();
                if (thumbnail_) thumbnail_->add_frame(frame);
                if (frames_) frames_->saw(frame);
            });
        MediaRecord record = analyze(observed, settings_for(file_, outputs_), {},
                                     [this](const MediaRecord& part) { grow(part); });
        if (thumbnail_) thumbnail_->write(record);
        finish_outputs(record);
        return record;
    }

    void begin_outputs(const MediaInfo& media) {
        if (outputs_.stored) {
            StorePlace place = file_.store_place();
            place.wants_sound = outputs_.sound;
            store_ = std::make_unique<StoreWriter>(file_.media().name(), media, std::move(place));
        }
        if (!outputs_.frames || media.kind != MediaKind::film) return;
        if (!lacks_tapestry(file_)) return;
        const auto max_bytes = static_cast<std::uint64_t>(file_.settings().tapestry.max_bytes);
        frames_.emplace(file_.tapestry(), tapestry_share(max_bytes));
    }

    /// Enters the places in the store.
    void finish_outputs(MediaRecord& record) {
        const MediaFile& file = file_.media();
        if (frames_) frames_->finish(record, {.bytes = file.bytes(), .mtime_ns = file.mtime_ns()});
        if (!store_) return;
        store_->finish(record);
        if (record.kind == MediaKind::photo && media_format(file.name()) == MediaFormat::jpeg)
            add_inner_film(record, file.name(), file_.store_place(), settings_for(file_, outputs_));
    }

    void grow(const MediaRecord& part) {
        std::vector<Shot> shots = std::move(known_.shots);
        shots.insert(shots.end(), part.shots.begin(), part.shots.end());
        known_ = part;
        known_.shots = std::move(shots);
        if (thumbnail_) thumbnail_->write(part);
        if (events_.grown) events_.grown(file_.stamped(part));
        for (const Shot& shot : part.shots)
            if (store_) store_->add_shot(shot);
    }

    /// Reports shots again whose place in the store became known since the last frame.
    void report_places() {
        if (!store_) return;
        for (const Shot& shot : store_->take_placed_shots()) {
            MediaRecord part = known_;
            part.shots = {shot};
            if (events_.grown) events_.grown(file_.stamped(part));
        }
    }

    const AnalysedFile& file_;  // outlives this
    AnalysisOutputs outputs_;
    const AnalysisEvents& events_;  // outlives this
    MediaRecord known_;             // a film with the shots so far
    std::unique_ptr<StoreWriter> store_;
    std::optional<Thumbnail> thumbnail_;
    std::optional<KeptFrames> frames_;
};

void write_line(const UniqueFd& output, const std::string& words) {
    const std::string line = words + "\n";
    for (std::string_view text = line; !text.empty();) {
        const ssize_t n = ::write(output.get(), text.data(), text.size());
        if (n < 0) throw_errno("write the record");
        text.remove_prefix(static_cast<std::size_t>(n));
    }
}

/// Tells the daemon by an empty line that the analysis gets on, at most once a second.
class ProgressLine {
  public:
    explicit ProgressLine(const UniqueFd& output) : output_(output) {}

    void write() {
        const auto now = std::chrono::steady_clock::now();
        if (now - written_ < std::chrono::seconds(1)) return;
        written_ = now;
        write_line(output_, "");
    }

  private:
    const UniqueFd& output_;  // outlives this
    std::chrono::steady_clock::time_point written_;
};

MediaRecord analysed_record(const AnalysedFile& file, const AnalysisOutputs& outputs,
                            const AnalysisEvents& events) {
    return file.stamped(FileAnalysis(file, outputs, events).record());
}

/// True: it may be a motion photo, whose film is to be stored. A file that cannot be read has none.
bool may_store_film(const AnalysedFile& file, const AnalysisOutputs& outputs) {
    const std::string name = file.media().name();
    try {
        return outputs.stored && file.media().is_plain() && media_format(name) == MediaFormat::jpeg &&
               may_hold_film(name);
    } catch (const MediaError&) {
        return false;
    }
}

/// The folder in the store comes first, and also where nothing is stored: libraries use it.
ReaderNeeds needs_of(const AnalysedFile& file, const AnalysisOutputs& outputs) {
    const StorePlace place = file.store_place();
    const AnalysisSettings settings = settings_for(file, outputs);
    ReaderNeeds needs{.models = {settings.face_model, settings.face_cascade, settings.saliency_model,
                                 settings.spare_model, settings.text_model}};
    if (outputs.stored || outputs.growth) needs.folders.push_back(place.store / place.id);
    if (outputs.thumbnail) needs.folders.push_back(file.thumbnail().parent_path());
    needs.holds_film = may_store_film(file, outputs);
    if (outputs.frames && lacks_tapestry(file)) needs.film_folder = file.tapestry();
    return needs;
}

}  // namespace

MediaRecord analyse_file(const fs::path& file, const Settings& settings, const AnalysisOutputs& outputs,
                         const AnalysisEvents& events) {
    return analysed_record(AnalysedFile(file, settings), outputs, events);
}

void print_analysis(const fs::path& file, const Settings& settings, const AnalysisOutputs& outputs) {
    const UniqueFd output(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3));
    if (!output.is_open() || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        throw_errno("redirect the standard output");
    AnalysisEvents events;
    ProgressLine progress(output);
    if (outputs.growth)
        events = {.grown = [&](const MediaRecord& part) { write_line(output, to_json(part)); },
                  .progressed = [&] { progress.write(); }};
    const AnalysedFile analysed(file, settings);
    enter_reader_sandbox(analysed.media(), needs_of(analysed, outputs));
    write_line(output, to_json(analysed_record(analysed, outputs, events)));
}

bool write_thumbnail(const fs::path& file, const Settings& settings) {
    const Catalogue catalogue(fs::path(settings.state.directory) / "catalogue");
    const auto record = catalogue.find(record_path(file, settings.media.root));
    if (!record || record->shots.empty()) return false;
    const AnalysedFile analysed(file, settings);
    enter_reader_sandbox(analysed.media(), {.folders = {analysed.thumbnail().parent_path()}});
    Thumbnail thumbnail(analysed.thumbnail());
    const std::unique_ptr<FrameSource> source = analysed.open();
    while (const std::optional<FilmFrame> frame = source->next()) {
        if (frame->time < record->shots.front().begin) continue;
        thumbnail.add_frame(*frame);
        break;
    }
    thumbnail.write(*record);
    return fs::exists(analysed.thumbnail());
}

MediaRecord explain_file(const fs::path& file, const std::string& sheet, const Settings& settings) {
    const AnalysedFile analysed(file, settings);
    const SheetTitle title{.name = file.filename().string(), .bytes = analysed.media().bytes()};
    const UniqueFd output(::open(sheet.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
    if (!output.is_open()) throw_errno("write '{}'", sheet);
    ReaderNeeds needs = needs_of(analysed, {.network = true});
    needs.libraries = font_places();
    enter_reader_sandbox(analysed.media(), needs);
    Explanation explanation =
        explain([&] { return analysed.open(); }, title, analysis_settings(settings.analyzer));
    if (::ftruncate(output.get(), 0) != 0) throw_errno("write '{}'", sheet);
    explanation.sheet.write_png(output.get());
    return std::move(explanation.record);
}

}  // namespace vitrine::analyzer
