#include "maps/image_head.h"

#include <cstring>
#include <fstream>

#include "core/file.h"

namespace sward {
namespace {

constexpr size_t kMostHeadBytes = size_t(1) << 16;  // an EXR's attributes up to the data window lie well within

Error damaged(const std::filesystem::path& file, const std::string& what) {
    return unsound(what, "export it again").at(file);
}

uint32_t bigEndian(const char* p) {
    const auto* b = reinterpret_cast<const unsigned char*>(p);
    return uint32_t(b[0]) << 24 | uint32_t(b[1]) << 16 | uint32_t(b[2]) << 8 | b[3];
}
int32_t littleEndian(const char* p) {
    const auto* b = reinterpret_cast<const unsigned char*>(p);
    return static_cast<int32_t>(uint32_t(b[3]) << 24 | uint32_t(b[2]) << 16 | uint32_t(b[1]) << 8 | b[0]);
}

// Chunks: length, type, data, checksum. The first is IHDR, the last IEND.
Status walkPng(const std::filesystem::path& file, std::istream& in, uint64_t size) {
    uint64_t at = 8;
    for (;;) {
        char head[8];
        in.seekg(static_cast<std::streamoff>(at));
        if (at + 12 > size || !in.read(head, 8)) return damaged(file, "is truncated");
        at += uint64_t(12) + bigEndian(head);
        if (at > size) return damaged(file, "is truncated");
        if (std::memcmp(head + 4, "IEND", 4) == 0) return {};
    }
}

Result<ImageHead> pngHead(const std::filesystem::path& file, std::istream& in, const std::string& head, uint64_t size) {
    if (head.size() < 33 || head.compare(12, 4, "IHDR") != 0) return damaged(file, "is truncated");
    if (Status s = walkPng(file, in, size); !s) return s.error();
    return ImageHead{"png", bigEndian(head.data() + 16), bigEndian(head.data() + 20), {}, {}};
}

// Attributes: name, zero, type, zero, length, value; an empty name ends them.
Result<ImageHead> exrHead(const std::filesystem::path& file, const std::string& head) {
    size_t at = 8;
    while (at < head.size() && head[at] != '\0') {
        const size_t nameEnd = head.find('\0', at);
        const size_t typeEnd = nameEnd == std::string::npos ? nameEnd : head.find('\0', nameEnd + 1);
        if (typeEnd == std::string::npos || typeEnd + 5 > head.size()) return damaged(file, "is truncated");
        const int32_t length = littleEndian(head.data() + typeEnd + 1);
        const size_t value = typeEnd + 5;
        if (length < 0 || size_t(length) > head.size() - value)
            return damaged(file, "is truncated or has a damaged header");
        if (head.compare(at, nameEnd - at, "dataWindow") == 0 && length == 16) {
            const auto edge = [&](size_t i) { return int64_t(littleEndian(head.data() + value + i * 4)); };
            return ImageHead{"exr", edge(2) - edge(0) + 1, edge(3) - edge(1) + 1, {}, {}};
        }
        at = value + size_t(length);
    }
    return damaged(file, "has no data window; it is truncated or damaged");
}

}  // namespace

Result<ImageHead> readImageHead(const std::filesystem::path& file, std::optional<uint64_t> directory) {
    if (Status s = checkRegular(file); !s) return s.error();
    std::error_code fault;
    std::ifstream in(file, std::ios::binary);
    std::string head(kMostHeadBytes, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<size_t>(in.gcount()));
    if (head.empty() && !in.eof()) return unsound("cannot be read", "check who may read it").at(file);
    in.clear();
    const uint64_t size = std::filesystem::file_size(file, fault);
    const std::string_view start(head);
    if (start.empty()) return damaged(file, "is empty");
    if (start.starts_with("\x89PNG\r\n\x1a\n")) return pngHead(file, in, head, size);
    if (start.starts_with("\x76\x2f\x31\x01")) return exrHead(file, head);
    if (start.starts_with(std::string_view("II*\0", 4)) || start.starts_with(std::string_view("MM\0*", 4)) ||
        start.starts_with(std::string_view("II+\0", 4)) || start.starts_with(std::string_view("MM\0+", 4)))
        return readTiffHead(file, in, size, directory);
    return unsound("is no PNG, EXR or TIFF image, or is damaged", "convert it to one of these").at(file);
}

}  // namespace sward
