// A drawing of lines, circles and text that is written as SVG or drawn into pixels: one description, two outputs that
// look alike. Does not: know what it shows (cost_plot.h).
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace sward {

struct PlotLine {
    std::vector<glm::dvec2> points;
    std::string color;  // "#rrggbb"
    double width = 1;
    double dash = 0;  // length of dashes and gaps; 0: none
};
struct PlotDot {
    glm::dvec2 at{0};
    double radius = 3;
    std::string color;
    bool filled = true;
    std::string title;  // shown by browsers under the pointer
};
enum class PlotAnchor { Start, Middle, End };
struct PlotText {
    glm::dvec2 at{0};  // of the baseline
    std::string text, color;
    double size = 12;
    PlotAnchor anchor = PlotAnchor::Start;
    bool upright = false;  // reads from below
};
struct PlotBar {
    glm::dvec2 low{0}, high{0};  // corners: upper left, lower right
    std::string color;
};
// Pixels, from the top left. Drawn in the order bars, lines, dots, texts.
struct Plot {
    int width = 0, height = 0;
    std::string background = "#ffffff";
    std::vector<PlotBar> bars;
    std::vector<PlotLine> lines;
    std::vector<PlotDot> dots;
    std::vector<PlotText> texts;
};
// Where the axes of a graph lie in a plot.
struct PlotBox {
    double left = 0, top = 0, right = 0, bottom = 0;
};
// Multiples of 1, 2 or 5 of a decade in [low, high], about `wanted` of them. low < high.
std::vector<double> evenTicks(double low, double high, int wanted);

// The plot as an SVG file that refers to nothing else.
std::string plotSvg(const Plot& plot);
// RGB8, first row on top. Text needs a font of the system (DejaVu Sans); without it there are no labels.
std::vector<uint8_t> plotPixels(const Plot& plot);
// For XML and HTML.
std::string escaped(const std::string& text);

}  // namespace sward
