#include "analyzer/tapestry/weave/frame_sheets.hpp"

#include "analyzer/explain/canvas.hpp"
#include "analyzer/tapestry/weave/picture_file.hpp"
#include "base/system/log.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string_view>
#include <system_error>

namespace vitrine::analyzer {

namespace {

// px of a frame; it is shown for the tenth of a second that a sharp one takes
constexpr int max_height = 100;
constexpr int sheet_side = 4;      // frames across and down: a sheet is read in 5 ms
constexpr int digit_height = 48;   // px
constexpr int digit_width = 30;    // px
constexpr double digit_size = 40;  // px of the font
constexpr std::string_view all_digits = "0123456789:";
constexpr Ink black = 0x000000;
constexpr Ink white = 0xffffff;

cv::Size frame_size(cv::Size brick) {
    const double scale = std::min(1.0, static_cast<double>(max_height) / brick.height);
    return {std::max(1, static_cast<int>(std::lround(brick.width * scale))),
            std::max(1, static_cast<int>(std::lround(brick.height * scale)))};
}

cv::Mat drawn_sheet(const KeptSheets& kept, const Candidates& candidates, int sheet) {
    cv::Mat picture = cv::Mat::zeros(kept.height * kept.rows, kept.width * kept.columns, CV_8UC3);
    const int all = static_cast<int>(kept.times.size());
    const int first = sheet * kept.columns * kept.rows;
    for (int frame = first; frame < std::min(all, first + kept.columns * kept.rows); ++frame) {
        const int cell = frame - first;
        cv::Mat into = picture({(cell % kept.columns) * kept.width, (cell / kept.columns) * kept.height,
                                kept.width, kept.height});
        cv::resize(candidates.picture(frame), into, into.size(), 0, 0, cv::INTER_AREA);
    }
    return picture;
}

}  // namespace

KeptSheets write_frame_sheets(const std::filesystem::path& directory, const Tapestry& tapestry,
                              const Candidates& candidates) {
    const cv::Size frame = frame_size(candidates.brick());
    KeptSheets kept{
        .width = frame.width, .height = frame.height, .columns = sheet_side, .rows = sheet_side, .times = {}};
    for (const FrameSignature& one : candidates.signatures())
        kept.times.push_back(one.time);
    std::filesystem::create_directories((directory / tapestry.sheet_name(0)).parent_path());
    for (int sheet = 0; sheet < kept.sheets(); ++sheet) {
        const std::filesystem::path file = directory / tapestry.sheet_name(sheet);
        std::error_code error;
        if (!std::filesystem::exists(file, error)) write_jpeg(file, drawn_sheet(kept, candidates, sheet));
    }
    return kept;
}

DigitCells write_digits(const std::filesystem::path& directory, const Tapestry& tapestry) {
    try {
        Canvas canvas(digit_width * static_cast<int>(all_digits.size()), digit_height, black);
        for (std::size_t i = 0; i < all_digits.size(); ++i) {
            const std::string_view digit = all_digits.substr(i, 1);
            const double left = (digit_width - canvas.text_width(digit, digit_size)) / 2.0;
            canvas.text(digit, {static_cast<double>(i) * digit_width + left, digit_height / 2.0},
                        {.size = digit_size, .colour = white});
        }
        if (cv::countNonZero(canvas.picture().reshape(1)) == 0) return {};
        write_png(directory / tapestry.digits_name(), canvas.picture());
        return {.width = digit_width, .height = digit_height};
    } catch (const std::runtime_error& error) {
        log::warning("a tapestry tells no times: {}", error.what());
        return {};
    }
}

}  // namespace vitrine::analyzer
