#include "ui/input_queue.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "ui/keys.h"

namespace sward {

bool FrameInput::ctrl() const { return keys[GLFW_KEY_LEFT_CONTROL] || keys[GLFW_KEY_RIGHT_CONTROL]; }
bool FrameInput::shift() const { return keys[GLFW_KEY_LEFT_SHIFT] || keys[GLFW_KEY_RIGHT_SHIFT]; }
bool FrameInput::alt() const { return keys[GLFW_KEY_LEFT_ALT] || keys[GLFW_KEY_RIGHT_ALT]; }

struct InputQueue::Taken {
    std::bitset<kKeyCount> keys;
    std::bitset<kButtonCount> buttons;
    bool moved = false;
    bool wheeled = false;
    bool typed = false;    // a character, or a typing key
    bool command = false;  // a control key, or a typing key with Ctrl or Alt held

    bool acted() const { return buttons.any() || typed || command; }
};

void InputQueue::push(const InputEvent& event) {
    if (event.kind == InputKind::Button && (event.code < 0 || event.code >= kButtonCount)) return;
    if (event.kind == InputKind::Key && (event.code < 0 || event.code >= kKeyCount)) return;
    events_.push_back(event);
}

// Moves come before what happens at their end, modifiers before what they modify, and what would be lost or reordered
// by sharing a frame waits for the next one.
bool InputQueue::fits(const InputEvent& e, const Taken& t) const {
    switch (e.kind) {
        case InputKind::Move:
            return !t.buttons.any() && !t.wheeled;
        case InputKind::Wheel:
        case InputKind::Drop:
            return !t.buttons.any();
        case InputKind::Char:
            return !t.buttons.any() && !t.command;
        case InputKind::Button: {
            const bool endsDrag = t.moved && !e.down;  // a drag's last place is seen while the button is still held
            return !t.buttons[static_cast<size_t>(e.code)] && !endsDrag && !t.typed && !t.command;
        }
        case InputKind::Key: {
            if (t.keys[static_cast<size_t>(e.code)]) return false;
            if (isModifierKey(e.code)) return !t.acted();
            if (!e.down) return true;
            const bool command = isControlKey(e.code) || frame_.ctrl() || frame_.alt();
            return !t.buttons.any() && !t.command && !(command && t.typed);
        }
    }
    return true;
}

void InputQueue::take(const InputEvent& e, Taken& t) {
    const size_t code = static_cast<size_t>(e.code);
    switch (e.kind) {
        case InputKind::Move:
            frame_.x = e.x, frame_.y = e.y;
            frame_.path.emplace_back(e.x, e.y);
            t.moved = true;
            break;
        case InputKind::Wheel:
            frame_.wheelX += e.x, frame_.wheelY += e.y;
            t.wheeled = true;
            break;
        case InputKind::Drop:
            frame_.dropped.push_back(e.file);
            break;
        case InputKind::Char:
            frame_.chars.push_back(static_cast<uint32_t>(e.code));
            t.typed = true;
            break;
        case InputKind::Button:
            if (frame_.buttons[code] == e.down) break;
            frame_.buttons[code] = e.down;
            (e.down ? frame_.pressed : frame_.released).set(code);
            t.buttons.set(code);
            break;
        case InputKind::Key:
            if (frame_.keys[code] == e.down) break;
            frame_.keys[code] = e.down;
            t.keys.set(code);
            if (!e.down) break;
            frame_.pressedKeys.push_back(e.code);
            if (isModifierKey(e.code)) break;
            (isControlKey(e.code) || frame_.ctrl() || frame_.alt() ? t.command : t.typed) = true;
            break;
    }
}

const FrameInput& InputQueue::next() {
    frame_.pressed.reset();
    frame_.released.reset();
    frame_.pressedKeys.clear();
    frame_.wheelX = frame_.wheelY = 0;
    frame_.chars.clear();
    frame_.dropped.clear();
    frame_.path.clear();
    Taken taken;
    while (!events_.empty() && fits(events_.front(), taken)) {
        take(events_.front(), taken);
        events_.pop_front();
    }
    return frame_;
}

}  // namespace sward
