// What the person did, in order, handed out a frame at a time.
// A frame takes at most one transition per key and button, and never reorders: at three frames a second no tap is lost,
// and a press, a drag and a release that came within one frame are three frames, the drag with its start point.
// Does not: know a window system or Dear ImGui; key codes are those of keys.h.
#pragma once
#include <bitset>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace sward {

inline constexpr int kKeyCount = 512;
inline constexpr int kButtonCount = 3;  // left, right, middle

enum class InputKind : uint8_t { Move, Button, Wheel, Key, Char, Drop };

struct InputEvent {
    InputKind kind = InputKind::Move;
    double x = 0, y = 0;    // Move: window coordinates from the top left; Wheel: notches, y up
    int code = 0;           // Button: 0 left, 1 right, 2 middle; Key: key code; Char: Unicode code point
    bool down = false;      // Button, Key
    std::string file = {};  // Drop: where it lies
};

// What one frame sees.
struct FrameInput {
    double x = -1, y = -1;                        // where the pointer is now
    std::bitset<kButtonCount> buttons;            // held at the end of the frame
    std::bitset<kButtonCount> pressed, released;  // their transitions in this frame
    std::bitset<kKeyCount> keys;                  // held at the end of the frame
    std::vector<int> pressedKeys;                 // keys that went down in this frame, in order
    double wheelX = 0, wheelY = 0;
    std::vector<uint32_t> chars;
    std::vector<std::string> dropped;             // files, in the order in which they came
    std::vector<std::pair<double, double>> path;  // every place the pointer passed in this frame, in order

    // Either of the two keys is held at the end of the frame.
    bool ctrl() const;
    // Likewise.
    bool shift() const;
    // Likewise.
    bool alt() const;
};

class InputQueue {
  public:
    // Codes out of range are dropped, and so are repeats (a press of what is already down).
    void push(const InputEvent& event);
    // Events wait that no frame has taken.
    bool pending() const { return !events_.empty(); }
    // Takes as many events as one frame may hold.
    const FrameInput& next();

  private:
    struct Taken;  // what the frame being filled holds already
    bool fits(const InputEvent& event, const Taken& taken) const;
    void take(const InputEvent& event, Taken& taken);

    std::deque<InputEvent> events_;
    FrameInput frame_;
};

}  // namespace sward
