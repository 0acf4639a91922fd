#include "tools/box_tree.h"

#include <algorithm>
#include <numeric>

namespace sward {
namespace {

constexpr size_t kLeaf = 4;  // boxes

double middle(const Box& box, int axis) { return box.low[axis] + box.high[axis]; }

}  // namespace

std::optional<double> entry(const Box& box, const glm::dvec3& origin, const glm::dvec3& way, double far) {
    double from = 0, to = far;
    for (int i = 0; i < 3; ++i) {
        if (way[i] == 0) {
            if (origin[i] < box.low[i] || origin[i] > box.high[i]) return std::nullopt;
            continue;
        }
        const double a = (box.low[i] - origin[i]) / way[i], b = (box.high[i] - origin[i]) / way[i];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to ? std::optional(from) : std::nullopt;
}

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes_.empty()) build(0, boxes_.size());
}

uint32_t BoxTree::build(size_t from, size_t to) {
    const uint32_t node = static_cast<uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Box all, centres;
    for (size_t i = from; i < to; ++i) {
        const Box& box = boxes_[order_[i]];
        all.add(box.low), all.add(box.high);
        centres.add(box.low + box.high);
    }
    nodes_[node] = {all, static_cast<uint32_t>(from), static_cast<uint32_t>(to - from)};
    if (to - from <= kLeaf) return node;
    const glm::dvec3 size = centres.high - centres.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto at = [&](size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    const size_t half = (from + to) / 2;
    std::nth_element(at(from), at(half), at(to),
                     [&](uint32_t a, uint32_t b) { return middle(boxes_[a], axis) < middle(boxes_[b], axis); });
    build(from, half);
    const uint32_t second = build(half, to);
    nodes_[node].first = second, nodes_[node].count = 0;
    return node;
}

size_t BoxTree::cast(const glm::dvec3& origin, const glm::dvec3& way, double far,
                     const std::function<double(size_t, double)>& meet) const {
    if (nodes_.empty()) return 0;
    size_t looked = 1;
    std::vector<std::pair<uint32_t, double>> open;  // nodes to look into, and where the ray enters them
    if (const auto t = entry(nodes_[0].box, origin, way, far)) open.emplace_back(0, *t);
    while (!open.empty()) {
        const auto [index, enters] = open.back();
        open.pop_back();
        if (enters > far) continue;
        const Node& node = nodes_[index];
        for (size_t i = 0; i < node.count; ++i, ++looked) {
            const uint32_t box = order_[node.first + i];
            if (entry(boxes_[box], origin, way, far)) far = meet(box, far);
        }
        if (node.count > 0) continue;
        const uint32_t children[] = {index + 1, node.first};
        std::optional<double> at[2];
        for (int c = 0; c < 2; ++c, ++looked) at[c] = entry(nodes_[children[c]].box, origin, way, far);
        const int near = at[0] && (!at[1] || *at[0] <= *at[1]) ? 0 : 1;  // the near one is looked into first
        for (const int c : {1 - near, near})
            if (at[c]) open.emplace_back(children[c], *at[c]);
    }
    return looked;
}

}  // namespace sward
