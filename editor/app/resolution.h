// How fine the viewport is drawn: in full when at rest; while something moves on a slow renderer, as fine as the time
// allows: first a smaller image, then fewer and wider blades. The full picture of a slow renderer is drawn in pieces,
// row by row from the top down and each row from the left, as many as fit a frame, so that input never waits for it.
// Pure: it is told the time, what changed and what a drawing cost, and says what to draw next. Does not: draw, nor
// count what the rest of a frame costs.
#pragma once
#include <array>
#include <cstddef>

namespace sward {

// Shares of the picture's width and height, from the left and from the top.
struct PicturePiece {
    double left = 0, right = 1;
    double from = 0, to = 1;

    bool whole() const { return left <= 0 && right >= 1 && from <= 0 && to >= 1; }
    bool first() const { return left <= 0 && from <= 0; }
    double area() const { return (right - left) * (to - from); }
};

// What the full picture costs where: a grid of the smallest pieces, each with the milliseconds that a whole picture of
// its cost would take, as last drawn. Below 0: not drawn yet, taken for the mean of the picture.
inline constexpr int kPieceRows = 32, kPieceColumns = 24;
using PieceCosts = std::array<double, static_cast<std::size_t>(kPieceRows) * kPieceColumns>;

struct Resolution {
    double movingScale = 1;   // side of the drawn image over the viewport's, learnt from what drawings cost
    double movingDetail = 1;  // share of the blades drawn then
    double most = 1;          // share that the full picture has: below 1 where all blades would take too long
    double drawnScale =
        0;  // of the image on the screen; 0: none yet; below 1 until the last piece of the full one is there
    bool stale = true;         // what is on the screen is not what would be drawn now
    double lastChange = -1e9;  // seconds
    double fullMs = 0;         // what a full drawing costs, as far as is known; 0: nothing is known
    // The full picture so far: all above `row.from` is there, and of the row what lies left of `row.left`.
    PicturePiece row = {0, 1, 0, 0};
    double pieceArea = 1;  // of the next piece, as a share of the picture
    double piecesMs = 0;   // what its pieces so far have cost
    PieceCosts costs = unknownCosts();

    static PieceCosts unknownCosts() {
        PieceCosts none;
        none.fill(-1);
        return none;
    }
};
struct ResolutionPlan {
    bool draw = false;
    double scale = 1;
    int msaa = 4;
    double detail = 1;
    bool full = true;  // of the full picture, or a piece of it
    PicturePiece piece = {};
    double expectedMs = 0;  // what a piece will cost by what lay there when it was last drawn
};

inline constexpr double kMinScale = 0.25;       // of the side
inline constexpr double kMinDetail = 1.0 / 16;  // of the full picture's blades
inline constexpr double kSlowMs = 50;           // a drawing slower than this is coarsened while something moves
inline constexpr double kTargetMs = 45;  // what a drawing may cost then: 15 frames a second with the rest of a frame
inline constexpr double kPieceMs = 22;   // what a piece should cost: with a frame's panels an answer within 50 ms
inline constexpr double kMinRow = 1.0 / kPieceRows;       // of the height
inline constexpr double kMinWidth = 1.0 / kPieceColumns;  // of the width
inline constexpr double kRestSeconds = 0.25;              // without a change until the image is refined

// `changed`: camera, scene, size or decal differ from what was last drawn.
ResolutionPlan planDrawing(Resolution& r, double now, bool changed);
// What the drawing just made cost.
void learnDrawing(Resolution& r, const ResolutionPlan& plan, double ms);
// Sets the share of the blades that the full picture has, in (0, 1]. Another one: what is shown is stale.
void limitDetail(Resolution& r, double most);
// Seconds until a drawing will be wanted though nothing changes; negative: never.
double secondsToRefine(const Resolution& r, double now);

}  // namespace sward
