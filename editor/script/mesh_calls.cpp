// mesh.write: objects put together from simple shapes, as a .glb file.
#include "core/file.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "script/files.h"

namespace sward::script {
namespace {

constexpr float kFarthest = 1e4f;  // metres

int wholeOption(lua_State* L, Options& options, const char* name, int otherwise, int low, int high) {
    const double v = options.number(name, otherwise);
    if (!(v >= low && v <= high)) raise(L, fmt::format("{} must lie between {} and {}", name, low, high));
    return static_cast<int>(v);
}

SolidKind kindOption(lua_State* L, Options& options) {
    const std::string shape = options.text("shape");
    std::string names;
    for (size_t i = 0; i < std::size(kSolidKinds); ++i) {
        if (shape == kSolidKinds[i]) return static_cast<SolidKind>(i);
        names += (i ? ", " : "") + std::string(kSolidKinds[i]);
    }
    raise(L, fmt::format("shape is \"{}\"; there are {}", shape, names));
}

// Cylinders name what their size means.
glm::vec3 sizeOf(lua_State* L, Options& options, SolidKind kind) {
    if (kind != SolidKind::Cylinder) return vectorOption(L, options, "size", glm::vec3(1), kFarthest);
    const double radius = options.number("radius"), height = options.number("height"),
                 top = options.number("top", radius);
    if (!(radius >= 0 && top >= 0 && radius + top > 0 && height > 0 &&
          radius + top + height < static_cast<double>(kFarthest)))
        raise(L, "radius and top must be 0 or more, one of them and height above 0");
    return {static_cast<float>(radius), static_cast<float>(height), static_cast<float>(top)};
}

Solid solidAt(lua_State* L, int index) {
    Options options(L, index);
    Solid s;
    s.kind = kindOption(L, options);
    s.size = sizeOf(L, options, s.kind);
    s.at = vectorOption(L, options, "at", glm::vec3(0), kFarthest);
    s.turnDeg = vectorOption(L, options, "turn", glm::vec3(0), kFarthest);
    s.color = vectorOption(L, options, "color", glm::vec3(0.5f), kFarthest);
    s.sides = wholeOption(L, options, "sides", s.sides, 3, 256);
    s.count = wholeOption(L, options, "count", s.count, 1, 100000);
    s.leaf = static_cast<float>(options.number("leaf", s.leaf));
    s.rough = static_cast<float>(options.number("rough", s.rough));
    s.seed = static_cast<uint32_t>(wholeOption(L, options, "seed", 0, 0, 1'000'000'000));
    s.unwrap = options.flag("unwrap", false);
    options.finish();
    if (s.unwrap && s.kind != SolidKind::Box && s.kind != SolidKind::Ball)
        raise(L, "unwrap is for a box or a ball: other shapes have no texture coordinates");
    if (!(s.size.x > 0 || s.kind == SolidKind::Cylinder) || !(s.size.y > 0) || s.size.z < 0)
        raise(L, "size must be above 0");
    if (!(s.leaf > 0 && s.leaf < 100 && s.rough >= 0 && s.rough <= 1))
        raise(L, "leaf must be above 0, and rough between 0 and 1");
    if (glm::any(glm::lessThan(s.color, glm::vec3(0))) || glm::any(glm::greaterThan(s.color, glm::vec3(1))))
        raise(L, "color must lie between 0 and 1");
    return s;
}

// mesh.write(file, {{shape = "box", size = {x, y, z}, …}, …}): returns the number of triangles.
int write(lua_State* L, State&) {
    const std::filesystem::path file = writablePath(L, textArg(L, 1));
    luaL_checktype(L, 2, LUA_TTABLE);
    if (file.extension() != ".glb") raise(L, usage("objects are written as .glb", "name the file so").at(file));
    std::vector<Solid> solids;
    for (lua_Integer i = 1; i <= luaL_len(L, 2); ++i) {
        lua_geti(L, 2, i);
        solids.push_back(solidAt(L, lua_gettop(L)));
        charge(L, solids.back().kind == SolidKind::Leaves ? static_cast<uint64_t>(solids.back().count) * 300 : 100'000);
        lua_pop(L, 1);
    }
    const Mesh mesh = makeMesh(solids);
    if (mesh.indices.empty()) raise(L, "the object has no shape");
    const std::string bytes = orRaise(L, encodeGlb(mesh));
    orRaise(L, makeFolderOf(file));
    orRaise(L, writeFileAtomic(file, bytes));
    lua_pushinteger(L, static_cast<lua_Integer>(mesh.indices.size() / 3));
    return 1;
}

}  // namespace

void openMeshCalls(lua_State* L) {
    constexpr NamedCall calls[] = {{"write", luaCall<write>}};
    registerCalls(L, "mesh", calls);
}

}  // namespace sward::script
