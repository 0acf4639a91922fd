// What must hold of opacity correction, tilted slices, rays through slices and compositing between their hard points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/numerics.h"

namespace sward {
namespace {

using namespace f32;

struct Random {
    std::mt19937 bits{2004};
    float in(float a, float b) { return a + (b - a) * hashUnit(bits()); }
    vec3 direction() {
        for (;;) {
            const vec3 v(in(-1, 1), in(-1, 1), in(-1, 1));
            if (glm::dot(v, v) > 0.01f && glm::dot(v, v) < 1) return glm::normalize(v);
        }
    }
};

TEST(OpacityCorrection, IsMonotoneInOpacityAndPath) {
    for (int i = 0; i <= 200; ++i) {
        const float a = float(i) / 200;
        float before = 0;
        for (int j = 0; j <= 320; ++j) {
            const float k = float(j) / 20, now = opacityCorrected(a, k);
            EXPECT_GE(now, before - 1e-7f);
            EXPECT_GE(opacityCorrected(std::min(a + 0.005f, 1.0f), k), now - 1e-7f);
            EXPECT_TRUE(now >= 0 && now <= 1);
            before = now;
        }
        EXPECT_NEAR(opacityCorrected(a, 1), a, 4e-7f);
    }
}

TEST(OpacityCorrection, TwiceIsOnceWithTheProduct) {
    Random r;
    for (int i = 0; i < 20000; ++i) {
        const float a = r.in(0, 1), k1 = r.in(1, 16), k2 = r.in(1, 16);
        EXPECT_NEAR(opacityCorrected(opacityCorrected(a, k1), k2), opacityCorrected(a, k1 * k2), 1e-6f);
    }
}

TEST(OpacityCorrection, HasItsStatedLimits) {
    EXPECT_EQ(opacityCorrected(0, 1e6f), 0.0f);
    EXPECT_EQ(opacityCorrected(1, 1e-6f), 1.0f);
    EXPECT_EQ(opacityCorrected(1, 0), 0.0f);
    EXPECT_FLOAT_EQ(opacityCorrected(0.5f, 2), 0.75f);
    EXPECT_FLOAT_EQ(opacityCorrected(0.25f, 4), 0.68359375f);
    EXPECT_NEAR(opacityCorrected(1e-8f, 1e6f), 0.0099501648f, 1e-8f);
}

TEST(OpacityCorrection, KeepsTheHueOfPremultipliedColour) {
    Random r;
    for (int i = 0; i < 5000; ++i) {
        const float alpha = r.in(0.001f, 1), k = r.in(0, 16);
        const vec4 c(alpha * r.in(0, 1), alpha * r.in(0, 1), alpha * r.in(0, 1), alpha), d = colorCorrected(c, k);
        for (int n = 0; n < 3; ++n) {
            EXPECT_LE(d[n], d.w);
            EXPECT_NEAR(d[n] * alpha, c[n] * d.w, 1e-6f);
        }
    }
}

TEST(Tilt, IsFiniteAndLimitedForEveryDirection) {
    Random r;
    const vec3 p[3] = {{0, 0, 0}, {1, 0.1f, 0.2f}, {0.2f, 1, -0.1f}};
    for (int i = 0; i < 20000; ++i) {
        vec3 v = r.direction();
        if (i % 4 == 0) v.z = 0;
        if (i % 9 == 0) v = {0, 0, i % 2 ? 1.0f : -1.0f};
        const Tilt t = tiltOf(p[0], p[1], p[2], v, 2, 1, 64);
        for (int k = 0; k < 3; ++k) {
            ASSERT_LE(t.offset[k], 0.0f);
            ASSERT_GE(t.offset[k], -2.00001f);
        }
        ASSERT_TRUE(t.rise >= 0 && t.rise <= 2.00001f);
        ASSERT_GE(sliceCount(t.count, 100), 2);
        ASSERT_LE(sliceCount(t.count, 100), 100);
        // Slices along the true slice normal are never wider apart than a voxel, nor many more than that needs.
        ASSERT_GE(t.count, 1 + 64 / std::sqrt(1 + 25.0f));
    }
}

TEST(Tilt, CountIsContinuousWhereTheSlantLimitStarts) {
    const vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    float before = -1;
    for (int k = 1; k < 9000; ++k) {
        const float up = float(k) * 1e-4f * 1.57f;
        const float count = tiltOf(a, b, c, {std::cos(up), 0, -std::sin(up)}, 2, 1, 64).count;
        if (before > 0) {
            EXPECT_LT(std::abs(count - before), 0.05f) << k;
        }
        before = count;
    }
}

TEST(Ground, CliffsPointsAndLinesAreNotForested) {
    EXPECT_TRUE(groundUsable({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    EXPECT_TRUE(groundUsable({90000, 0, 0}, {90001, 0, 3}, {90000, 1, 0}));
    EXPECT_FALSE(groundUsable({0, 0, 0}, {1, 0, 0}, {0, 0.01f, 1}));
    EXPECT_FALSE(groundUsable({0, 0, 0}, {1, 1, 1}, {2, 2, 2}));
}

struct Hit {
    int family, k;
    double t;
};

// All slices within reach, sorted by t, then u before v; the ground ends the list.
std::vector<Hit> bruteForce(const vec3& e, const vec3& d, int n, double h) {
    std::vector<Hit> hits;
    const double end = d.z < 0 ? (h + double(e.z)) / -double(d.z) : 1e18;
    for (int axis = 0; axis < 2; ++axis)
        for (int k = -200; k <= 200; ++k) {
            const double v = double(d[axis]);
            if (v == 0) continue;
            const double t = (double(k) / n - double(e[axis])) / v;
            if (t >= 0 && t <= end) hits.push_back({axis, k, t});
        }
    std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.t < b.t; });
    if (d.z < 0) hits.push_back({kRayGround, 0, end});
    if (hits.size() > 12) hits.resize(12);
    return hits;
}

TEST(SliceRays, HitsAreThoseOfBruteForceInOrder) {
    Random r;
    int compared = 0;
    for (int i = 0; i < 4000; ++i) {
        vec3 e(r.in(-1, 1), r.in(-1, 1), i % 2 ? 0.0f : -0.125f), d = r.direction();
        d.z = -std::abs(d.z);
        if (i % 10 == 0) e.x = float(int(e.x * 16)) / 16;
        if (i % 15 == 0) d.y = 0;
        SliceRay ray = sliceRay(e, d, 16, 16, 0.25f);
        float before = 0;
        for (const Hit& want : bruteForce(e, d, 16, 0.25)) {
            const SliceHit hit = sliceHit(ray);
            ASSERT_GE(hit.t, before);
            ASSERT_NEAR(double(hit.t), want.t, 1e-5 + 4e-6 * want.t) << i;
            if (hit.family == want.family && hit.k == want.k) ++compared;
            before = hit.t;
            ray = sliceAfter(ray, hit);
        }
    }
    EXPECT_GT(compared, 4000);
}

TEST(SliceRays, RisingRaysFromTheTopAndRaysWithoutDirectionHitNothing) {
    EXPECT_EQ(sliceHit(sliceRay({0.3f, 0.1f, 0}, {1, 0, 0.5f}, 16, 16, 0.25f)).family, kRayNone);
    EXPECT_EQ(sliceHit(sliceRay({0.25f, 0.1f, 0}, {1, 0, 0.5f}, 16, 16, 0.25f)).family, kRayNone);
    EXPECT_EQ(sliceHit(sliceRay({0.3f, 0.1f, 0}, {0, 0, 0}, 16, 16, 0.25f)).family, kRayNone);
    EXPECT_EQ(sliceHit(sliceRay({0.3f, 0.1f, -0.2f}, {1, 0, 0.5f}, 16, 16, 0.25f)).family,
              kRayU);  // an eye in the grass
}

TEST(SliceRays, TangentFramesAreOrthonormalForEveryNormal) {
    Random r;
    for (int i = 0; i < 20000; ++i) {
        vec3 n = r.direction();
        if (i % 2) n = glm::normalize(vec3(n.x * 1e-4f, n.y * 1e-4f, i % 4 == 1 ? -1 : 1));
        const TangentFrame f = tangentFrame(n);
        ASSERT_NEAR(glm::length(f.tangent), 1, 1e-6f);
        ASSERT_NEAR(glm::length(f.bitangent), 1, 1e-6f);
        ASSERT_NEAR(glm::dot(f.tangent, f.bitangent), 0, 1e-6f);
        ASSERT_NEAR(glm::dot(glm::cross(f.tangent, f.bitangent), n), 1, 2e-6f);
    }
}

TEST(Compositing, TransmittanceFallsAndColourNeverExceedsOpacity) {
    Random r;
    for (int i = 0; i < 2000; ++i) {
        Layers l;
        l.color = vec3(0);
        l.transmittance = 1;
        for (int k = 0; k < 32; ++k) {
            const float before = l.transmittance;
            l = layersUnder(l, vec3(r.in(-1, 2), r.in(0, 2), r.in(0, 1)), r.in(-0.2f, 1.3f));
            ASSERT_TRUE(l.transmittance >= 0 && l.transmittance <= before);
            ASSERT_LE(std::max({l.color.x, l.color.y, l.color.z}), 1 - l.transmittance + 2e-6f);
        }
    }
}

TEST(Brush, ZeroLengthAndZeroRadiusAreDefined) {
    EXPECT_FLOAT_EQ(segmentDistance({3, 4}, {0, 0}, {0, 0}), 5);
    EXPECT_EQ(brushWeight(0, 0, 0.5f), 0.0f);
    EXPECT_EQ(brushWeight(0.99f, 1, 0), 1.0f);
    EXPECT_FLOAT_EQ(brushWeight(0.5f, 1, 1), 0.5f);
}

// A closed box of leaves in light of 1 from everywhere would hold 1 + s + s^2 + ...: what a leaf meets is that less 1.
TEST(LightFromLeaves, IsTheSumOfAllOrdersOfScattering) {
    const vec3 white(1, 1, 1), none(0, 0, 0), scatter(0.2f, 0.5f, 0.9f);
    for (const float open : {0.0f, 0.3f, 0.8f, 1.0f}) {
        const vec3 light = lightFromLeaves(scatter, none, white, white, open);
        for (int c = 0; c < 3; ++c) {
            double sum = 0, order = 1;
            for (int k = 0; k < 400; ++k) sum += order *= double(1 - open) * double(scatter[c]);
            EXPECT_NEAR(light[c], sum, 1e-5 * (1 + sum)) << open;
        }
    }
    EXPECT_EQ(lightFromLeaves(scatter, white, white, white, 1), none);
    EXPECT_EQ(lightFromLeaves(none, white, white, white, 0), none);
    // Leaves in all directions meet half as much of a sun as what faces it on either side, and half of each half.
    const vec3 sun = lightFromLeaves(scatter, white, none, none, 0.5f),
               sky = lightFromLeaves(scatter, none, white, none, 0.5f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(2 * sun[c], sky[c], 1e-6f);
}

}  // namespace
}  // namespace sward
