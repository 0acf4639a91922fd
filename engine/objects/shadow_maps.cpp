#include "objects/shadow_maps.h"

namespace sward {

ShadowMaps makeShadowMaps(Gpu& gpu, const char* owner, int side, int layers) {
    ShadowMaps maps;
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
    maps.texture = GlName<TextureKind>(id);
    glTextureStorage3D(id, 1, GL_DEPTH_COMPONENT32F, side, side, layers);
    throwWithoutMemory();
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(id, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    glObjectLabel(GL_TEXTURE, id, -1, owner);
    const size_t texels = static_cast<size_t>(side) * static_cast<size_t>(side) * static_cast<size_t>(layers);
    maps.tally = Tally(gpu, owner, 4 * texels);
    maps.side = side;
    const float farthest = 0;
    for (int i = 0; i < layers; ++i) {
        GLuint target = 0;
        glCreateFramebuffers(1, &target);
        glNamedFramebufferTextureLayer(target, GL_DEPTH_ATTACHMENT, id, 0, i);
        glNamedFramebufferDrawBuffer(target, GL_NONE);
        glObjectLabel(GL_FRAMEBUFFER, target, -1, owner);
        maps.targets.emplace_back(target);
        glClearNamedFramebufferfv(target, GL_DEPTH, 0, &farthest);
    }
    return maps;
}

LightAxes axesAcross(const glm::vec3& towards, const glm::dvec3& origin) {
    LightAxes axes{towards, {}, {}, origin};
    const glm::vec3 aside = std::abs(towards.y) > 0.99f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
    axes.right = glm::normalize(glm::cross(aside, towards));
    axes.up = glm::cross(towards, axes.right);
    return axes;
}

glm::mat4 mapAround(const LightAxes& axes, const glm::dvec3& centre, const glm::dvec3& eye, double half, int side) {
    const double texel = 2 * half / side;
    const auto middle = [&](const glm::dvec3& axis) {
        return std::round(glm::dot(centre - axes.origin, axis) / texel) * texel - glm::dot(eye - axes.origin, axis);
    };
    const double scale = 0.5 / half;
    glm::mat4 m(0);
    for (int c = 0; c < 3; ++c)
        m[c] = glm::vec4(axes.right[c], axes.up[c], axes.towards[c], 0) * static_cast<float>(scale);
    m[3] = glm::vec4(glm::dvec4(0.5 - middle(axes.right) * scale, 0.5 - middle(axes.up) * scale,
                                0.5 - glm::dot(centre - eye, glm::dvec3(axes.towards)) * scale, 1));
    return m;
}

bool shadesWithin(const LightAxes& axes, const ShadowCaster& c, float reach) {
    const glm::vec2 across(glm::dot(c.centre, axes.right), glm::dot(c.centre, axes.up));
    return glm::length(across) < reach * 1.5f + c.radius && glm::dot(c.centre, axes.towards) > -reach * 1.5f - c.radius;
}

void beginShadowMap(const ShadowMaps& maps, int layer) {
    const float farthest = 0;
    const GLuint target = maps.targets[static_cast<size_t>(layer)].id();
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glClearNamedFramebufferfv(target, GL_DEPTH, 0, &farthest);
}

namespace {

// Leaves out what faces the light; or, off, goes back to what the view draws.
void cullFacing(const DrawContext& ctx, bool on, bool inMirror) {
    if (on) glEnable(GL_CULL_FACE), glCullFace(GL_FRONT), glFrontFace(inMirror ? GL_CW : GL_CCW);
    if (!on) glDisable(GL_CULL_FACE), glCullFace(GL_BACK), glFrontFace(ctx.globals.mirrored != 0 ? GL_CW : GL_CCW);
}

}  // namespace

void drawCaster(DrawContext& ctx, const ShadowCaster& c, bool inMirror) {
    glUniform1f(0, c.image ? c.cutoff : 0.0f);
    if (c.image) glBindTextureUnit(TEX_OBJECT, c.image);
    if (c.behind) cullFacing(ctx, true, inMirror);
    glBindVertexArray(c.vertexArray);
    glDrawElementsInstancedBaseInstance(GL_TRIANGLES, static_cast<GLsizei>(c.indices), GL_UNSIGNED_INT,
                                        reinterpret_cast<const void*>(size_t(c.firstIndex) * 4), c.instances,
                                        c.instance);
    if (c.behind) cullFacing(ctx, false, inMirror);
    ctx.pass->draws += 1;
    ctx.pass->instances += static_cast<uint64_t>(c.instances);
}

}  // namespace sward
