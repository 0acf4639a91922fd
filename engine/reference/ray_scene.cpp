#include "reference/ray_scene.h"

#include <cstring>

#include "reference/embree.h"

namespace sward {

struct RayScene::Device {
    DevicePtr device{rtcNewDevice(nullptr)};
    ScenePtr scene{device ? rtcNewScene(device.get()) : nullptr};
    std::vector<ScenePtr> shown;  // of the meshes that are instanced
    // False without memory.
    bool add(const Triangles& t, uint32_t id) { return addTo(scene.get(), t, id); }
    bool addShown(const Triangles& t) {
        shown.emplace_back(rtcNewScene(device.get()));
        rtcSetSceneFlags(shown.back().get(), RTC_SCENE_FLAG_ROBUST);
        const bool done = t.indices.empty() || addTo(shown.back().get(), t, 0);
        rtcCommitScene(shown.back().get());
        return done;
    }
    void place(const TriangleInstances::Placed& p, uint32_t id) {
        RTCGeometry g = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(g, shown[p.mesh].get());
        const glm::mat4x3 m(p.turn[0], p.turn[1], p.turn[2], p.at);
        rtcSetGeometryTransform(g, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &m);
        rtcCommitGeometry(g);
        rtcAttachGeometryByID(scene.get(), g, id);
        rtcReleaseGeometry(g);
    }
    bool addTo(RTCScene to, const Triangles& t, uint32_t id) {
        RTCGeometry g = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        void* vertices = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                                 t.positions.size());
        void* indices = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t),
                                                t.indices.size() / 3);
        const bool done = vertices && indices;
        if (done) {
            std::memcpy(vertices, t.positions.data(), t.positions.size() * sizeof(glm::vec3));
            std::memcpy(indices, t.indices.data(), t.indices.size() * sizeof(uint32_t));
            rtcCommitGeometry(g);
            rtcAttachGeometryByID(to, g, id);
        }
        rtcReleaseGeometry(g);
        return done;
    }
};

Result<RayScene> RayScene::make(const std::vector<Triangles>& meshes, const TriangleInstances& instances) {
    const Error refusal = failed("rays cannot be prepared: Embree has no memory, or does not know this processor",
                                 "close other programs, or make the objects simpler");
    auto device = std::make_shared<Device>();
    if (!device->scene) return refusal;
    rtcSetSceneFlags(device->scene.get(), RTC_SCENE_FLAG_ROBUST);  // no ray slips through between neighbours
    for (uint32_t i = 0; i < meshes.size(); ++i)
        if (!meshes[i].indices.empty() && !device->add(meshes[i], i)) return refusal;
    for (const Triangles& t : instances.meshes)
        if (!device->addShown(t)) return refusal;
    for (size_t i = 0; i < instances.placed.size(); ++i)
        device->place(instances.placed[i], static_cast<uint32_t>(meshes.size() + i));
    rtcCommitScene(device->scene.get());
    if (rtcGetDeviceError(device->device.get()) != RTC_ERROR_NONE) return refusal;
    return RayScene(std::move(device));
}

bool RayScene::hits(const glm::vec3& origin, const glm::vec3& way, float far) const {
    RayContext context;
    return anyHit(device_->scene.get(), context, embreeRay(origin, way, 0, far));
}

std::optional<TriangleHit> RayScene::closest(const glm::vec3& origin, const glm::vec3& way, float near,
                                             float far) const {
    RayContext context;
    RTCRayHit r{embreeRay(origin, way, near, far), {}};
    closestHit(device_->scene.get(), context, r);
    if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const bool instanced = r.hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
    return TriangleHit{r.ray.tfar, instanced ? r.hit.instID[0] : r.hit.geomID, r.hit.primID, r.hit.u,
                       r.hit.v,    {r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z}};
}

}  // namespace sward
