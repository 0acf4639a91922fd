// How near frames of grass come to what the machine can do. Three scenes of tests/scenes are drawn by Sward and, in
// turn, as bare triangles: the same blades, posed as the truth poses them, as many quads as their length on screen
// asks, from a static buffer that lies in clip space already, in one colour, and nothing else. Once all of them, once
// those whose box on screen meets a sample, once those that meet one themselves. By the wall and by the time of all
// threads. Does not: light, shade or move.
#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "bench/limits.h"
#include "frame/draw_context.h"
#include "frame/renderer.h"
#include "project/project_files.h"
#include "techniques.h"
#include "tests/bare_triangles.h"
#include "tests/gl_counts.h"
#include "tests/grass/comparison.h"
#include "world/view_camera.h"

namespace {
using namespace sward;
using namespace sward::test;

constexpr int kWidth = 640, kHeight = 480, kRounds = 9;
constexpr const char* kShareNames[] = {"all", "whose box meets a sample", "that meet a sample"};

// --- drawing them ----------------------------------------------------------------------------------------------------

GLuint compiled(GLenum stage, const char* source) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    return shader;
}
// A picture of its own, and a buffer for each share.
struct BareDrawing {
    GLuint program = glCreateProgram(), frame = 0, targets[2] = {}, array = 0;
    std::array<GLuint, kShares> buffers{};
    std::array<GLsizei, kShares> corners{};

    explicit BareDrawing(const BareTriangles& t) {
        glAttachShader(program, compiled(GL_VERTEX_SHADER,
                                         "#version 450\nlayout(location = 0) in vec4 at;\n"
                                         "void main() { gl_Position = at; }\n"));
        glAttachShader(program, compiled(GL_FRAGMENT_SHADER,
                                         "#version 450\nout vec4 color;\n"
                                         "void main() { color = vec4(0.1, 0.4, 0.1, 1.0); }\n"));
        glLinkProgram(program);
        glCreateFramebuffers(1, &frame);
        glCreateRenderbuffers(2, targets);
        glNamedRenderbufferStorage(targets[0], GL_RGBA8, kWidth, kHeight);
        glNamedRenderbufferStorage(targets[1], GL_DEPTH_COMPONENT32F, kWidth, kHeight);
        glNamedFramebufferRenderbuffer(frame, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, targets[0]);
        glNamedFramebufferRenderbuffer(frame, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, targets[1]);
        glCreateVertexArrays(1, &array);
        glEnableVertexArrayAttrib(array, 0);
        glVertexArrayAttribFormat(array, 0, 4, GL_FLOAT, GL_FALSE, 0);
        glCreateBuffers(kShares, buffers.data());
        for (size_t s = 0; s < kShares; ++s) {
            corners[s] = static_cast<GLsizei>(3 * t.of[s].size());
            glNamedBufferStorage(buffers[s], static_cast<GLsizeiptr>(t.of[s].size() * sizeof(t.of[s][0])),
                                 t.of[s].data(), 0);
        }
    }
    ~BareDrawing() {
        glDeleteProgram(program);
        glDeleteFramebuffers(1, &frame);
        glDeleteRenderbuffers(2, targets);
        glDeleteVertexArrays(1, &array);
        glDeleteBuffers(kShares, buffers.data());
    }
    BareDrawing(const BareDrawing&) = delete;
    void draw(Share s) const {
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        glViewport(0, 0, kWidth, kHeight);
        glDisable(GL_BLEND), glDisable(GL_CULL_FACE), glEnable(GL_DEPTH_TEST);
        glDepthMask(GL_TRUE), glDepthFunc(GL_GREATER);
        const float clear[4] = {}, far = 0;
        glClearNamedFramebufferfv(frame, GL_COLOR, 0, clear);
        glClearNamedFramebufferfv(frame, GL_DEPTH, 0, &far);
        glUseProgram(program);
        glVertexArrayVertexBuffer(array, 0, buffers[s], 0, sizeof(glm::vec4));
        glBindVertexArray(array);
        glDrawArrays(GL_TRIANGLES, 0, corners[s]);
        glFinish();
    }
    // Of the picture, that any triangle covers.
    double covered() const {
        draw(kExact);
        std::vector<uint8_t> pixels(size_t{4} * kWidth * kHeight);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, frame);
        glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        size_t green = 0;
        for (size_t i = 1; i < pixels.size(); i += 4) green += pixels[i] > 0;
        return static_cast<double>(green) / (kWidth * kHeight);
    }
};

// --- the race --------------------------------------------------------------------------------------------------------

struct Took {
    double wall, threads;  // ms
};
Took timed(const std::function<void()>& work) {
    const std::clock_t before = std::clock();
    const double wall = 1000 * seconds(work);
    return {wall, 1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC};
}
// Median of quotients of pairs, and the interval that holds it 96 times of 100: between the second and the last but one
// of nine.
struct Quotient {
    double middle, low, high;
};
Quotient quotientOf(std::vector<double> all) {
    std::sort(all.begin(), all.end());
    return {median(all), all[1], all[all.size() - 2]};
}

struct Raced {
    std::vector<Took> sward;
    std::array<std::vector<Took>, kShares> bare;
    Quotient against(Share s, double Took::*what) const {
        std::vector<double> all;
        for (size_t i = 0; i < sward.size(); ++i) all.push_back(sward[i].*what / (bare[s][i].*what));
        return quotientOf(all);
    }
};
double middle(const std::vector<Took>& all, double Took::*what) {
    std::vector<double> values;
    for (const Took& t : all) values.push_back(t.*what);
    return median(values);
}

struct YardstickScene {
    Project project;
    ViewCamera camera;
    ViewSettings settings = sized(kWidth, kHeight, 1);
};
std::optional<YardstickScene> sceneNamed(const char* name) {
    const auto folder = std::filesystem::path(SWARD_SOURCE_DIR) / "tests/scenes" / name;
    auto project = loadProject(folder, tables().components);
    if (!project) {
        std::fprintf(stderr, "%s\n", project.error().text().c_str());
        return std::nullopt;
    }
    YardstickScene s{std::move(*project), {}};
    s.camera = viewOf(*findCamera(s.project, "eye"));
    return s;
}

void drawFrame(Renderer& r, const YardstickScene& s, const ViewSettings& settings) {
    if (const Status drawn = r.draw(s.project, s.camera, settings); !drawn)
        std::fprintf(stderr, "%s\n", drawn.error().text().c_str());
}
void printCounts(const char* name, Renderer& r, const YardstickScene& s, const BareTriangles& t, const BareDrawing& d) {
    ViewSettings measured = s.settings;
    measured.measure = true;
    const uint64_t submitted = counted(GL_CLIPPING_INPUT_PRIMITIVES_ARB, [&] { drawFrame(r, s, s.settings); });
    uint64_t fragments = 0;
    drawFrame(r, s, measured);
    for (const PassStats& pass : r.stats().passes)
        if (pass.name.starts_with("grass/")) fragments += pass.fragments;
    const uint64_t bare = counted(GL_FRAGMENT_SHADER_INVOCATIONS_ARB, [&] { d.draw(kExact); });
    std::fprintf(stderr, "%s: %zu blades, %zu in view, over %.0f%% of the picture\n", name, t.blades, t.inView,
                 100 * d.covered());
    std::fprintf(stderr,
                 "  Sward: %llu blades chosen, %llu triangles of all passes submitted, %llu fragments of grass\n",
                 static_cast<unsigned long long>(r.stats().bladesGeometry), static_cast<unsigned long long>(submitted),
                 static_cast<unsigned long long>(fragments));
    std::fprintf(stderr, "  bare triangles: %zu all, %zu whose box meets a sample, %zu that meet one; %llu fragments\n",
                 t.of[kAll].size(), t.of[kBoxes].size(), t.of[kExact].size(), static_cast<unsigned long long>(bare));
}
void printRace(const Raced& r) {
    for (const auto& [what, label] : {std::pair{&Took::wall, "wall"}, std::pair{&Took::threads, "all threads"}}) {
        std::fprintf(stderr, "  %s: Sward %.1f ms\n", label, middle(r.sward, what));
        for (const Share s : {kAll, kBoxes, kExact}) {
            const Quotient q = r.against(s, what);
            std::fprintf(stderr, "    triangles %s: %.1f ms, Sward %.2f times (%.2f to %.2f)\n", kShareNames[s],
                         middle(r.bare[s], what), q.middle, q.low, q.high);
        }
    }
}

// Frames in turn.
Raced race(Renderer& r, const YardstickScene& s, const BareDrawing& d) {
    Raced out;
    const auto frame = [&] {
        drawFrame(r, s, s.settings);
        r.finish();
    };
    frame();  // compiles, bakes
    for (int i = 0; i < kRounds; ++i) {
        out.sward.push_back(timed(frame));
        for (size_t share = 0; share < kShares; ++share)
            out.bare[share].push_back(timed([&] { d.draw(static_cast<Share>(share)); }));
    }
    return out;
}

// limit: of a frame as a share of its bare triangles, all of them, by the wall and by all threads.
void reportYardstick(const char* name, double limit) {
    const std::string wall = std::string(name) + ": a frame as a share of its bare triangles, wall",
                      threads = std::string(name) + ": a frame as a share of its bare triangles, all threads";
    auto scene = gpu() ? sceneNamed(name) : std::nullopt;
    if (!scene) {
        reportLimit(wall.c_str(), NAN, limit, "x");
        return reportLimit(threads.c_str(), NAN, limit, "x");
    }
    Renderer renderer(*gpu(), tables());
    const BareTriangles triangles = bareTriangles(scene->project, scene->camera, {kWidth, kHeight}, 0);
    const BareDrawing drawing(triangles);
    const Raced raced = race(renderer, *scene, drawing);
    printCounts(name, renderer, *scene, triangles, drawing);
    printRace(raced);
    reportLimit(wall.c_str(), raced.against(kAll, &Took::wall).middle, limit, "x");
    reportLimit(threads.c_str(), raced.against(kAll, &Took::threads).middle, limit, "x");
}

// A third of what the quickest other programs known to us take for such work; docs/performance.md has the reckoning.
SWARD_LIMITS("limit-plain", [] { reportYardstick("plain", 0.7); });
SWARD_LIMITS("limit-dense", [] { reportYardstick("dense", 0.77); });
SWARD_LIMITS("limit-lawn", [] { reportYardstick("lawn", 0.16); });

}  // namespace
