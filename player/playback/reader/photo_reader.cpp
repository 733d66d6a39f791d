#include "player/playback/reader/photo_reader.hpp"

#include "base/state/media_error.hpp"
#include "player/playback/photo_load.hpp"
#include "player/playback/reader/picture_slots.hpp"

namespace vitrine::player {

void read_photo(const ReaderOrder& order, const std::string& file, const MessageSocket& player,
                const UniqueFd& memory) {
    const PictureSlots slots(memory, order.slots, PictureSlots::Use::writing);
    const Sample picture = load_photo(
        {.file = file, .width = order.width, .height = order.height, .background = order.background});
    if (!copy_picture(picture, slots.writable_slot(0)))
        throw MediaError(FaultOwner::program, "the picture is larger than its place");
    player.send(to_message(PictureNote{.width = picture.width,
                                       .height = picture.height,
                                       .layout = static_cast<std::uint32_t>(picture.layout)}));
}

}  // namespace vitrine::player
