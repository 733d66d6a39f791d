// Reads the QR codes of a picture: read_codes WIDTH HEIGHT < RGB24. Prints the text of each code.
#include <zbar.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>

int main(int argc, char** argv) {
    if (argc != 3) return EXIT_FAILURE;
    const auto width = static_cast<unsigned>(std::atoi(argv[1]));
    const auto height = static_cast<unsigned>(std::atoi(argv[2]));
    const std::string rgb(std::istreambuf_iterator<char>(std::cin), {});
    if (rgb.size() != 3UL * width * height) return EXIT_FAILURE;
    std::string grey;
    for (std::size_t at = 1; at < rgb.size(); at += 3)
        grey.push_back(rgb[at]);
    zbar::Image image(width, height, "Y800", grey.data(), grey.size());
    zbar::ImageScanner scanner;
    scanner.set_config(zbar::ZBAR_NONE, zbar::ZBAR_CFG_ENABLE, 0);
    scanner.set_config(zbar::ZBAR_QRCODE, zbar::ZBAR_CFG_ENABLE, 1);
    scanner.scan(image);
    for (auto code = image.symbol_begin(); code != image.symbol_end(); ++code)
        std::cout << code->get_data() << '\n';
    return EXIT_SUCCESS;
}
