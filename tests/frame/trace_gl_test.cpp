// What a scene lacks is not run, not compiled, not in memory: adding and removing each component and each map leaves
// plan, programs and bytes as before.
#include "core/json.h"
#include "everything.h"
#include "scene/forest.h"
#include "techniques.h"

namespace sward::test {
namespace {

struct Trace {
    std::string plan;  // explain --json: features, systems, passes, programs, bytes
    std::vector<std::string> programs;
    std::map<std::string, int64_t> ledger;
    std::vector<uint8_t> image;
};

// Everything at once lies a hundred slices deep: pictures that are compared to the byte need few pixels.
Trace traceOf(Renderer& renderer, Project& p) {
    ViewSettings settings = small();
    settings.width = 64, settings.height = 48;
    const Status drawn = renderer.draw(p, eyeHeight(), settings);
    EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().text());
    return {renderer.explain(p, true), renderer.programNames(), gpu().ledger, renderer.readImage()};
}

// The first line in which two texts differ.
std::string difference(const std::string& a, const std::string& b) {
    const size_t n = static_cast<size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
    const size_t line = a.rfind('\n', n) + 1;
    return a.substr(line, a.find('\n', n) - line) + " | " + b.substr(std::min(line, b.size()), 60);
}

void expectSame(const Trace& a, const Trace& b, const std::string& what) {
    EXPECT_TRUE(a.plan == b.plan) << what << ": " << difference(a.plan, b.plan);
    EXPECT_EQ(a.programs, b.programs) << what;
    EXPECT_EQ(a.ledger, b.ledger) << what;
    EXPECT_TRUE(a.image == b.image) << what << ": the picture differs";
}

TEST(Trace, AddingAndRemovingEachComponentLeavesNothing) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    Project p = everything();
    const Trace before = traceOf(renderer, p);
    for (const ComponentRow& row : tables().components) {
        const Entity e = *addEntity(p, "aaa-added");
        row.assign(p.registry, e, nullptr);
        traceOf(renderer, p);
        row.remove(p.registry, e);
        removeEntity(p, "aaa-added");
        expectSame(before, traceOf(renderer, p), std::string(row.name) + " added and removed");
    }
}

// A change that takes something from a scene, and the scene with it and as if it had never been there.
struct Removal {
    std::string what;
    std::function<void(Project&)> change;
    Trace with = {}, never = {};
};
// One renderer meets all changes, so that nothing may be left of those before either; the ledger is the context's, so
// what never was is drawn first, by renderers of its own.
void expectNoTraces(std::vector<Removal>& removals) {
    NoGlErrors errors;
    for (Removal& r : removals) {
        Project without = everything();
        r.change(without);
        Renderer fresh(gpu(), tables());
        r.never = traceOf(fresh, without);
    }
    Renderer renderer(gpu(), tables());
    for (Removal& r : removals) {
        Project p = everything();
        r.with = traceOf(renderer, p);
        r.change(p);
        expectSame(r.never, traceOf(renderer, p), r.what);
    }
}

bool standsIn(const Project& p, const ComponentRow& row) {
    return std::ranges::any_of(p.entities, [&](const auto& named) { return row.get(p.registry, named.second); });
}

void removeAll(Project& p, const ComponentRow& row) {
    for (auto& [name, e] : p.entities) row.remove(p.registry, e);
}
// The rows of all components that the scene has; those that it lacks ask for nothing.
std::vector<const ComponentRow*> rowsOf(const Project& all) {
    std::vector<const ComponentRow*> rows;
    for (const ComponentRow& row : tables().components)
        if (standsIn(all, row))
            rows.push_back(&row);
        else
            EXPECT_FALSE(row.features(row.defaults()).any()) << "no entity of the scene has " << row.name;
    return rows;
}

TEST(Trace, RemovingEachComponentLeavesTheSceneThatNeverHadIt) {
    std::vector<Removal> removals;
    for (const ComponentRow* row : rowsOf(everything()))
        removals.push_back({std::string("without ") + row->name, [row](Project& p) { removeAll(p, *row); }});
    expectNoTraces(removals);
}

// All components of the table, dealt out into a few handfuls, and each handful gone at once: sooner than one by one.
TEST(Trace, RemovingHandfulsOfComponentsLeavesTheSceneThatNeverHadThem) {
    constexpr size_t kHandfuls = 2;
    const std::vector<const ComponentRow*> rows = rowsOf(everything());
    std::vector<Removal> removals;
    for (size_t hand = 0; hand < kHandfuls; ++hand)
        removals.push_back({fmt::format("without handful {}", hand), [&rows, hand](Project& p) {
                                for (size_t i = hand; i < rows.size(); i += kHandfuls) removeAll(p, *rows[i]);
                            }});
    expectNoTraces(removals);
}

TEST(Trace, EachComponentMakesADifferenceToThePlan) {
    Renderer renderer(gpu(), tables());
    Project all = everything();
    const std::string with = renderer.explain(all, true);
    for (const ComponentRow* row : rowsOf(all)) {
        Project p = everything();
        removeAll(p, *row);
        if (row->features(row->defaults()).any())
            EXPECT_TRUE(renderer.explain(p, true) != with) << row->name << " makes no difference to the plan";
    }
}

TEST(TraceMaps, RemovingEachLeavesTheSceneThatNeverHadIt) {
    Project all = everything();
    std::vector<Removal> removals;
    for (const FieldRef& map : allMaps(all, tables().components))
        removals.push_back({"without " + map.path, [path = map.path](Project& p) {
                                *static_cast<MapField*>(findField(p, tables().components, path)->value) = {};
                            }});
    expectNoTraces(removals);
    for (const Removal& r : removals) {
        EXPECT_TRUE(r.with.plan != r.never.plan) << r.what;
        EXPECT_GT(r.with.ledger.size(), r.never.ledger.size()) << r.what << " frees no memory of its own";
    }
}

// What ends a tier or a kind of shadow without any component or map going.
TEST(TraceSettings, ThatEndATierLeaveTheSceneThatNeverHadIt) {
    const auto grass = [](Project& p) { return flatField(p, "grass"); };
    const auto technique = [&](Technique t) { return [&grass, t](Project& p) { grass(p).technique = nameOf(t); }; };
    std::vector<Removal> removals = {
        {"blades alone", technique(Technique::Geometry)},
        {"slices alone", technique(Technique::Slices)},
        {"the horizontal slice alone", technique(Technique::Flat)},
        {"tessellated blades", technique(Technique::Tessellated)},
        {"no vertical slices", [&](Project& p) { grass(p).minBTF = grass(p).maxBTF = 0; }},
        {"no slices at all",
         [&](Project& p) { grass(p).minGeom = grass(p).maxGeom = std::numeric_limits<float>::infinity(); }},
        {"blades that do not shade blades", [&](Project& p) { grass(p).shadowMask = 0; }},
        {"blades that do not shade the ground", [&](Project& p) { grass(p).groundShadows = false; }},
        {"lights that cast no shadows",
         [](Project& p) {
             for (const auto& [name, e] : p.entities)
                 if (Light* l = p.registry.get<Light>(e)) l->castShadows = false;
         }},
        {"a calm", [](Project& p) { p.registry.get<Wind>(findEntity(p, "wind"))->strength = 0; }},
        {"wind in waves", [](Project& p) { p.registry.get<Wind>(findEntity(p, "wind"))->model = WindModel::Waves; }},
        {"forces without strength",
         [](Project& p) {
             for (const char* name : {"stone", "cube"}) p.registry.get<ForceSource>(findEntity(p, name))->strength = 0;
         }},
        {"no force of an outline",
         [](Project& p) { p.registry.get<ForceSource>(findEntity(p, "cube"))->shape = ForceShape::Object; }},
        {"nothing blurred far away", [&](Project& p) { grass(p).farBlur = FarBlur::None; }},
        {"nothing darkened far away", [&](Project& p) { grass(p).farDarkening = 0; }},
        {"bare ground beyond tessellated blades",
         [&](Project& p) { grass(p).technique = nameOf(Technique::Tessellated), grass(p).beyond = Beyond::Nothing; }},
        {"water that mirrors the sky alone",
         [](Project& p) { p.registry.get<Water>(findEntity(p, "lake"))->reflection = 0; }},
        {"flowers of which there are none",
         [](Project& p) { p.registry.get<Flowers>(findEntity(p, "flowers"))->flowersPerM2 = 0; }},
        {"a rule that scatters nothing",
         [](Project& p) { p.registry.get<Scatter>(findEntity(p, "stones"))->perHectare = 0; }},
        {"trees as meshes alone",
         [](Project& p) {
             p.registry.get<Forest>(findEntity(p, "trees"))->meshesTo = std::numeric_limits<float>::infinity();
         }},
        {"trees as volumes alone", [](Project& p) { p.registry.get<Forest>(findEntity(p, "trees"))->meshesTo = 0; }},
        {"a forest of no trees", [](Project& p) { p.registry.get<Forest>(findEntity(p, "trees"))->perHectare = 0; }},
        {"grass without blades", [&](Project& p) { grass(p).species[0].bladesPerM2 = 0; }},
    };
    expectNoTraces(removals);
    for (const Removal& r : removals) EXPECT_TRUE(r.with.plan != r.never.plan) << r.what;
}

TEST(Trace, NothingOfTessellationIsThereForAnotherTechnique) {
    NoGlErrors errors;
    for (const Technique other : {Technique::Hybrid, Technique::Geometry, Technique::Flat}) {
        const auto become = [](Project& p, Technique t) { flatField(p, "grass").technique = nameOf(t); };
        Project p = everything();
        become(p, other);
        Trace never;
        {
            Renderer fresh(gpu(), tables());
            never = traceOf(fresh, p);
        }
        for (const std::string& program : never.programs)
            EXPECT_EQ(program.find("tessellated"), std::string::npos) << program;
        Renderer renderer(gpu(), tables());
        become(p, Technique::Tessellated);
        EXPECT_GT(traceOf(renderer, p).ledger.count("grass/tessellated"), 0u);
        become(p, other);
        expectSame(never, traceOf(renderer, p), nameOf(other));
    }
}

TEST(Trace, AForceThatStandsNowhereIsAsIfItWereNotThere) {
    NoGlErrors errors;
    Project p = lawn();
    Trace never;
    {
        Renderer fresh(gpu(), tables());
        never = traceOf(fresh, p);
    }
    put<ForceSource>(p, "feet").shape = ForceShape::Foot;
    Renderer renderer(gpu(), tables());
    expectSame(never, traceOf(renderer, p), "a source without a Transform");
    put(p, "feet", Transform{{10, 0, 8}});
    EXPECT_GT(traceOf(renderer, p).ledger.count("grass/forces"), 0u);
}

TEST(Trace, AnEmptySceneRunsOnlyWhatEveryPictureNeeds) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    Project p;
    const Trace t = traceOf(renderer, p);
    EXPECT_EQ(t.programs, (std::vector<std::string>{"post/tonemap"}));
    for (const auto& [owner, bytes] : t.ledger) EXPECT_EQ(owner.rfind("frame/", 0), 0u) << owner << " holds " << bytes;
}

TEST(Trace, ARendererGivesBackEveryByte) {
    const auto before = gpu().ledger;
    {
        Renderer renderer(gpu(), tables());
        Project p = everything();
        traceOf(renderer, p);
        EXPECT_NE(gpu().ledger, before);
    }
    EXPECT_EQ(gpu().ledger, before);
}

TEST(Trace, ExplainNamesTheEntityAndWhatIsAbsent) {
    Renderer renderer(gpu(), tables());
    Project p = lawn();
    const std::string text = renderer.explain(p, false), json = renderer.explain(p, true);
    EXPECT_NE(text.find("because of sun"), std::string::npos) << text;
    EXPECT_NE(text.find("terrain-heights: no Terrain has a height map"), std::string::npos) << text;
    const auto parsed = parseJson(json, "explain");
    ASSERT_TRUE(parsed);
    EXPECT_EQ(parsed->find("features")->array.size() + parsed->find("absent")->array.size(),
              static_cast<size_t>(Feature::Count));
}

TEST(Trace, ExplainSaysHowFarTheTechniqueFollowsWhatMovesGrass) {
    Renderer renderer(gpu(), tables());
    Project p = lawn();
    put<Wind>(p, "wind");
    put<ForceSource>(p, "stone");
    put(p, "stone", Transform{{10, 0, 8}});
    FlatField f = flatField(p, "grass");
    const auto told = [&](Technique t) {
        f.technique = nameOf(t);
        return renderer.explain(p, false);
    };
    const auto holds = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
    f.beyond = Beyond::Nothing;
    const std::string blades = told(Technique::Tessellated), flat = told(Technique::Flat),
                      hybrid = told(Technique::Hybrid);
    EXPECT_TRUE(holds(blades, "note      blades bend and quiver each by itself\n")) << blades;
    EXPECT_TRUE(holds(blades, "note      blades are laid down each its own way\n")) << blades;
    EXPECT_TRUE(holds(flat, "note      the horizontal slice brightens and darkens with the gust\n")) << flat;
    EXPECT_FALSE(holds(flat, "blades bend")) << flat;
    EXPECT_TRUE(holds(
        hybrid,
        "note      blades bend and quiver each by itself, slices lean with the gust, the horizontal slice brightens"))
        << hybrid;
}

TEST(Trace, ExplainHasALineForWhatDarkensFarGrass) {
    Renderer renderer(gpu(), tables());
    Project p = lawn();
    EXPECT_EQ(renderer.explain(p, false).find("\n  grass/far-darkening:"), std::string::npos);
    flatField(p, "grass").farDarkening = 0.3f;
    EXPECT_NE(renderer.explain(p, false).find("\n  grass/far-darkening: far grass is darker"), std::string::npos);
}

}  // namespace
}  // namespace sward::test
