#include "reference/grass_rays.h"

#include "core/numerics.h"
#include "reference/ray_field.h"

namespace sward {
namespace {

using Memory = GrassMemory::Tables;

// The part of [from, to] in which low <= origin + t way <= high; empty (from > to) if none.
std::pair<double, double> within(double origin, double way, double low, double high, double from, double to) {
    if (way == 0) return origin >= low && origin <= high ? std::pair{from, to} : std::pair{1.0, 0.0};
    const double a = (low - origin) / way, b = (high - origin) / way;
    return {std::max(from, std::min(a, b)), std::min(to, std::max(a, b))};
}

// Calls visit(x, z, from, to) for the cells whose blades a ray may meet, roughly in its order: by columns across the
// axis that it runs along. `end` may come nearer while it goes; columns that begin beyond are not visited.
template <class F>
void march(const RayField& f, const Ray& ray, double reach, const double& end, const F& visit) {
    const double size = static_cast<double>(f.grass->cellSize);
    const int major = std::abs(ray.way.x) >= std::abs(ray.way.z) ? 0 : 2, minor = 2 - major;
    const glm::dvec3 extent(f.terrain->size.x, 0, f.terrain->size.y);
    auto [from, to] = within(ray.origin.y, ray.way.y, static_cast<double>(f.bounds.low) - 1e-3,
                             static_cast<double>(f.bounds.high) + reach, ray.near, ray.far);
    std::tie(from, to) = within(ray.origin[major], ray.way[major], -reach, extent[major] + reach, from, to);
    std::tie(from, to) = within(ray.origin[minor], ray.way[minor], -reach, extent[minor] + reach, from, to);
    if (!(from <= to)) return;
    const auto cellsBetween = [&](int axis, double a, double b) {
        const double last = std::ceil(extent[axis] / size) - 1;
        const double low = std::min(ray.origin[axis] + ray.way[axis] * a, ray.origin[axis] + ray.way[axis] * b) - reach;
        const double high =
            std::max(ray.origin[axis] + ray.way[axis] * a, ray.origin[axis] + ray.way[axis] * b) + reach;
        return std::pair{static_cast<int>(std::clamp(std::floor(low / size), 0.0, last)),
                         static_cast<int>(std::clamp(std::floor(high / size), 0.0, last))};
    };
    const auto [first, last] = cellsBetween(major, from, to);
    for (int n = 0; n <= last - first; ++n) {
        const int i = ray.way[major] < 0 ? last - n : first + n;
        const auto [a, b] =
            within(ray.origin[major], ray.way[major], i * size - reach, (i + 1) * size + reach, from, to);
        if (a > end) return;
        if (!(a <= b)) continue;
        const auto [low, high] = cellsBetween(minor, a, b);
        for (int m = 0; m <= high - low; ++m) {
            const int j = ray.way[minor] < 0 ? high - m : low + m;
            const auto [c, d] =
                within(ray.origin[minor], ray.way[minor], j * size - reach, (j + 1) * size + reach, a, b);
            if (c <= d && c <= end) visit(major == 0 ? i : j, major == 0 ? j : i, c, d);
        }
    }
}

// A cell that begins its patch at `start` (metres) shows it in up to four pieces. Calls ask(origin in the patch, how
// far) for those that the ray o + t w, t < far, may meet; o in the cell, already mirrored. Blades of another piece that
// it meets so are met where they are.
template <class F>
void eachPiece(const glm::vec2& start, float size, float reach, const glm::vec3& o, const glm::vec3& w, float far,
               const F& ask) {
    for (int i = 0; i < 4; ++i) {
        const bool wrapsX = i & 1, wrapsZ = i & 2;
        if ((wrapsX && start.x <= 0) || (wrapsZ && start.y <= 0)) continue;
        const auto part = [&](bool wraps, float begin, float at, float way, double from, double to) {
            return within(static_cast<double>(at), static_cast<double>(way),
                          static_cast<double>((wraps ? 0 : begin) - reach),
                          static_cast<double>((wraps ? begin : size) + reach), from, to);
        };
        auto [from, to] = part(wrapsX, start.x, o.x, w.x, 0, static_cast<double>(far));
        std::tie(from, to) = part(wrapsZ, start.y, o.z, w.z, from, to);
        if (from <= to)
            ask(o - glm::vec3(start.x - (wrapsX ? size : 0), 0, start.y - (wrapsZ ? size : 0)),
                static_cast<float>(to) * 1.0001f + 1e-6f);
    }
}

// Calls ask(query, embree's scene and ray, where on the ray that begins) for each species in each cell on the way that
// has anything to meet.
template <class F>
void eachScene(const RayField& f, const Ray& ray, Memory& memory, const double& end, const F& ask) {
    if (f.kinds.empty()) return;
    const double size = static_cast<double>(f.grass->cellSize);
    for (size_t k = 0; k < f.kinds.size(); ++k) {
        const Kind& kind = *f.kinds[k];
        const double reach = static_cast<double>(kind.reach);
        march(f, ray, reach, end, [&](int x, int z, double from, double to) {
            Cell& cell = cellAt(f, memory, k, x, z);
            if (!cell.scene) return;
            const auto [a, b] = within(ray.origin.y, ray.way.y, cell.base + static_cast<double>(cell.ground.low) - 1e-3,
                                       cell.base + static_cast<double>(cell.ground.high) + reach, from, to);
            if (!(a <= b)) return;
            const PosedCell* posed = posedCell(f, k, cell, x, z);
            Query q{{}, &f, k, &kind, &memory, &cell, posed, x, z, {}, glm::vec3(ray.way), ray.grain};
            q.origin = glm::vec3(ray.origin + ray.way * a - glm::dvec3(x * size, cell.base, z * size));
            const float far = static_cast<float>(std::min(end, b) - a) * 1.0001f + 1e-6f;
            if (posed) return void(ask(q, posed->scene.get(), embreeRay(q.origin, q.way, 0, far), a));
            // Into the patch's frame: over the plane of the ground, mirrored, and begun where the cell begins the
            // patch.
            const CellGround& g = cell.ground;
            glm::vec3 o = q.origin, w = q.way;
            o.y -= g.slopeX * o.x + g.slopeZ * o.z, w.y -= g.slopeX * w.x + g.slopeZ * w.z;
            if (cell.version.mirror.x < 0) o.x = f.grass->cellSize - o.x, w.x = -w.x;
            if (cell.version.mirror.y < 0) o.z = f.grass->cellSize - o.z, w.z = -w.z;
            eachPiece(
                cell.version.shift * f.grass->cellSize, f.grass->cellSize, kind.reach, o, w, far,
                [&](const glm::vec3& start, float piece) { ask(q, cell.scene, embreeRay(start, w, 0, piece), a); });
        });
    }
}

glm::vec3 bladeColor(const RayField& f, const Query& q, const Blade& b, const Posed& p, float v,
                     const glm::dvec2& place) {
    const Species& s = *q.kind->species;
    const glm::vec3 c =
        f32::bladeTint(f32::bladeGradient(s.rootColor, s.midColor, s.tipColor, v), b.hue, b.lightness * p.lighter);
    if (!f.grass->vegetation.present()) return c;
    const glm::vec4 paint =
        paintedAt(f.grass->vegetation.map, place, static_cast<double>(f.grass->vegetationTiling), true);
    return glm::mix(c, glm::vec3(paint), paint.w);
}

Surface bladeSurface(const RayField& f, const Ray& ray, const Query& q, double t) {
    Surface s;
    s.met = Met::Blade;
    s.t = t;
    s.at = ray.origin + ray.way * t;
    const Posed p = poseBladeAt(f, *q.kind, *q.cell, q.x, q.z, q.blade, &s.place);
    s.normal = f32::bladeFrameFacing(p.control, p.tip, p.facing, q.hit.v).normal;
    if (glm::dot(glm::dvec3(s.normal), ray.way) > 0) s.normal = -s.normal;
    s.face = s.normal;
    s.color = bladeColor(f, q, q.kind->blades()[q.cell->first + q.blade], p, q.hit.v, s.place);
    const Species& species = *q.kind->species;
    s.looks = {species.translucency, species.gloss, species.roughness};
    s.tint = 2.0f *
             glm::vec3(q.kind->image.at(static_cast<double>(q.hit.across) + 0.5, static_cast<double>(q.hit.v), false));
    s.open = glm::mix(species.rootOcclusion, 1.0f, q.hit.v);
    s.field = f.number;
    return s;
}

}  // namespace

GrassRays::GrassRays() = default;
GrassRays::GrassRays(GrassRays&&) noexcept = default;
GrassRays& GrassRays::operator=(GrassRays&&) noexcept = default;
GrassRays::~GrassRays() = default;

Result<GrassRays> GrassRays::make(const Project& p, double time, const JobControl& control) {
    auto fields = makeRayFields(p, time, control);
    if (!fields) return fields.error();
    GrassRays rays;
    rays.fields_ = std::move(*fields);
    return rays;
}

std::optional<Surface> GrassRays::closest(const Ray& ray, GrassMemory& memory) const {
    double end = ray.far;
    std::optional<Query> best;
    for (const auto& field : fields_)
        eachScene(*field, ray, *memory.tables, end, [&](Query& q, RTCScene scene, const RTCRay& r, double from) {
            RTCRayHit hit{r, {}};
            closestHit(scene, q.context, hit);
            if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
            const double t = from + static_cast<double>(hit.ray.tfar);
            if (t >= end) return;
            end = t;
            best = q;
            if (q.posed) best->blade = numberOf(*q.posed, q.blade);
        });
    if (!best) return std::nullopt;
    // The memory may have given the cell's place to another: its number is the query's.
    const Cell cell = cellAt(*best->field, *memory.tables, best->number, best->x, best->z);
    best->cell = &cell;
    return bladeSurface(*best->field, ray, *best, end);
}

float GrassRays::lightLeft(const glm::dvec2& place, const glm::vec3& towards, const glm::vec3& normal,
                           FieldBits of) const {
    const glm::vec2 slope = -glm::vec2(normal.x, normal.z) / std::max(normal.y, 0.05f);
    float left = 1;
    for (const auto& field : fields_) {
        if (!(of >> field->number & 1)) continue;
        const glm::dvec2 ground = place * mapExtent(*field->terrain);
        for (const auto& kind : field->kinds)
            left *= glm::mix(1.0f, std::pow(sward::lightLeft(kind->look, towards, slope), bladeShareAt(*field, ground)),
                             densityAt(*field, *kind->species, ground));
    }
    return left;
}

bool GrassRays::blocks(const Ray& ray, GrassMemory& memory, FieldBits of) const {
    double end = ray.far;
    bool blocked = false;
    for (const auto& field : fields_) {
        if (blocked || !(of >> field->number & 1)) continue;
        eachScene(*field, ray, *memory.tables, end, [&](Query& q, RTCScene scene, const RTCRay& r, double) {
            if (blocked || !anyHit(scene, q.context, r)) return;
            blocked = true;
            end = -std::numeric_limits<double>::infinity();
        });
    }
    return blocked;
}

}  // namespace sward
