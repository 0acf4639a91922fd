#include "exchange/glb_check.h"

#include <tiny_gltf.h>

#include <cmath>
#include <cstring>

namespace sward {
namespace {

constexpr double kUnit = 1e-4;  // how far a quaternion's length may be from 1

Error fault(const std::string& what) { return failed("the .glb is not sound: " + what, "please report this"); }

// Images are not looked at: they are bytes of a file each.
bool keepImage(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
    return true;
}

struct Reader {
    const tinygltf::Model& m;

    const tinygltf::Accessor* accessor(int i) const {
        return i >= 0 && static_cast<size_t>(i) < m.accessors.size() ? &m.accessors[static_cast<size_t>(i)] : nullptr;
    }
    const unsigned char* data(const tinygltf::Accessor& a) const {
        const tinygltf::BufferView& view = m.bufferViews[static_cast<size_t>(a.bufferView)];
        return m.buffers[0].data.data() + view.byteOffset + a.byteOffset;
    }
    float at(const tinygltf::Accessor& a, size_t i, size_t c, size_t components) const {
        float v;
        std::memcpy(&v, data(a) + (i * components + c) * sizeof(float), sizeof v);
        return v;
    }
    uint32_t index(const tinygltf::Accessor& a, size_t i) const {
        uint32_t v;
        std::memcpy(&v, data(a) + i * sizeof v, sizeof v);
        return v;
    }
};

size_t componentsOf(const tinygltf::Accessor& a) {
    return static_cast<size_t>(tinygltf::GetNumComponentsInType(static_cast<uint32_t>(a.type)));
}

Status checkPlace(const Reader& r, const tinygltf::Accessor& a, size_t number) {
    const auto refused = [&](const char* what) { return fault(fmt::format("accessor {} {}", number, what)); };
    if (a.bufferView < 0 || static_cast<size_t>(a.bufferView) >= r.m.bufferViews.size())
        return refused("has no buffer view");
    const tinygltf::BufferView& view = r.m.bufferViews[static_cast<size_t>(a.bufferView)];
    const bool floats = a.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
    if (!floats && (a.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT || a.type != TINYGLTF_TYPE_SCALAR))
        return refused("is of a type that is not written here");
    if (view.buffer != 0 || view.byteStride != 0 || (view.byteOffset + a.byteOffset) % 4 != 0)
        return refused("does not begin at a multiple of 4 bytes");
    if (a.count == 0 || a.byteOffset + a.count * componentsOf(a) * 4 > view.byteLength ||
        view.byteOffset + view.byteLength > r.m.buffers[0].data.size())
        return refused("is empty, or leaves its view");
    return {};
}

Status checkNumbers(const Reader& r, const tinygltf::Accessor& a, size_t number) {
    if (a.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) return {};
    const size_t n = componentsOf(a);
    std::vector<double> low(n, INFINITY), high(n, -INFINITY);
    for (size_t i = 0; i < a.count; ++i)
        for (size_t c = 0; c < n; ++c) {
            const double v = static_cast<double>(r.at(a, i, c, n));
            if (!std::isfinite(v)) return fault(fmt::format("accessor {} holds a number that is not finite", number));
            low[c] = std::min(low[c], v), high[c] = std::max(high[c], v);
        }
    if ((!a.minValues.empty() && a.minValues != low) || (!a.maxValues.empty() && a.maxValues != high))
        return fault(fmt::format("accessor {} says other bounds than it has", number));
    return {};
}

Status checkPrimitive(const Reader& r, const tinygltf::Primitive& p, size_t mesh) {
    const auto refused = [&](const char* what) { return fault(fmt::format("mesh {} {}", mesh, what)); };
    const auto found = p.attributes.find("POSITION");
    const tinygltf::Accessor* positions = found == p.attributes.end() ? nullptr : r.accessor(found->second);
    const tinygltf::Accessor* indices = r.accessor(p.indices);
    if (!positions || !indices) return refused("has no positions or no corners");
    if (positions->minValues.size() != 3 || positions->maxValues.size() != 3)
        return refused("has positions without bounds");
    for (const auto& [name, number] : p.attributes)
        if (const tinygltf::Accessor* a = r.accessor(number); !a || a->count != positions->count)
            return refused("has attributes that differ in number");
    if (indices->count % 3 != 0) return refused("has corners that make no triangles");
    for (size_t i = 0; i < indices->count; ++i)
        if (r.index(*indices, i) >= positions->count) return refused("has a corner beyond its vertices");
    return {};
}

// How many there are.
Result<size_t> checkInstances(const Reader& r, const tinygltf::Value& extension, const std::string& name) {
    const auto refused = [&](const char* what) { return fault("node " + name + " " + what); };
    const auto named = [&](const char* attribute) {
        const tinygltf::Value& all = extension.Get("attributes");
        return all.Has(attribute) ? r.accessor(all.Get(attribute).GetNumberAsInt()) : nullptr;
    };
    const tinygltf::Accessor *at = named("TRANSLATION"), *turn = named("ROTATION"), *scale = named("SCALE");
    if (!at || !turn || !scale || at->type != TINYGLTF_TYPE_VEC3 || turn->type != TINYGLTF_TYPE_VEC4 ||
        scale->type != TINYGLTF_TYPE_VEC3)
        return refused("lacks TRANSLATION, ROTATION or SCALE of its instances");
    if (at->count != turn->count || at->count != scale->count) return refused("has attributes that differ in number");
    for (size_t i = 0; i < turn->count; ++i) {
        double length2 = 0;
        for (size_t c = 0; c < 4; ++c) {
            const double v = static_cast<double>(r.at(*turn, i, c, 4));
            length2 += v * v;
        }
        if (!(std::abs(std::sqrt(length2) - 1) < kUnit)) return refused("has a rotation that is not of length 1");
        for (size_t c = 0; c < 3; ++c)
            if (!(r.at(*scale, i, c, 3) > 0)) return refused("has a scale that is not above 0");
    }
    return at->count;
}

Status countNode(const Reader& r, const tinygltf::Node& n, const GlbNames& names, GlbCounts& out) {
    if (n.mesh >= static_cast<int>(r.m.meshes.size()) || n.camera >= static_cast<int>(r.m.cameras.size()))
        return fault("node " + n.name + " names what is not there");
    out.cameras += n.camera >= 0;
    out.lights += n.extensions.contains("KHR_lights_punctual");
    const auto instances = n.extensions.find("EXT_mesh_gpu_instancing");
    if (instances == n.extensions.end()) {
        if (n.mesh >= 0) ++(n.name.find('/') != std::string::npos ? out.chunks : out.objects);
        return {};
    }
    const Result<size_t> count = checkInstances(r, instances->second, n.name);
    if (!count) return count.error();
    if (names.scatters.contains(n.name)) {
        out.scattered += *count;
        return {};
    }
    ++out.cells;
    (names.flowers.contains(n.name) ? out.flowers : out.blades) += *count;
    return {};
}

uint32_t wordAt(const std::string& bytes, size_t at) {
    uint32_t v;
    std::memcpy(&v, bytes.data() + at, sizeof v);
    return v;
}

}  // namespace

Result<GlbCounts> checkGlb(const std::string& bytes, const GlbNames& names) {
    if (bytes.size() < 20 || bytes.compare(0, 4, "glTF") != 0) return fault("it is no .glb");
    if (wordAt(bytes, 8) != bytes.size() || bytes.size() % 4 != 0 || wordAt(bytes, 12) % 4 != 0)
        return fault("its lengths are no multiples of 4, or not the file's");
    tinygltf::Model m;
    tinygltf::TinyGLTF reader;
    reader.SetImageLoader(keepImage, nullptr);
    std::string error, warning;
    if (!reader.LoadBinaryFromMemory(&m, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<unsigned>(bytes.size())))
        return fault(error);
    const Reader r{m};
    for (size_t i = 0; i < m.accessors.size(); ++i) {
        if (Status s = checkPlace(r, m.accessors[i], i); !s) return s.error();
        if (Status s = checkNumbers(r, m.accessors[i], i); !s) return s.error();
    }
    for (size_t i = 0; i < m.meshes.size(); ++i)
        for (const tinygltf::Primitive& p : m.meshes[i].primitives)
            if (Status s = checkPrimitive(r, p, i); !s) return s.error();
    GlbCounts out;
    for (const tinygltf::Node& n : m.nodes)
        if (Status s = countNode(r, n, names, out); !s) return s.error();
    out.bytes = bytes.size();
    return out;
}

}  // namespace sward
