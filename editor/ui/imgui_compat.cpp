#include "ui/imgui_compat.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdint>
#if IMGUI_VERSION_NUM == 19010
#include <imgui_internal.h>
#endif

namespace sward::ui {
namespace {

struct KeyPair {
    int imgui, ours;
};
constexpr KeyPair kKeys[] = {
    {ImGuiKey_Tab, GLFW_KEY_TAB},
    {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
    {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
    {ImGuiKey_UpArrow, GLFW_KEY_UP},
    {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
    {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
    {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
    {ImGuiKey_Home, GLFW_KEY_HOME},
    {ImGuiKey_End, GLFW_KEY_END},
    {ImGuiKey_Insert, GLFW_KEY_INSERT},
    {ImGuiKey_Delete, GLFW_KEY_DELETE},
    {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
    {ImGuiKey_Space, GLFW_KEY_SPACE},
    {ImGuiKey_Enter, GLFW_KEY_ENTER},
    {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
    {ImGuiKey_A, GLFW_KEY_A},
    {ImGuiKey_C, GLFW_KEY_C},
    {ImGuiKey_V, GLFW_KEY_V},
    {ImGuiKey_X, GLFW_KEY_X},
    {ImGuiKey_Y, GLFW_KEY_Y},
    {ImGuiKey_Z, GLFW_KEY_Z},
#if IMGUI_VERSION_NUM >= 18700
    {ImGuiKey_KeypadEnter, GLFW_KEY_KP_ENTER},
#else
    {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
#endif
};

void feedKeys(ImGuiIO& io, const FrameInput& in) {
#if IMGUI_VERSION_NUM >= 18700
    io.AddKeyEvent(ImGuiMod_Ctrl, in.ctrl());
    io.AddKeyEvent(ImGuiMod_Shift, in.shift());
    io.AddKeyEvent(ImGuiMod_Alt, in.alt());
    for (const KeyPair& k : kKeys) io.AddKeyEvent(static_cast<ImGuiKey>(k.imgui), in.keys[static_cast<size_t>(k.ours)]);
#else
    for (int k = 0; k < kKeyCount; ++k) io.KeysDown[k] = in.keys[static_cast<size_t>(k)];
    io.KeyCtrl = in.ctrl();
    io.KeyShift = in.shift();
    io.KeyAlt = in.alt();
#endif
}

struct TypedLine {
    std::string& text;
    const LineHelp& help;
};

void replace(ImGuiInputTextCallbackData* data, const std::string& with) {
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, with.c_str());
}

int onTyping(ImGuiInputTextCallbackData* data) {
    TypedLine& line = *static_cast<TypedLine*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
        line.text.resize(static_cast<size_t>(data->BufTextLen));
        data->Buf = line.text.data();
    } else if (data->EventFlag == ImGuiInputTextFlags_CallbackHistory) {
        replace(data, line.help.recall(std::string(data->Buf, static_cast<size_t>(data->BufTextLen)),
                                       data->EventKey == ImGuiKey_UpArrow ? -1 : 1));
    } else if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion) {
        replace(data, line.help.complete(std::string(data->Buf, static_cast<size_t>(data->BufTextLen))));
    }
    return 0;
}

}  // namespace

void setUpContext() {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigInputTextCursorBlink = false;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
#if IMGUI_VERSION_NUM >= 18700
    io.ConfigInputTrickleEventQueue = false;
#else
    for (const KeyPair& k : kKeys) io.KeyMap[k.imgui] = k.ours;
#endif
}

void feedInput(const FrameInput& in, float deltaSeconds, int width, int height, int pixelWidth, int pixelHeight) {
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = deltaSeconds;
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    const auto ratio = [](int pixels, int size) {
        return size > 0 ? static_cast<float>(pixels) / static_cast<float>(size) : 1.f;
    };
    io.DisplayFramebufferScale = {ratio(pixelWidth, width), ratio(pixelHeight, height)};
    io.MousePos = {static_cast<float>(in.x), static_cast<float>(in.y)};
    for (int b = 0; b < kButtonCount; ++b) io.MouseDown[b] = in.buttons[static_cast<size_t>(b)];
    io.MouseWheel = static_cast<float>(in.wheelY);
    io.MouseWheelH = static_cast<float>(in.wheelX);
    feedKeys(io, in);
    for (const uint32_t c : in.chars) io.AddInputCharacter(c);
}

ImTextureID textureId(unsigned glTexture) { return (ImTextureID)(intptr_t)glTexture; }

bool inputText(const char* id, const char* hint, std::string& text, const LineHelp& help) {
    int flags = ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_AutoSelectAll;
    if (help.recall) flags |= ImGuiInputTextFlags_CallbackHistory;
    if (help.complete) flags |= ImGuiInputTextFlags_CallbackCompletion;
    TypedLine line{text, help};
    ImGui::InputTextWithHint(id, hint, text.data(), text.capacity() + 1, flags, onTyping, &line);
    return ImGui::IsItemDeactivated() && enterPressed();
}

bool enterPressed() {
#if IMGUI_VERSION_NUM >= 18700
    return ImGui::IsKeyPressed(ImGuiKey_Enter, false) || ImGui::IsKeyPressed(ImGuiKey_KeypadEnter, false);
#else
    return ImGui::IsKeyPressed(GLFW_KEY_ENTER, false) || ImGui::IsKeyPressed(GLFW_KEY_KP_ENTER, false);
#endif
}

bool escapePressed() {
#if IMGUI_VERSION_NUM >= 18700
    return ImGui::IsKeyPressed(ImGuiKey_Escape, false);
#else
    return ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false);
#endif
}

namespace {

// Version 1.90.1 refuses the keyboard to items out of the scope that had it last, which later ones mended.
void takeScope() {
#if IMGUI_VERSION_NUM == 19010
    ImGuiContext& context = *ImGui::GetCurrentContext();
    context.NavFocusScopeId = context.CurrentFocusScopeId;
#endif
}

}  // namespace

void focusNext() {
    takeScope();
    ImGui::SetKeyboardFocusHere();
}
void focusLast() {
    takeScope();
    ImGui::SetKeyboardFocusHere(-1);
}

void allowOverlapOfNext() {
#if IMGUI_VERSION_NUM >= 18970
    ImGui::SetNextItemAllowOverlap();
#endif
}

void allowOverlapOfLast() {
#if IMGUI_VERSION_NUM < 18970
    ImGui::SetItemAllowOverlap();
#endif
}

void forgetClicks() {
    for (double& time : ImGui::GetIO().MouseClickedTime) time = -1e9;
}

void setClipboardFunctions(const char* (*get)(void*), void (*set)(void*, const char*), void* user) {
    ImGuiIO& io = ImGui::GetIO();
    io.GetClipboardTextFn = get;
    io.SetClipboardTextFn = set;
    io.ClipboardUserData = user;
}

}  // namespace sward::ui
