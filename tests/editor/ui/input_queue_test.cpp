#include "editor/ui/input_queue.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace sward {
namespace {

InputEvent move(double x, double y) { return {InputKind::Move, x, y, 0, false}; }
InputEvent button(int code, bool down) { return {InputKind::Button, 0, 0, code, down}; }
InputEvent key(int code, bool down) { return {InputKind::Key, 0, 0, code, down}; }
InputEvent character(int code) { return {InputKind::Char, 0, 0, code, false}; }

void pushAll(InputQueue& q, std::initializer_list<InputEvent> events) {
    for (const InputEvent& e : events) q.push(e);
}

TEST(InputQueue, ATapWithinOneFrameIsSeenDownInOneFrameAndUpInTheNext) {
    InputQueue q;
    pushAll(q, {key(GLFW_KEY_F, true), key(GLFW_KEY_F, false)});
    EXPECT_TRUE(q.next().keys[GLFW_KEY_F]);
    EXPECT_TRUE(q.pending());
    EXPECT_FALSE(q.next().keys[GLFW_KEY_F]);
    EXPECT_FALSE(q.pending());
}

TEST(InputQueue, AChordTappedWithinOneFrameKeepsItsModifierWhileTheKeyGoesDown) {
    InputQueue q;
    pushAll(q, {key(GLFW_KEY_LEFT_CONTROL, true), key(GLFW_KEY_Z, true), key(GLFW_KEY_LEFT_CONTROL, false),
                key(GLFW_KEY_Z, false)});
    const FrameInput first = q.next();
    ASSERT_EQ(first.pressedKeys, (std::vector<int>{GLFW_KEY_LEFT_CONTROL, GLFW_KEY_Z}));
    EXPECT_TRUE(first.ctrl());
    EXPECT_FALSE(q.next().ctrl());
}

TEST(InputQueue, ThreeTapsOfOneChordAreThreePresses) {
    InputQueue q;
    for (int i = 0; i < 3; ++i)
        pushAll(q, {key(GLFW_KEY_LEFT_CONTROL, true), key(GLFW_KEY_Z, true), key(GLFW_KEY_Z, false),
                    key(GLFW_KEY_LEFT_CONTROL, false)});
    int presses = 0;
    for (int frame = 0; frame < 20; ++frame) {
        const FrameInput& f = q.next();
        for (const int k : f.pressedKeys) presses += k == GLFW_KEY_Z && f.ctrl() ? 1 : 0;
    }
    EXPECT_EQ(presses, 3);
}

TEST(InputQueue, AQuickDragKeepsItsStartItsPathAndItsEnd) {
    InputQueue q;
    pushAll(q, {move(10, 10), button(0, true), move(20, 12), move(30, 14), button(0, false), move(90, 90)});
    const FrameInput press = q.next();
    EXPECT_TRUE(press.pressed[0]);
    EXPECT_EQ(press.x, 10);
    const FrameInput drag = q.next();
    EXPECT_TRUE(drag.buttons[0]);
    EXPECT_EQ(drag.path, (std::vector<std::pair<double, double>>{{20, 12}, {30, 14}}));
    const FrameInput release = q.next();
    EXPECT_TRUE(release.released[0]);
    EXPECT_EQ(release.x, 30);
    EXPECT_EQ(q.next().x, 90);
}

TEST(InputQueue, MotionWithoutButtonsIsOneFrame) {
    InputQueue q;
    for (int i = 0; i < 100; ++i) q.push(move(i, i));
    const FrameInput f = q.next();
    EXPECT_EQ(f.x, 99);
    EXPECT_EQ(f.path.size(), 100u);
    EXPECT_FALSE(q.pending());
}

TEST(InputQueue, TypedTextStaysInOrderWithTheKeysThatEditIt) {
    InputQueue q;
    pushAll(q, {key(GLFW_KEY_A, true), character('a'), key(GLFW_KEY_A, false), key(GLFW_KEY_B, true), character('b'),
                key(GLFW_KEY_BACKSPACE, true), key(GLFW_KEY_BACKSPACE, false), character('c')});
    EXPECT_EQ(q.next().chars, (std::vector<uint32_t>{'a'}));
    EXPECT_EQ(q.next().chars, (std::vector<uint32_t>{'b'}));
    const FrameInput erase = q.next();
    EXPECT_TRUE(erase.keys[GLFW_KEY_BACKSPACE]);
    EXPECT_TRUE(erase.chars.empty());
    EXPECT_EQ(q.next().chars, (std::vector<uint32_t>{'c'}));
}

TEST(InputQueue, RepeatsAndCodesOutOfRangeAreDropped) {
    InputQueue q;
    pushAll(q, {key(-1, true), key(kKeyCount, true), button(7, true), key(GLFW_KEY_F, true), key(GLFW_KEY_F, true)});
    EXPECT_EQ(q.next().pressedKeys, (std::vector<int>{GLFW_KEY_F}));
    EXPECT_TRUE(q.next().pressedKeys.empty());
    EXPECT_FALSE(q.pending());
}

TEST(InputQueue, DroppedFilesComeInOneFrameInTheirOrderAndAfterAPressInTheNext) {
    InputQueue q;
    const InputEvent a{InputKind::Drop, 0, 0, 0, false, "/a.glb"}, b{InputKind::Drop, 0, 0, 0, false, "/b.glb"};
    pushAll(q, {move(5, 5), a, b, button(0, true), a});
    const FrameInput first = q.next();
    EXPECT_EQ(first.dropped, (std::vector<std::string>{"/a.glb", "/b.glb"}));
    EXPECT_EQ(q.next().dropped, (std::vector<std::string>{"/a.glb"}));
    EXPECT_TRUE(q.next().dropped.empty());
}

TEST(InputQueue, WheelNotchesAddUpUntilThePointerMoves) {
    InputQueue q;
    pushAll(q, {move(5, 5), {InputKind::Wheel, 0, 1, 0, false}, {InputKind::Wheel, 0, 2, 0, false}, move(50, 5)});
    const FrameInput f = q.next();
    EXPECT_EQ(f.wheelY, 3);
    EXPECT_EQ(f.x, 5);
    EXPECT_EQ(q.next().wheelY, 0);
}

}  // namespace
}  // namespace sward
