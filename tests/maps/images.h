// Small maps and their files, for the tests of what reads them.
#pragma once
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "maps/map.h"

namespace sward::test {

// A texel's value that differs from its neighbours', in [0,1].
inline float pattern(int x, int y, int c) {
    const uint32_t h = (uint32_t(x) * 2654435761u) ^ (uint32_t(y) * 2246822519u) ^ (uint32_t(c) * 3266489917u);
    return float((h ^ h >> 15) & 0xffff) / 65535.0f;
}
inline Map patternMap(const MapInfo& info) {
    Map map(info);
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x)
            for (int c = 0; c < info.channels; ++c) map.set(x, y, c, pattern(x, y, c));
    return map;
}

// A map of 17 million texels of 8 bits, which is kept in tiles: zero but for its first and last rows of tiles.
inline Map largeMap() {
    Map map({4224, 4096, 1, PixelType::U8});
    std::vector<uint8_t> row(4224);
    for (int y = 0; y < 4096; y = y == 127 ? 4096 - 128 : y + 1) {
        for (size_t x = 0; x < row.size(); ++x) row[x] = static_cast<uint8_t>((x * 7 + size_t(y) * 13) % 251 + 1);
        map.writeRows(y, 1, row.data());
    }
    return map;
}
// The same size, and no two tiles alike.
inline Map fullMap() {
    Map map({4224, 4096, 1, PixelType::U8});
    std::vector<uint8_t> row(4224);
    for (int y = 0; y < 4096; ++y) {
        for (size_t x = 0; x < row.size(); ++x) row[x] = static_cast<uint8_t>((x * 7 + size_t(y) * 13) % 251 + 1);
        map.writeRows(y, 1, row.data());
    }
    return map;
}

// Bytes of numbers, for headers made by hand.
inline std::string bigEndian32(uint32_t v) { return {char(v >> 24), char(v >> 16), char(v >> 8), char(v)}; }
inline std::string littleEndian32(uint32_t v) { return {char(v), char(v >> 8), char(v >> 16), char(v >> 24)}; }

// A PNG that declares a size and holds no more than an empty image chunk.
inline std::string pngBomb(uint32_t width, uint32_t height) {
    const auto chunk = [](const std::string& type, const std::string& data) {
        uint32_t crc = 0xffffffffu;
        for (const char ch : type + data) {
            crc ^= static_cast<unsigned char>(ch);
            for (int k = 0; k < 8; ++k) crc = crc & 1 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
        }
        return bigEndian32(uint32_t(data.size())) + type + data + bigEndian32(~crc);
    };
    const std::string size = bigEndian32(width) + bigEndian32(height);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", size + std::string("\x08\x00\x00\x00\x00", 5)) + chunk("IDAT", "") +
           chunk("IEND", "");
}

// The header of an EXR whose data window has this size; one half channel, then nothing.
inline std::string exrBomb(int32_t width, int32_t height) {
    const auto attribute = [](const std::string& name, const std::string& type, const std::string& value) {
        return name + '\0' + type + '\0' + littleEndian32(uint32_t(value.size())) + value;
    };
    const std::string window = littleEndian32(0) + littleEndian32(0) + littleEndian32(uint32_t(width - 1)) +
                               littleEndian32(uint32_t(height - 1));
    const std::string channel =
        std::string("Y\0", 2) + littleEndian32(1) + littleEndian32(0) + littleEndian32(1) + littleEndian32(1) + '\0';
    return std::string("\x76\x2f\x31\x01\x02\x00\x00\x00", 8) + attribute("channels", "chlist", channel) +
           attribute("compression", "compression", std::string(1, '\0')) + attribute("dataWindow", "box2i", window) +
           attribute("displayWindow", "box2i", window) + attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
           attribute("pixelAspectRatio", "float", littleEndian32(0x3f800000)) +
           attribute("screenWindowCenter", "v2f", littleEndian32(0) + littleEndian32(0)) +
           attribute("screenWindowWidth", "float", littleEndian32(0x3f800000)) + '\0';
}

// A little-endian TIFF of one grey strip that declares a size.
inline std::string tiffBomb(uint32_t width, uint32_t height) {
    const auto entry = [](uint16_t tag, uint16_t type, uint32_t value) {
        return std::string{char(tag), char(tag >> 8), char(type), char(type >> 8)} + littleEndian32(1) +
               littleEndian32(value);
    };
    return std::string("II*\0", 4) + littleEndian32(8) + std::string{9, 0} + entry(256, 4, width) +
           entry(257, 4, height) + entry(258, 3, 8) + entry(259, 3, 1) + entry(262, 3, 1) + entry(273, 4, 8) +
           entry(277, 3, 1) + entry(278, 4, height) + entry(279, 4, 100) + littleEndian32(0);
}

// A little-endian TIFF of one channel, uncompressed: `bytes` are its texels of `bits` bits; format: 1 unsigned, 2
// signed, 3 floats. noData: what GDAL writes into its tag; empty: none.
inline std::string tiffOf(uint32_t width, uint32_t height, uint32_t bits, uint32_t format, const std::string& bytes,
                          const std::string& noData = "") {
    const auto entry = [](uint16_t tag, uint16_t type, uint32_t count, uint32_t value) {
        return std::string{char(tag & 255), char(tag >> 8), char(type), 0} + littleEndian32(count) +
               littleEndian32(value);
    };
    const uint32_t entries = noData.empty() ? 10 : 11, data = 8 + 2 + 12 * entries + 4,
                   text = data + uint32_t(bytes.size());
    std::string out = std::string("II*\0", 4) + littleEndian32(8) + std::string{char(entries), 0} +
                      entry(256, 4, 1, width) + entry(257, 4, 1, height) + entry(258, 3, 1, bits) +
                      entry(259, 3, 1, 1) + entry(262, 3, 1, 1) + entry(273, 4, 1, data) + entry(277, 3, 1, 1) +
                      entry(278, 4, 1, height) + entry(279, 4, 1, uint32_t(bytes.size())) + entry(339, 3, 1, format);
    if (!noData.empty()) out += entry(42113, 2, uint32_t(noData.size()) + 1, text);
    return out + littleEndian32(0) + bytes + noData + '\0';
}
template <class T>
std::string bytesOf(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace sward::test
