// Painted maps as textures: one a map, uploaded by tile, only where a tile's pointer differs from the last upload.
// A map that no pass asked for in a frame loses its texture after it.
// Mip levels 1 to 7 of a tile are filtered from that tile alone (tiles are aligned to 128), coarser ones from level 7.
// The GPU's levels have whole numbers of texels: where a map's half has none, its texels are means over parts of
// halves, so that no level is shifted against the others. Colours count by their opacity.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "gpu/resources.h"
#include "maps/map.h"

namespace sward {

class MapTextures {
  public:
    explicit MapTextures(Gpu& gpu) : gpu_(gpu) {}
    // owner: who is charged ("terrain/ground"); key: the map's identity, its PATH. srgb: four channels are a colour,
    // read as linear light; the GPU decodes 8 bits. Formats: U8 R8/RG8/RGBA8, U16 R16/RG16/RGBA16, F32
    // R32F/RG32F/RGBA32F.
    GLuint get(const std::string& owner, const std::string& key, const Map& map, bool srgb = false,
               bool repeat = false);
    // The texture of a map that something asked for in this frame, by its PATH; 0 if nothing did.
    GLuint shared(const std::string& path) const;
    void beginFrame();
    void endFrame();                                      // frees what was not asked for since beginFrame
    uint64_t uploadedBytes() const { return uploaded_; }  // since beginFrame

  private:
    struct Entry {
        Texture texture;
        Map last;                                    // as uploaded: tiles are compared by pointer
        std::vector<std::vector<std::byte>> halves;  // by level: of those that the GPU's are not, and of level 7
        bool used = false, repeat = false;
    };
    void uploadTiles(Entry& e, bool srgb, const Map& map, const std::vector<int>& columns, int ty);
    struct Changed {
        int x0, y0, x1, y1;  // tiles, the last ones included
    };
    void uploadRest(Entry& e, bool srgb, const Map& map, const Changed& changed);
    Gpu& gpu_;
    std::map<std::string, Entry> entries_;
    uint64_t uploaded_ = 0;
};

}  // namespace sward
