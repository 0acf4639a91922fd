#include "grass/slice_textures.h"

#include <algorithm>

namespace sward {
namespace {

using Channel = std::vector<uint8_t> SliceLevel::*;

// `layers` images of each level into the texture, from layer `first` on.
void fill(const Texture& t, const std::vector<SliceLevel>& levels, Channel channel, int first, int layers) {
    for (int l = 0; l < t.levels; ++l) {
        const SliceLevel& level = levels[static_cast<size_t>(l)];
        glTextureSubImage3D(t.id(), l, 0, 0, first, level.width, level.height, layers, GL_RGBA, GL_UNSIGNED_BYTE,
                            (level.*channel).data());
    }
}

constexpr size_t kSliceImages = 10;  // 2 views of 5 lights

struct Set {
    Texture reflectance, threshold, light;
};

// The paper's images: colour under each of the five lights for each view, opacity with each.
void fillFull(const Texture& t, const std::vector<SliceLevel>& levels, int layers) {
    std::vector<uint8_t> out;
    for (int l = 0; l < t.levels; ++l) {
        const SliceLevel& level = levels[static_cast<size_t>(l)];
        const size_t n = static_cast<size_t>(level.width) * level.height * layers;
        out.resize(4 * n);
        for (size_t image = 0; image < kSliceImages; ++image) {
            const size_t view = image / 5, light = image % 5;
            for (size_t i = 0; i < n; ++i) {
                const uint8_t k =
                    light == 4 ? level.threshold[4 * i + 2 + view] : (view ? level.back : level.front)[4 * i + light];
                for (size_t c = 0; c < 3; ++c)
                    out[4 * i + c] = static_cast<uint8_t>((level.reflectance[4 * i + c] * k + 127) / 255);
                out[4 * i + 3] = level.threshold[4 * i + 1];
            }
            glTextureSubImage3D(t.id(), l, 0, 0, static_cast<GLint>(image) * layers, level.width, level.height, layers,
                                GL_RGBA, GL_UNSIGNED_BYTE, out.data());
        }
    }
}

// wrapUp: beyond the upper and lower edge. To the sides the images go on with their other edge, as the patch does.
Set uploadSet(Gpu& gpu, const std::string& owner, const std::vector<SliceLevel>& levels, int layers, Storage storage,
              GLint wrapUp) {
    Set s;
    const int w = levels[0].width, h = levels[0].height;
    const GLenum colors = storage == Storage::Compressed ? GL_COMPRESSED_RGBA_BPTC_UNORM : GL_RGBA8;
    s.reflectance = makeTextureArray(gpu, owner, colors, w, h, layers);
    fill(s.reflectance, levels, &SliceLevel::reflectance, 0, layers);
    s.threshold = makeTextureArray(gpu, owner, GL_RGBA8, w, h, layers);  // never compressed: thresholds are compared
    fill(s.threshold, levels, &SliceLevel::threshold, 0, layers);
    s.light = makeTextureArray(gpu, owner, colors, w, h,
                               static_cast<int>(storage == Storage::Full ? kSliceImages : 2) * layers);
    if (storage == Storage::Full) {
        fillFull(s.light, levels, layers);
    } else {
        fill(s.light, levels, &SliceLevel::front, 0, layers);
        fill(s.light, levels, &SliceLevel::back, layers, layers);
    }
    for (const Texture* t : {&s.reflectance, &s.threshold, &s.light}) {
        glTextureParameteri(t->id(), GL_TEXTURE_WRAP_S, GL_REPEAT);
        glTextureParameteri(t->id(), GL_TEXTURE_WRAP_T, wrapUp);
    }
    return s;
}

float meanOpacity(const SliceLevel& l) {
    double sum = 0;
    for (size_t i = 1; i < l.threshold.size(); i += 4) sum += l.threshold[i];
    return static_cast<float>(4 * sum / (255.0 * static_cast<double>(l.threshold.size())));
}

}  // namespace

size_t SliceTextures::bytes() const {
    size_t n = 0;
    for (const Texture* t : {&reflectance, &threshold, &light, &farReflectance, &farThreshold, &farLight})
        n += t->tally.bytes();
    return n;
}

SliceTextures uploadSlices(Gpu& gpu, const std::string& owner, const std::string& farOwner, const SliceImages& images,
                           Storage storage, SliceSets sets, const SliceStand& stand) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);  // the last levels are narrower than 4 bytes
    SliceTextures out;
    out.slices = images.slices, out.top = images.top, out.reflectScale = images.reflectScale;
    out.layers = (sets == SliceSets::Shared ? 1 : 2) * images.slices;
    out.farDepth = -std::log(1 - std::min(meanOpacity(images.far[0]), 0.999f));
    out.means = drawnImagesOf(images, !owner.empty(), sets, stand);
    if (!owner.empty()) {
        Set s = uploadSet(gpu, owner, images.vertical, out.layers, storage, GL_CLAMP_TO_EDGE);
        out.reflectance = std::move(s.reflectance), out.threshold = std::move(s.threshold),
        out.light = std::move(s.light);
    }
    if (!farOwner.empty()) {
        Set s = uploadSet(gpu, farOwner, images.far, 1, storage, GL_REPEAT);
        out.farReflectance = std::move(s.reflectance), out.farThreshold = std::move(s.threshold),
        out.farLight = std::move(s.light);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    return out;
}

}  // namespace sward
