#include "cost/plot.h"

#include <stb/stb_truetype.h>

#include "core/file.h"
#include "core/log.h"

namespace sward {
namespace {

constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

glm::vec3 rgbOf(const std::string& hex) {
    unsigned v = 0;
    std::sscanf(hex.c_str(), "#%6x", &v);
    return {static_cast<float>(v >> 16 & 255), static_cast<float>(v >> 8 & 255), static_cast<float>(v & 255)};
}

struct Canvas {
    int width, height;
    std::vector<glm::vec3> pixels;

    void mix(int x, int y, const glm::vec3& color, double cover) {
        if (x < 0 || y < 0 || x >= width || y >= height || cover <= 0) return;
        glm::vec3& p = pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
        p = glm::mix(p, color, static_cast<float>(std::min(cover, 1.0)));
    }
    // distance(p): how far a pixel's middle lies outside the shape; a pixel's width of it fades.
    template <class D>
    void shape(glm::dvec2 low, glm::dvec2 high, const std::string& color, D&& distance) {
        const glm::vec3 c = rgbOf(color);
        for (int y = std::max(0, static_cast<int>(low.y) - 2); y <= std::min(height - 1, static_cast<int>(high.y) + 2);
             ++y)
            for (int x = std::max(0, static_cast<int>(low.x) - 2);
                 x <= std::min(width - 1, static_cast<int>(high.x) + 2); ++x)
                mix(x, y, c, 0.5 - distance(glm::dvec2(x + 0.5, y + 0.5)));
    }
    void segment(glm::dvec2 a, glm::dvec2 b, double lineWidth, const std::string& color) {
        const glm::dvec2 d = b - a;
        const double length2 = glm::dot(d, d), half = lineWidth / 2;
        shape(glm::min(a, b) - half, glm::max(a, b) + half, color, [&](const glm::dvec2& p) {
            const double t = length2 > 0 ? std::clamp(glm::dot(p - a, d) / length2, 0.0, 1.0) : 0;
            return glm::distance(p, a + t * d) - half;
        });
    }
    void line(const PlotLine& l) {
        for (size_t i = 0; i + 1 < l.points.size(); ++i) {
            const glm::dvec2 a = l.points[i], b = l.points[i + 1];
            const double length = glm::distance(a, b);
            if (l.dash <= 0 || length <= 0)
                segment(a, b, l.width, l.color);
            else
                for (double from = 0; from < length; from += 2 * l.dash)
                    segment(glm::mix(a, b, from / length), glm::mix(a, b, std::min(1.0, (from + l.dash) / length)),
                            l.width, l.color);
        }
    }
    void bar(const PlotBar& b) {
        shape(b.low, b.high, b.color, [&](const glm::dvec2& p) {
            const glm::dvec2 outside = glm::max(b.low - p, p - b.high);
            return std::max(outside.x, outside.y);
        });
    }
    void dot(const PlotDot& d) {
        shape(d.at - d.radius, d.at + d.radius, d.color, [&](const glm::dvec2& p) {
            const double outside = glm::distance(p, d.at) - d.radius;
            return d.filled ? outside : std::abs(outside + 0.75) - 0.75;
        });
    }
};

// The system's font, or nothing.
struct Font {
    std::string bytes;
    stbtt_fontinfo info{};
    bool there = false;

    Font() {
        auto file = readFile(kFont, 64 << 20);
        if (!file) {
            logWarning("plots have no labels: " + file.error().text());
            return;
        }
        bytes = std::move(*file);
        const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
        there = stbtt_InitFont(&info, data, stbtt_GetFontOffsetForIndex(data, 0)) != 0;
    }
    double advance(char c, double scale) const {
        int step = 0, left = 0;
        stbtt_GetCodepointHMetrics(&info, c, &step, &left);
        return step * scale;
    }
    void draw(Canvas& canvas, const PlotText& t) const {
        if (!there) return;
        const float scale = stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(t.size));
        double length = 0;
        for (const char c : t.text) length += advance(c, scale);
        double along = t.anchor == PlotAnchor::Start ? 0 : t.anchor == PlotAnchor::Middle ? -length / 2 : -length;
        const glm::vec3 color = rgbOf(t.color);
        for (const char c : t.text) {
            int w = 0, h = 0, left = 0, top = 0;
            const double at = (t.upright ? -t.at.y : t.at.x) + along;
            unsigned char* glyph = stbtt_GetCodepointBitmapSubpixel(
                &info, scale, scale, static_cast<float>(at - std::floor(at)), 0, c, &w, &h, &left, &top);
            for (int y = 0; y < h; ++y)
                for (int x = 0; x < w; ++x) {
                    const int u = static_cast<int>(std::floor(at)) + left + x, v = top + y;
                    const double cover = glyph[y * w + x] / 255.0;
                    if (t.upright)
                        canvas.mix(static_cast<int>(t.at.x) + v, -u, color, cover);
                    else
                        canvas.mix(u, static_cast<int>(t.at.y) + v, color, cover);
                }
            stbtt_FreeBitmap(glyph, nullptr);
            along += advance(c, scale);
        }
    }
};

std::string pointsText(const std::vector<glm::dvec2>& points) {
    std::string out;
    for (const glm::dvec2& p : points) out += fmt::format("{}{:.1f},{:.1f}", out.empty() ? "" : " ", p.x, p.y);
    return out;
}

// 1, 2 or 5 of a decade, so that about `wanted` of them fill a span.
double evenStep(double span, int wanted) {
    const double rough = span / wanted, decade = std::pow(10, std::floor(std::log10(rough)));
    for (const double m : {1.0, 2.0, 5.0})
        if (m * decade >= rough) return m * decade;
    return 10 * decade;
}

}  // namespace

std::vector<double> evenTicks(double low, double high, int wanted) {
    std::vector<double> out;
    const double step = evenStep(high - low, wanted);
    for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) out.push_back(i * step + 0.0);
    return out;
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

std::string plotSvg(const Plot& plot) {
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"DejaVu Sans, sans-serif\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"{2}\"/>\n",
        plot.width, plot.height, plot.background);
    for (const PlotBar& b : plot.bars)
        out += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
                           b.low.x, b.low.y, b.high.x - b.low.x, b.high.y - b.low.y, b.color);
    for (const PlotLine& l : plot.lines)
        out += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n",
                           pointsText(l.points), l.color, l.width,
                           l.dash > 0 ? fmt::format(" stroke-dasharray=\"{}\"", l.dash) : "");
    for (const PlotDot& d : plot.dots)
        out += fmt::format(
            "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}><title>{}</title></circle>\n", d.at.x, d.at.y, d.radius,
            d.filled ? "fill=\"" + d.color + "\"" : "fill=\"none\" stroke-width=\"1.5\" stroke=\"" + d.color + "\"",
            escaped(d.title));
    for (const PlotText& t : plot.texts)
        out += fmt::format(
            "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n", t.at.x,
            t.at.y, t.size, t.color,
            t.anchor == PlotAnchor::Start    ? "start"
            : t.anchor == PlotAnchor::Middle ? "middle"
                                             : "end",
            t.upright ? fmt::format(" transform=\"rotate(-90 {:.1f} {:.1f})\"", t.at.x, t.at.y) : "", escaped(t.text));
    return out + "</svg>\n";
}

std::vector<uint8_t> plotPixels(const Plot& plot) {
    Canvas canvas{plot.width, plot.height,
                  std::vector<glm::vec3>(static_cast<size_t>(plot.width) * static_cast<size_t>(plot.height),
                                         rgbOf(plot.background))};
    for (const PlotBar& b : plot.bars) canvas.bar(b);
    for (const PlotLine& l : plot.lines) canvas.line(l);
    for (const PlotDot& d : plot.dots) canvas.dot(d);
    const Font font;
    for (const PlotText& t : plot.texts) font.draw(canvas, t);
    std::vector<uint8_t> out;
    for (const glm::vec3& p : canvas.pixels)
        for (int c = 0; c < 3; ++c) out.push_back(static_cast<uint8_t>(std::lround(std::clamp(p[c], 0.0f, 255.0f))));
    return out;
}

}  // namespace sward
