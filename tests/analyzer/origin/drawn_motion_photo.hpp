#pragma once

#include <cstddef>
#include <string>

namespace vitrine::analyzer {

/// The namespaces that phones use in the XMP of motion photos.
inline std::string xmp_packet(const std::string& attributes, const std::string& content = "") {
    return R"(<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF )"
           R"(xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"><rdf:Description rdf:about="" )"
           R"(xmlns:GCamera="http://ns.google.com/photos/1.0/camera/" )"
           R"(xmlns:Container="http://ns.google.com/photos/1.0/container/" )"
           R"(xmlns:Item="http://ns.google.com/photos/1.0/container/item/" )" +
           attributes + ">" + content + "</rdf:Description></rdf:RDF></x:xmpmeta>";
}

/// XMP of Google's first kind. @param distance  bytes from the film's begin to the file's end
inline std::string micro_video_xmp(std::size_t distance) {
    return xmp_packet(R"(GCamera:MicroVideo="1" GCamera:MicroVideoVersion="1" GCamera:MicroVideoOffset=")" +
                      std::to_string(distance) + "\"");
}

/// XMP of Google's second kind, which lists what the file holds. @param bytes  of the film
inline std::string motion_photo_xmp(std::size_t bytes, std::size_t padding = 0) {
    return xmp_packet(R"(GCamera:MotionPhoto="1" GCamera:MotionPhotoVersion="1")",
                      R"(<Container:Directory><rdf:Seq><rdf:li rdf:parseType="Resource"><Container:Item )"
                      R"(Item:Mime="image/jpeg" Item:Semantic="Primary" Item:Length="0" Item:Padding=")" +
                          std::to_string(padding) +
                          R"("/></rdf:li><rdf:li rdf:parseType="Resource"><Container:Item )"
                          R"(Item:Mime="video/mp4" Item:Semantic="MotionPhoto" Item:Length=")" +
                          std::to_string(bytes) + R"("/></rdf:li></rdf:Seq></Container:Directory>)");
}

/// The same JPEG with XMP. @param jpeg  begins with its mark
inline std::string with_xmp(const std::string& jpeg, const std::string& xmp) {
    const std::string content = std::string("http://ns.adobe.com/xap/1.0/\0", 29) + xmp;
    const std::size_t length = content.size() + 2;
    return jpeg.substr(0, 2) + "\xff\xe1" + static_cast<char>(length >> 8U) + static_cast<char>(length) +
           content + jpeg.substr(2);
}

inline std::string little_bytes(std::size_t value, int count) {
    std::string bytes;
    for (int i = 0; i < count; ++i)
        bytes += static_cast<char>(value >> (8 * i));
    return bytes;
}

/// The end of a Samsung's file: the film, and the list that names it.
inline std::string samsung_end(const std::string& film) {
    const std::string name = "MotionPhoto_Data";
    const std::string part = std::string("\0\0\x30\x0a", 4) + little_bytes(name.size(), 4) + name + film;
    const std::string list = "SEFH" + little_bytes(106, 4) + little_bytes(1, 4) +
                             std::string("\0\0\x30\x0a", 4) + little_bytes(part.size(), 4) +
                             little_bytes(part.size(), 4);
    return part + list + little_bytes(list.size(), 4) + "SEFT";
}

}  // namespace vitrine::analyzer
