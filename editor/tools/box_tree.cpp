#include "tools/box_tree.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace sward {
namespace {

constexpr size_t kLeaf = 4;  // boxes

// --- the order of boxes ------------------------------------------------------------------------------------------

constexpr uint32_t kSteps = 1024;  // along the longest side of where they are: 10 bits an axis

// The ten bits of a number, each followed by two zeros.
uint32_t spread(uint32_t v) {
    v = (v | v << 16) & 0x030000FFu;
    v = (v | v << 8) & 0x0300F00Fu;
    v = (v | v << 4) & 0x030C30C3u;
    return (v | v << 2) & 0x09249249u;
}

// Along the curve through all places, so that what lies near in it lies near in space.
std::vector<uint32_t> codesOf(const std::vector<Box>& boxes) {
    Box centres;
    for (const Box& box : boxes) centres.add(box.low + box.high);
    const glm::dvec3 size = centres.high - centres.low;
    const double longest = std::max({size.x, size.y, size.z}), by = longest > 0 ? (kSteps - 1) / longest : 0;
    std::vector<uint32_t> codes(boxes.size());
    for (size_t i = 0; i < boxes.size(); ++i) {
        const glm::dvec3 at = (boxes[i].low + boxes[i].high - centres.low) * by;
        codes[i] = spread(static_cast<uint32_t>(at.x)) | spread(static_cast<uint32_t>(at.y)) << 1 |
                   spread(static_cast<uint32_t>(at.z)) << 2;
    }
    return codes;
}

// Boxes by their codes; equal ones stay in their order. Three rounds over ten bits.
std::vector<uint32_t> inOrder(const std::vector<uint32_t>& codes) {
    std::vector<uint32_t> order(codes.size()), next(codes.size());
    std::iota(order.begin(), order.end(), 0u);
    for (const uint32_t shift : {0u, 10u, 20u}) {
        std::array<uint32_t, kSteps + 1> begin{};
        for (const uint32_t code : codes) ++begin[(code >> shift) % kSteps + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        for (const uint32_t i : order) next[begin[(codes[i] >> shift) % kSteps]++] = i;
        std::swap(order, next);
    }
    return order;
}

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

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)) { make(); }

void BoxTree::make() {
    nodes_.clear();
    moved_ = 0;
    if (boxes_.empty()) return;
    order_ = inOrder(codesOf(boxes_));
    nodes_.reserve(boxes_.size());
    build(0, boxes_.size());
}

Box BoxTree::around(const Node& leaf) const {
    Box all;
    for (size_t i = leaf.first; i < leaf.first + leaf.count; ++i) all.add(boxes_[order_[i]]);
    return all;
}

void BoxTree::follow(const std::vector<std::pair<uint32_t, Box>>& moved) {
    if (moved.empty()) return;
    for (const auto& [i, box] : moved) boxes_[i] = box;
    moved_ += moved.size();
    if (8 * moved_ > boxes_.size()) return make();
    for (size_t n = nodes_.size(); n-- > 0;) {  // children come after their node
        Node& node = nodes_[n];
        if (node.count > 0) {
            node.box = around(node);
            continue;
        }
        node.box = nodes_[n + 1].box;
        node.box.add(nodes_[node.first].box);
    }
}

uint32_t BoxTree::build(size_t from, size_t to) {
    const uint32_t node = static_cast<uint32_t>(nodes_.size());
    nodes_.emplace_back();
    if (to - from <= kLeaf) {
        Node leaf{{}, static_cast<uint32_t>(from), static_cast<uint32_t>(to - from)};
        leaf.box = around(leaf);
        nodes_[node] = leaf;
        return node;
    }
    const size_t half = (from + to) / 2;
    build(from, half);
    const uint32_t second = build(half, to);
    Box all = nodes_[node + 1].box;
    all.add(nodes_[second].box);
    nodes_[node] = {all, second, 0};
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
