#include "world/layered_tiles.h"

#include <algorithm>

#include "core/numerics.h"
#include "world/layer_coverage.h"

namespace sward {
namespace {

constexpr const char* kHidesAll = "it is 0 everywhere and hides all of the map: widen or invert it";
constexpr const char* kChangesNothing = "it is 0 everywhere and changes nothing: widen or invert it";

// Kept within 0 to 1.
float changed(const MapLayer& layer, float below, float amount) {
    return below + layer.opacity * (std::clamp(combined(layer.operation, below, amount), 0.0f, 1.0f) - below);
}

// --- amounts
Status anyFits(const MapLayer&) { return {}; }

std::string zeroAmounts(const MapLayer& layer) {
    switch (layer.operation) {
        case LayerOperation::Multiply:
        case LayerOperation::Replace:
        case LayerOperation::Minimum:
            return layer.opacity < 1 ? "" : kHidesAll;
        default:
            return layer.operation == LayerOperation::Subtract && layer.invert ? "" : kChangesNothing;
    }
}

void combineAmounts(const Map& painted, const std::vector<LayerOver>& layers, TilePlace at, Numbers& out) {
    if (painted.empty())
        std::fill(out.begin(), out.end(), 1.0f);
    else
        readTile(painted, at.x, at.y, out);
    Numbers amounts(kTileTexels);
    for (const LayerOver& over : layers) {
        readTile(*over.coverage, at.x, at.y, amounts);
        for (size_t i = 0; i < kTileTexels; ++i) out[i] = changed(*over.layer, out[i], amounts[i]);
    }
}

// --- colours
bool takesAway(LayerOperation operation) {
    return operation == LayerOperation::Multiply || operation == LayerOperation::Subtract ||
           operation == LayerOperation::Minimum;
}
Status colourFits(const MapLayer& layer) {
    if (layer.operation == LayerOperation::Replace || takesAway(layer.operation)) return {};
    return unsound(
        "over colours a layer lays its own by replace, or takes away what lies below by multiply, subtract or minimum",
        "choose one of them");
}

std::string zeroColours(const MapLayer& layer) {
    const bool hides = layer.operation == LayerOperation::Multiply || layer.operation == LayerOperation::Minimum;
    return !hides ? kChangesNothing : layer.opacity < 1 ? "" : kHidesAll;
}

glm::vec3 encoded(const glm::vec3& linear) {
    return {f32::srgbEncode(linear.x), f32::srgbEncode(linear.y), f32::srgbEncode(linear.z)};
}

// A texel where nothing is takes the colour, too, of no opacity: filters mix colours before they ask for opacity, and
// the layer's edge would be dark.
void lay(const MapLayer& layer, const Numbers& amounts, Numbers& out) {
    const glm::vec3 clear = encoded(layer.color);
    for (size_t i = 0; i < kTileTexels; ++i) {
        float* texel = &out[4 * i];
        const glm::vec4 below(texel[0], texel[1], texel[2], texel[3]);
        const float share = layer.opacity * amounts[i];
        if (share == 0 && below != glm::vec4(0)) continue;
        const glm::vec4 now = share == 0 ? glm::vec4(clear, 0) : laidOver(below, layer.color, share);
        for (int c = 0; c < 4; ++c) texel[c] = now[c];
    }
}

void combineColours(const Map& painted, const std::vector<LayerOver>& layers, TilePlace at, Numbers& out) {
    if (painted.empty())
        std::fill(out.begin(), out.end(), 0.0f);
    else
        readTile(painted, at.x, at.y, out);
    Numbers amounts(kTileTexels);
    for (const LayerOver& over : layers) {
        readTile(*over.coverage, at.x, at.y, amounts);
        if (takesAway(over.layer->operation))
            for (size_t i = 0; i < kTileTexels; ++i) out[4 * i + 3] = changed(*over.layer, out[4 * i + 3], amounts[i]);
        else
            lay(*over.layer, amounts, out);
    }
}

constexpr LayeredKind kLayeredKinds[] = {
    {MapKind::Amounts, anyFits, zeroAmounts, combineAmounts},
    {MapKind::Colours, colourFits, zeroColours, combineColours},
};

}  // namespace

const LayeredKind* layeredKind(MapKind kind) {
    const auto found = std::find_if(std::begin(kLayeredKinds), std::end(kLayeredKinds),
                                    [&](const LayeredKind& k) { return k.kind == kind; });
    return found == std::end(kLayeredKinds) ? nullptr : found;
}

glm::vec4 laidOver(const glm::vec4& below, const glm::vec3& color, float share) {
    const float under = below.w * (1 - share), opacity = share + under;
    const glm::vec3 light(f32::srgbDecode(below.x), f32::srgbDecode(below.y), f32::srgbDecode(below.z));
    return {encoded((share * color + under * light) / opacity), opacity};
}

}  // namespace sward
