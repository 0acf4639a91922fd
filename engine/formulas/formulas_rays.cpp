// Rows of Habel, Wimmer, Jeschke 2007: rays through slices, tangent frames, compositing, depth.
// clang-format off: bodies are laid out as the shader lines that they become
#include "formulas/formula_table.h"

namespace sward {
namespace {

constexpr int kMaxHits = 8;

std::vector<double> rayInputs(const ExpectedRecord& r) {
    std::vector<double> in = r.at("e");
    in.insert(in.end(), r.at("d").begin(), r.at("d").end());
    for (const char* field : {"nu", "nv", "h"}) in.push_back(r.at(field)[0]);
    return in;
}

// All hits, six numbers each: family, slice, t, position. Slots after the last hit hold -1 and zeros. t counts
// relative.
FormulaSamples rayHits(const ExpectedValues& values) {
    FormulaSamples samples;
    const auto group = values.find("slice_rays");
    if (group == values.end()) return samples;
    for (const ExpectedRecord& r : group->second) {
        std::vector<double> want = r.at("hits"), scale;
        while (want.size() < 6 * kMaxHits) want.push_back(want.size() % 6 == 0 ? -1 : 0);
        for (size_t i = 0; i < want.size(); ++i) scale.push_back(i % 6 == 2 && want[i] != 0 ? std::abs(want[i]) : 1.0);
        samples.add(rayInputs(r), want, scale);
    }
    return samples;
}

// Only where the first hit lies.
FormulaSamples firstHits(const ExpectedValues& values) {
    FormulaSamples samples;
    const auto group = values.find("slice_rays");
    if (group == values.end()) return samples;
    for (const ExpectedRecord& r : group->second) {
        const auto& hits = r.at("hits");
        if (!hits.empty()) samples.add(rayInputs(r), {hits[2]}, {hits[2] == 0 ? 1.0 : std::abs(hits[2])});
    }
    return samples;
}

// Rays that enter exactly on a slice of the u family: the first hit is there, whichever way they go.
FormulaSamples entriesOnSlices(const ExpectedValues&) {
    FormulaSamples samples;
    Sweep s(22);
    for (int i = 0; i < 400; ++i)
        samples.add(
            {s.whole(-16, 16) / 16.0, s.unit(), 0, (i % 2 ? 1 : -1) * s.in(0.1, 1), s.in(-1, 1), -0.5, 16, 16, 0.25},
            {0});
    return samples;
}

const FormulaBody kAllHits =
    BODY(SliceRay r = sliceRay(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), int(x[6]), int(x[7]), x[8]);
         bool over = false; for (int i = 0; i < 8; i++) {
             SliceHit hit = sliceHit(r);
             if (hit.family == kRayNone) over = true;
             y[6 * i] = over ? real(-1.0) : real(hit.family);
             y[6 * i + 1] = over ? real(0.0) : real(hit.k);
             y[6 * i + 2] = over ? real(0.0) : hit.t;
             y[6 * i + 3] = over ? real(0.0) : hit.position.x;
             y[6 * i + 4] = over ? real(0.0) : hit.position.y;
             y[6 * i + 5] = over ? real(0.0) : hit.position.z;
             if (hit.family == kRayGround) over = true;
             r = sliceAfter(r, hit);
         });
const FormulaBody kFirstHit =
    BODY(SliceRay r = sliceRay(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), int(x[6]), int(x[7]), x[8]);
         y[0] = sliceHit(r).t;);
const FormulaBody kFirstHitPublished =
    BODY(y[0] = firstHitPublished(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), int(x[6]), int(x[7]), x[8]););

void addHitCases(std::vector<FormulaRow>& rows) {
    rows.push_back({.id = "H-1",
                    .name = "first hit of a ray, relative; parallel and vertical rays too",
                    .inputs = 9,
                    .outputs = 1,
                    .ours = kFirstHit,
                    .published = kFirstHitPublished,
                    .samples = firstHits,
                    .tolerance = 4e-6,
                    .methodTolerance = 1e-9,
                    .low = 0,
                    .high = 1e20});
    rows.push_back({.id = "H-1",
                    .name = "all hits of a ray",
                    .inputs = 9,
                    .outputs = 6 * kMaxHits,
                    .ours = kAllHits,
                    .samples = rayHits,
                    .tolerance = 4e-6,
                    .methodTolerance = 1e-9,
                    .low = -1000,
                    .high = 1e20});
    rows.push_back({.id = "H-2",
                    .name = "first hit of rays that enter on a slice",
                    .inputs = 9,
                    .outputs = 1,
                    .ours = kFirstHit,
                    .published = kFirstHitPublished,
                    .samples = entriesOnSlices,
                    .low = 0,
                    .high = 0});
    rows.push_back({
        .id = "H-3", .name = "hits of diagonal rays: u before v at one t", .inputs = 9, .outputs = 3,
        .ours = BODY(SliceRay r = sliceRay(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), int(x[6]), int(x[7]), x[8]);
                     SliceHit a = sliceHit(r); r = sliceAfter(r, a); SliceHit b = sliceHit(r); y[0] = real(a.family);
                     y[1] = real(b.family); y[2] = b.t - a.t;),
        .samples = listed({{0.25, 0.25, 0, -1, -1, -0.25, 16, 16, 0.25},
                           {0.3125, 0.3125, 0, 1, 1, -0.5, 16, 16, 0.25},
                           {0.1, 0.1, 0, 1, 1, -0.5, 8, 8, 0.25},
                           {0.4, 0.6, 0, 1, -1, -0.5, 8, 8, 0.25}},
                          {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}}),
        .tolerance = 2e-7, .methodTolerance = 1e-7, .low = -1, .high = 2
    });
    rows.push_back({
        .id = "H-4", .name = "plane reached after many steps", .inputs = 2, .outputs = 1,
        .ours = BODY(y[0] = real(int(x[0])) / x[1];),
        .published =
            BODY(real p = 0.0f; real d = 1.0f / x[1]; for (int i = 0; i < int(x[0]); i++) { p += d; } y[0] = p;),
        .samples = listed({{1000, 10}, {1000, 16}, {10000, 30}, {4000, 48}}), .tolerance = 2e-5, .low = 0, .high = 1e4
    });
    rows.push_back({
        .id = "H-5", .name = "where a grazing or rising ray ends", .inputs = 9, .outputs = 1,
        .ours = BODY(SliceRay r = sliceRay(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), int(x[6]), int(x[7]), x[8]);
                     y[0] = min(r.end, kRayNever);),
        .published = BODY(y[0] = min((-x[8] - x[2]) / x[5], kRayNever);),
        .samples = listed({{0.3, 0.1, 0, 1, 0.5, 0, 16, 16, 0.25},
                           {0.3, 0.1, 0, 1, 0.5, -0.0, 16, 16, 0.25},
                           {0.3, 0.1, 0, 1, 0.5, 0.5, 16, 16, 0.25},
                           {0.3, 0.1, -0.125, 1, 0.5, 0.5, 16, 16, 0.25},
                           {0.3, 0.1, -0.125, 1, 0.5, -0.5, 16, 16, 0.25}},
                          {{1e20}, {1e20}, {0}, {0.25}, {0.25}}),
        .tolerance = 1e-6, .low = 0, .high = 1.0000001e20,
        .error = [](double got, double want, double) { return relativeError(got, want, 1.0); }
    });
}

// Unit normals, every other one close to straight down, where 1 / (1 + n.z) fails.
std::vector<double> hardNormal(Sweep& s, int i) {
    if (i < 2) return {0, 0, i == 0 ? 1.0 : -1.0};
    if (i % 2) return s.direction();
    const double tilt = s.size(1e-6, 1e-2), a = s.in(-3, 3);
    return {double(float(std::sin(tilt) * std::cos(a))), double(float(std::sin(tilt) * std::sin(a))),
            double(float(-std::cos(tilt)))};
}

void addFrameCases(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "H-6", .name = "tangent frame of any normal: away from orthonormal", .inputs = 3, .outputs = 3,
        .ours =
            BODY(vec3 n = vec3(x[0], x[1], x[2]); TangentFrame f = tangentFrame(n);
                 y[0] = abs(dot(f.tangent, f.tangent) - 1.0f) + abs(dot(f.bitangent, f.bitangent) - 1.0f);
                 y[1] = abs(dot(f.tangent, f.bitangent)); y[2] = abs(dot(f.tangent, n)) + abs(dot(f.bitangent, n));),
        .published =
            BODY(vec3 n = vec3(x[0], x[1], x[2]); TangentFrame f = tangentFramePublished(n);
                 y[0] = abs(dot(f.tangent, f.tangent) - 1.0f) + abs(dot(f.bitangent, f.bitangent) - 1.0f);
                 y[1] = abs(dot(f.tangent, f.bitangent)); y[2] = abs(dot(f.tangent, n)) + abs(dot(f.bitangent, n));),
        .samples =
            [](const ExpectedValues&) {
                FormulaSamples samples;
                Sweep s(26);
                for (int i = 0; i < 2000; ++i) samples.add(hardNormal(s, i), {0, 0, 0});
                return samples;
            },
        .tolerance = 1e-6, .methodTolerance = 5e-7, .low = 0, .high = 1
    });
    rows.push_back({
        .id = "H-7", .name = "transmittance after layers of opacity above and below 1", .inputs = 2, .outputs = 1,
        .ours = BODY(Layers l; l.color = vec3(0.0f, 0.0f, 0.0f); l.transmittance = 1.0f;
                     for (int i = 0; i < int(x[1]); i++) { l = layersUnder(l, vec3(x[0], x[0], x[0]), x[0]); } y[0] =
                         l.transmittance;),
        .published =
            BODY(real a = 0.0f; for (int i = 0; i < int(x[1]); i++) { a = a + (1.0f - a) * x[0]; } y[0] = 1.0f - a;),
        .samples = listed({{1.2, 1}, {1.2, 3}, {0.6, 2}, {0.1, 64}, {0.1, 200}, {0, 9}, {-0.5, 3}, {1, 2}}),
        .tolerance = 1.5e-5, .low = 0, .high = 1,
        .error = [](double got, double want, double) { return relativeError(got, want, 1e-12); }
    });
    rows.push_back({
        .id = "H-8", .name = "depth of a hit, behind the near plane too", .inputs = 6, .outputs = 1,
        .ours = BODY(y[0] = hitDepth(vec4(x[0], x[1], x[2], x[3]), x[4], x[5]);),
        .published = BODY(y[0] = x[2] / x[3];),
        .samples = listed({{0, 0, 0.1, 5, 0.025, 0.1},
                           {0, 0, 0.1, 0, 0.9, 0.1},
                           {0, 0, 0.1, -1, 0.9, 0.1},
                           {0, 0, 0.1, 0.05, 0.9, 0.1},
                           {0, 0, 0.1, 0.2, 0.4, 0.1}},
                          {{0.02}, {0.9}, {0.9}, {0.9}, {0.4}}),
        .tolerance = 1e-7, .methodTolerance = 1e-7, .low = 0, .high = 1
    });
}

}  // namespace

void addRayRows(std::vector<FormulaRow>& rows) {
    addHitCases(rows);
    addFrameCases(rows);
}

}  // namespace sward
