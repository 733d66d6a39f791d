#include "player/playback/reader/picture_intake.hpp"

#include "base/state/media_error.hpp"

#include <utility>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr nanoseconds max_time = std::chrono::hours(24 * 365);      // of a film, and of one picture of it
constexpr nanoseconds max_played = std::chrono::hours(24 * 36500);  // over all loops

[[noreturn]] void refuse() {
    throw MediaError(MediaState::failed, "its reader gave a picture that cannot be");
}

std::optional<PixelLayout> layout_of(std::uint32_t number) {
    for (const PixelLayout layout :
         {PixelLayout::rgba, PixelLayout::bgra, PixelLayout::i420, PixelLayout::nv12})
        if (number == static_cast<std::uint32_t>(layout)) return layout;
    return std::nullopt;
}

std::optional<ColourCode> colours_of(const PictureNote& note) {
    using Matrix = ColourCode::Matrix;
    for (const Matrix matrix : {Matrix::bt601, Matrix::bt709, Matrix::bt2020})
        if (note.matrix == static_cast<std::uint32_t>(matrix))
            return ColourCode{.matrix = matrix, .is_full_range = note.is_full_range != 0};
    return std::nullopt;
}

}  // namespace

/// Holds a slot for a sample.
struct PictureIntake::Loan {
    Loan(std::shared_ptr<Memory> lent, const SlotNote& name, std::shared_ptr<const GiveBack> give_back)
        : memory(std::move(lent)), slot(name), call(std::move(give_back)) {}

    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    Loan(Loan&&) = delete;
    Loan& operator=(Loan&&) = delete;

    ~Loan() {
        memory->held[slot.slot] = false;
        (*call)(slot);
    }

    std::shared_ptr<Memory> memory;
    SlotNote slot;
    std::shared_ptr<const GiveBack> call;
};

PictureIntake::PictureIntake(nanoseconds duration, GiveBack give_back)
    : duration_(duration), give_back_(std::make_shared<const GiveBack>(std::move(give_back))) {}

void PictureIntake::add_memory(std::shared_ptr<const PictureSlots> slots) {
    if (now_) ++number_;
    before_ = std::exchange(now_, std::make_shared<Memory>(std::move(slots)));
}

std::optional<LoopedSample> PictureIntake::take(const PictureNote& note) {
    const std::shared_ptr<Memory> memory = memory_of(note);
    if (!memory) return std::nullopt;
    if (note.slot >= memory->slots->shape().count) refuse();
    require_possible_times(note);
    LoopedSample taken = sample_of(note, *memory);
    if (memory->held[note.slot].exchange(true)) refuse();
    taken.sample.owner =
        std::make_shared<Loan>(memory, SlotNote{.memory = note.memory, .slot = note.slot}, give_back_);
    return taken;
}

/// None: the memory before the one before, which the player does not have any more.
std::shared_ptr<PictureIntake::Memory> PictureIntake::memory_of(const PictureNote& note) const {
    if (!now_ || note.memory > number_) refuse();
    if (note.memory == number_) return now_;
    return note.memory + 1 == number_ ? before_ : nullptr;
}

LoopedSample PictureIntake::sample_of(const PictureNote& note, const Memory& memory) const {
    const std::optional<PixelLayout> layout = layout_of(note.layout);
    const std::optional<ColourCode> colours = colours_of(note);
    if (!layout || !colours) refuse();
    std::optional<Sample> sample = sample_in(memory.slots->slot(note.slot), note.width, note.height, *layout);
    if (!sample) refuse();
    sample->colours = *colours;
    sample->stream_time = nanoseconds(note.stream_time);
    return {.sample = *std::move(sample), .loop = note.loop, .duration = nanoseconds(note.duration)};
}

/// Times are added and multiplied later on: they must stay far from the largest number.
void PictureIntake::require_possible_times(const PictureNote& note) const {
    const nanoseconds::rep max_loops = duration_.count() > 0 ? max_played.count() / duration_.count() : 0;
    if (note.stream_time < -max_time.count() || note.stream_time > max_time.count() ||
        note.loop > static_cast<std::uint64_t>(max_loops) || note.duration < 0 ||
        note.duration > max_time.count() || note.spent < 0 || note.spent > max_played.count())
        refuse();
}

}  // namespace vitrine::player
