#include "app/resolution.h"

#include <algorithm>
#include <cmath>

namespace sward {
namespace {

// Steps of a sixteenth, so that the renderer's targets are not made anew for every frame.
double quantized(double scale) { return std::clamp(std::floor(scale * 16 + 0.5) / 16, kMinScale, 1.0); }

constexpr double kMinArea = kMinRow * kMinWidth;

// The row that begins at `top`, of a height for pieces of this area.
PicturePiece rowAt(double top, double area) {
    PicturePiece row{0, 1, top, top + std::max(area, kMinRow)};
    if (1 - row.to < kMinRow) row.to = 1;  // no sliver remains
    return row;
}

// Calls each(cost, area) for the places of the grid that a piece meets, with the part of it that lies there.
template <class Each>
void eachPlace(PieceCosts& costs, const PicturePiece& piece, const Each& each) {
    const auto overlap = [](double a0, double a1, int i, int of) {
        return std::min(a1, (i + 1.0) / of) - std::max(a0, static_cast<double>(i) / of);
    };
    for (int row = 0; row < kPieceRows; ++row)
        for (int column = 0; column < kPieceColumns; ++column) {
            const double high = overlap(piece.from, piece.to, row, kPieceRows);
            const double wide = overlap(piece.left, piece.right, column, kPieceColumns);
            if (high > 1e-9 && wide > 1e-9) each(costs[static_cast<size_t>(row * kPieceColumns + column)], high * wide);
        }
}

// What a piece will cost by what lay there when it was last drawn.
double expectedMs(Resolution& r, const PicturePiece& piece) {
    double ms = 0;
    eachPlace(r.costs, piece, [&](double cost, double area) { ms += area * (cost < 0 ? r.fullMs : cost); });
    return ms;
}

void nextPiece(Resolution& r, ResolutionPlan& plan) {
    if (r.stale || r.row.to <= 0) {
        r.pieceArea = r.fullMs <= kSlowMs ? 1 : std::clamp(kPieceMs / r.fullMs, kMinArea, 1.0);
        r.piecesMs = 0;
        r.row = rowAt(0, r.pieceArea);
    }
    plan.draw = true;
    plan.detail = r.most;
    plan.piece = r.row;
    // Whole columns of the grid, as many as may cost so little.
    const long left = std::lround(plan.piece.left * kPieceColumns);
    long columns = std::max(1L, std::lround(r.pieceArea / (r.row.to - r.row.from) * kPieceColumns));
    const auto reach = [&] { plan.piece.right = std::min(1.0, static_cast<double>(left + columns) / kPieceColumns); };
    for (reach(); columns > 1 && r.fullMs > kSlowMs && expectedMs(r, plan.piece) > kPieceMs; reach()) --columns;
    plan.expectedMs = expectedMs(r, plan.piece);
}

// A piece says little of the next one: the sky costs nothing, the grass below it much. So that pieces grow slowly, and
// never to more than four of them would cost if the picture's cost were even.
void learnPiece(Resolution& r, const PicturePiece& piece, double ms) {
    const double even = r.fullMs > kSlowMs ? 4 * kPieceMs / r.fullMs : 1;
    eachPlace(r.costs, piece, [&](double& cost, double) { cost = ms / piece.area(); });
    const double area = piece.area() * std::clamp(kPieceMs / std::max(ms, 0.1), 0.3, 1.5);
    r.pieceArea = std::clamp(area, kMinArea, std::max(kMinArea, std::min(1.0, even)));
    r.piecesMs = piece.first() ? ms : r.piecesMs + ms;
    r.row = {piece.right, 1, piece.from, piece.to};
    if (r.row.left >= 1 && r.row.to < 1) r.row = rowAt(r.row.to, r.pieceArea);
}

// Detail gives way when the smallest image is still too slow, and comes back first.
void learnMoving(Resolution& r, const ResolutionPlan& plan, double ms) {
    r.row.to = 0;
    r.drawnScale = plan.scale * 0.999;  // a whole image with fewer blades is not the full one yet
    if (r.fullMs <= 0) r.fullMs = ms / (plan.scale * plan.scale);
    const double ratio = kTargetMs / std::max(ms, 0.1);
    const bool slow = ms > kSlowMs, quick = ms < 0.6 * kTargetMs;
    if ((slow && plan.scale <= kMinScale) || (quick && plan.detail < r.most))
        r.movingDetail = std::clamp(plan.detail * std::clamp(ratio, 0.4, 1.5), kMinDetail * r.most, r.most);
    else if (slow || quick)
        r.movingScale = std::clamp(plan.scale * std::sqrt(ratio), std::max(kMinScale, plan.scale * 0.5),
                                   std::min(1.0, plan.scale * 1.25));
}

void learnFull(Resolution& r, double ms) {
    r.fullMs = ms;
    r.drawnScale = 1;
    if (ms <= kSlowMs)
        r.movingScale = 1, r.movingDetail = r.most;
    else if (r.movingScale >= 1)
        r.movingScale = std::clamp(std::sqrt(kTargetMs / ms), kMinScale, 1.0);
}

}  // namespace

ResolutionPlan planDrawing(Resolution& r, double now, bool changed) {
    if (changed) {
        r.lastChange = now;
        r.stale = true;
    }
    const bool moving = now - r.lastChange < kRestSeconds;
    ResolutionPlan plan;
    if (r.stale && moving) {
        plan.draw = true;
        plan.scale = quantized(r.movingScale);
        plan.detail = std::min(r.movingDetail, r.most);
        plan.full = plan.scale >= 1 && plan.detail >= r.most;
    } else if (r.stale || (!moving && r.drawnScale < 1)) {
        nextPiece(r, plan);
    }
    plan.msaa = plan.scale < 1 ? 1 : 4;
    return plan;
}

void learnDrawing(Resolution& r, const ResolutionPlan& plan, double ms) {
    r.stale = false;
    if (!plan.full) return learnMoving(r, plan, ms);
    learnPiece(r, plan.piece, ms);
    if (r.row.left < 1) {
        r.drawnScale = std::min(r.drawnScale, 0.999);
        return;
    }
    r.row.to = 0;
    learnFull(r, r.piecesMs);
}

void limitDetail(Resolution& r, double most) {
    if (r.most == most) return;
    r.movingDetail = std::min(r.movingDetail, most);
    r.most = most;
    r.stale = true;
    r.fullMs = 0;
    r.costs = Resolution::unknownCosts();
}

double secondsToRefine(const Resolution& r, double now) {
    if (r.stale) return 0;
    if (r.drawnScale >= 1) return -1;
    return std::max(0.0, r.lastChange + kRestSeconds - now);
}

}  // namespace sward
