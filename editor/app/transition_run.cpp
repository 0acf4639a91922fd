#include "app/transition_run.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>
#include <utility>

#include "app/frame_clock.h"
#include "app/messages.h"
#include "model/document.h"

namespace sward {
namespace {

constexpr double kDrawn = 0.3;  // of the whole, about: drawing

void draw(TransitionMeter& m, const Document& doc, Gpu& gpu, FrameClock& clock) {
    if (!m.renderer) m.renderer = std::make_unique<Renderer>(gpu, doc.tables());
    clock.wanted = 4;
    if (Status drawn = drawNextOf(*m.walk, *m.renderer); !drawn) {
        m.error = drawn.error().text();
        return stopTransitions(m);
    }
    if (!isDrawn(*m.walk)) return;
    m.renderer.reset();
}

void end(TransitionMeter& m, Messages& messages) {
    auto judged = judgeWalk(*m.walk);
    m.walk.reset();
    if (!judged) {
        m.error = judged.error().text();
        return;
    }
    m.result = std::move(*judged);
    say(messages, fmt::format("{}: {} of {} steps pop more than other blades do", m.result->plan.path,
                              stepsAboveFloor(*m.result), m.result->drawn.steps.size()));
}

// Starts the next job, or takes what the last one traced.
void trace(TransitionMeter& m, const Tables& tables, FrameClock& clock, Messages& messages) {
    if (m.job.active()) {
        if (!m.job.finished()) return;
        const auto traced = m.job.take(0);
        if (traced && !*traced) {
            m.error = traced->error().text();
            return stopTransitions(m);
        }
        m.share = tracedShare(*m.walk);
        clock.wanted = 2;
    }
    if (isTraced(*m.walk)) return end(m, messages);
    m.job = Job<bool>("transitions", 0, [walk = m.walk, t = &tables](JobControl& control) -> Result<bool> {
        if (Status traced = traceNextOf(*walk, *t, control); !traced) return traced.error();
        return true;
    });
}

}  // namespace

void startTransitions(TransitionMeter& m, const Document& doc) {
    stopTransitions(m);
    m.result.reset(), m.error.clear(), m.shown = -1, m.share = 0;
    if (!doc.isOpen()) return;
    auto walk = beginWalk(doc.project(), doc.tables(), m.plan);
    if (!walk) {
        m.error = walk.error().text();
        return;
    }
    m.walk = std::move(*walk);
    m.revision = doc.revision(), m.dir = doc.project().dir;
}

void followTransitions(TransitionMeter& m, const Document& doc, Gpu& gpu, FrameClock& clock, Messages& messages,
                       bool wait) {
    if (!m.dir.empty() && (!doc.isOpen() || doc.project().dir != m.dir)) {
        m = {};
        return;
    }
    if (!walking(m)) return;
    if (!isDrawn(*m.walk)) return draw(m, doc, gpu, clock);
    do {
        trace(m, doc.tables(), clock, messages);
        while (wait && m.job.active() && !m.job.finished()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    } while (wait && walking(m));
}

void stopTransitions(TransitionMeter& m) {
    m.job = {};
    m.walk.reset();
    m.renderer.reset();
}

bool walking(const TransitionMeter& m) { return m.walk != nullptr; }

double shareOf(const TransitionMeter& m) {
    if (!m.walk) return m.result ? 1 : 0;
    if (isDrawn(*m.walk)) return kDrawn + (1 - kDrawn) * m.share;
    return kDrawn * static_cast<double>(m.walk->drawn.size()) / static_cast<double>(m.walk->views.size());
}

std::string newsOf(const TransitionMeter& m) {
    if (!m.walk) return "";
    if (isDrawn(*m.walk)) return fmt::format("tracing the truth, {:.0f} %", 100 * m.share);
    return fmt::format("drawing {} of {}", m.walk->drawn.size() + 1, m.walk->views.size());
}

}  // namespace sward
