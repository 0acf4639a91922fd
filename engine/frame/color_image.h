// Small colour textures: soil and blades made by the program, or PNG files; with mips that keep colour and coverage.
// Does not: hold maps that are painted (map_textures.h).
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "gpu/resources.h"

namespace sward {

// sRGB colour and alpha, rows first.
struct Rgba8 {
    int width = 0, height = 0;
    std::vector<uint8_t> pixels;
};
// A seamless square of soil whose mean linear reflectance is 1 before the shader multiplies by groundColor.
Rgba8 makeSoil(int side);
// A blade from root (row 0) to tip: midrib, veins, ragged edges, alpha. Its mean colour is white: species colours tint
// it.
Rgba8 makeBladeImage(int width, int height);
// Empty (and a warning logged) if the file cannot be read: callers fall back to the made one.
Rgba8 loadColorImage(const std::filesystem::path& file);
// Gives transparent texels the colour of their nearest opaque ones, so that filtering draws no halo.
void dilateColor(Rgba8& image);
Texture makeColorTexture(Gpu& gpu, const std::string& owner, const Rgba8& image, bool repeat = true);
// The image stretched to at least so many rows, each mixed from the two that lie around it.
Rgba8 withRows(const Rgba8& image, int rows);
inline constexpr int kBladeRows = 16;
// Texture of a blade (makeBladeImage): its mips end where it is one texel wide, and are still kBladeRows high there, so
// that a blade thinner than a pixel keeps its taper from root to tip. owner: whose memory it is.
Texture makeBladeTexture(Gpu& gpu, const std::string& owner, const Rgba8& image);

}  // namespace sward
