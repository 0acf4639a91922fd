// Rows of what terrain, time and input need: long running times, strokes without length, lights without limit.
// clang-format off: bodies are laid out as the shader lines that they become
#include "formulas/formula_table.h"

namespace sward {

void addSceneRows(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "T-3", .name = "phase after an hour and more of ticks of 1/60 s", .inputs = 2, .outputs = 1,
        .ours = BODY(y[0] = tickPhase(uint(x[0]), uint(x[1]));),
        .published = BODY(real t = 0.0f; real dt = 1.0f / 60.0f;
                          for (int i = 0; i < int(x[0]); i++) { t += dt; } y[0] = wrapUnit(t / (x[1] * dt));),
        .samples = listed({{60, 120}, {36000, 120}, {216000, 600}, {1000003, 600}}, {{0.5}, {0}, {0}, {403.0 / 600.0}}),
        .tolerance = 2e-7, .low = 0, .high = 0.99999994039535522, .error = circleError
    });
    rows.push_back({
        .id = "T-7", .name = "distance from a stroke, of no length too", .inputs = 6, .outputs = 1,
        .ours = BODY(y[0] = segmentDistance(vec2(x[0], x[1]), vec2(x[2], x[3]), vec2(x[4], x[5]));),
        .published = BODY(y[0] = segmentDistancePublished(vec2(x[0], x[1]), vec2(x[2], x[3]), vec2(x[4], x[5]));),
        .samples = listed({{3, 4, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}, {5, 2, 0, 0, 10, 0}, {-3, 4, 0, 0, 10, 0}},
                          {{5}, {0}, {2}, {5}}),
        .tolerance = 1e-6, .low = 0, .high = 1e6
    });
    rows.push_back({
        .id = "T-7", .name = "weight of a brush, of no radius too", .inputs = 3, .outputs = 1,
        .ours = BODY(y[0] = brushWeight(x[0], x[1], x[2]);),
        .published = BODY(y[0] = clamp((1.0f - x[0] / x[1]) / x[2], real(0.0), real(1.0));),
        .samples = listed({{0, 0, 0.5}, {1, 0, 0.5}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}, {1.5, 2, 0.5}, {1, 2, 1}},
                          {{0}, {0}, {1}, {1}, {0}, {0.5}, {0.5}}),
        .tolerance = 1e-6, .low = 0, .high = 1
    });
    rows.push_back({
        .id = "T-8", .name = "infinite and negative light on an unlit face", .inputs = 4, .outputs = 3,
        .ours = BODY(vec3 c = soundLight(vec3(x[0], x[1], x[2])) * x[3]; y[0] = c.x; y[1] = c.y; y[2] = c.z;),
        .published = BODY(vec3 c = vec3(x[0], x[1], x[2]) * x[3]; y[0] = c.x; y[1] = c.y; y[2] = c.z;),
        .samples =
            listed({{kInfinity, 1, 1, 0}, {-5, 1, 1, 0.5}, {1e30, 2, 3, 1}}, {{0, 0, 0}, {0, 0.5, 0.5}, {65504, 2, 3}}),
        .tolerance = 1e-6, .low = 0, .high = 65504
    });
}

}  // namespace sward
