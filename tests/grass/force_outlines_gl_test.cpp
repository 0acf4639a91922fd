// The map of forces around the eye and the list that the reference reads say the same of outlines.
#include <epoxy/gl.h>

#include "core/numerics.h"
#include "objects.h"
#include "shared/bindings.h"
#include "shared/wind.h"
#include "techniques.h"
#include "world/forces.h"

namespace sward::test {
namespace {

struct ForceTexture {
    ForceGlobals at;
    std::vector<float> texels;
    int side = 0;
};
// As it is bound after a frame.
ForceTexture readForces() {
    ForceTexture t;
    GLint texture = 0, buffer = 0;
    glActiveTexture(GL_TEXTURE0 + TEX_FORCE);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
    glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, UBO_FORCE, &buffer);
    glGetNamedBufferSubData(static_cast<GLuint>(buffer), 0, sizeof(t.at), &t.at);
    glGetTextureLevelParameteriv(static_cast<GLuint>(texture), 0, GL_TEXTURE_WIDTH, &t.side);
    t.texels.resize(static_cast<size_t>(t.side) * static_cast<size_t>(t.side) * 4);
    glGetTextureImage(static_cast<GLuint>(texture), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(t.texels.size() * sizeof(float)), t.texels.data());
    return t;
}

Project blockOnLawn(const std::filesystem::path& dir) {
    Project p = lawn();
    p.dir = dir;
    putObject(p, "block", {{.size = {3, 0.5f, 1}, .at = {1.5f, 0, 0.5f}}, {.size = {1, 0.5f, 2}, .at = {0.5f, 0, 1}}},
              {8, 0, 9});
    p.registry.get<StaticMesh>(findEntity(p, "block"))->rotationDeg.y = 33;
    ForceSource source;
    source.radius = 0.6f;
    put(p, "stone", source);
    source.shape = ForceShape::Outline, source.reach = 2.5f;
    put(p, "block", source);
    put<Transform>(p, "stone", {{11, 0, 8}});
    return p;
}

TEST(ForceOutlinesGl, TheMapAroundTheEyeAndTheListOfTheReferenceAgree) {
    NoGlErrors errors;
    TempDir dir;
    Project p = blockOnLawn(dir.path);
    Renderer renderer(gpu(), tables());
    ASSERT_TRUE(renderer.draw(p, eyeHeight(), small()));
    const ForceTexture map = readForces();
    const std::vector<Force> forces = forcesOf(p, 0);
    ASSERT_EQ(forces.size(), 2u);
    const glm::dvec2 eye(eyeHeight().eye.x, eyeHeight().eye.z);
    double worst = 0, sum = 0;
    int pressed = 0, pushed = 0;
    for (int y = 0; y < map.side; ++y)
        for (int x = 0; x < map.side; ++x) {
            const double texel = 1.0 / (static_cast<double>(map.at.share) * map.side);
            const glm::dvec2 place = eye + glm::dvec2(map.at.corner) + texel * (glm::dvec2(x, y) + 0.5);
            const float* t =
                &map.texels[(static_cast<size_t>(y) * static_cast<size_t>(map.side) + static_cast<size_t>(x)) * 4];
            const glm::vec3 drawn = f32::forceOf({t[0], t[1], t[3]}), listed = forceAt(forces, place);
            const double off = static_cast<double>(glm::length(drawn - listed));
            worst = std::max(worst, off), sum += off;
            pressed += listed.z > 0.99f, pushed += listed.z == 0 && glm::length(listed) > 0.1f;
        }
    EXPECT_GT(pressed, 500);
    EXPECT_GT(pushed, 500);
    EXPECT_LT(worst, 0.06) << "texels are drawn at their middles: only half floats and the card's filtering differ";
    EXPECT_LT(sum / (map.side * map.side), 5e-4);
}

TEST(ForceOutlinesGl, GrassUnderTheObjectLiesAndInTheNotchStands) {
    NoGlErrors errors;
    TempDir dir;
    Project p = blockOnLawn(dir.path);
    Renderer renderer(gpu(), tables());
    ASSERT_TRUE(renderer.draw(p, above(), small()));
    const std::vector<uint8_t> with = renderer.readImage();
    EXPECT_NE(renderer.explain(p, true).find("grass/force-outlines"), std::string::npos);
    p.registry.get<ForceSource>(findEntity(p, "block"))->shape = ForceShape::Object;
    ASSERT_TRUE(renderer.draw(p, above(), small()));
    EXPECT_NE(renderer.readImage(), with);
    const std::vector<std::string> names = renderer.programNames();
    EXPECT_EQ(std::count(names.begin(), names.end(), "grass/force-outlines"), 0) << "no outline, no program";
}

}  // namespace
}  // namespace sward::test
