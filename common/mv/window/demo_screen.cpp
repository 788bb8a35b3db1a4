#include "mv/window/demo_screen.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "mv/formatted.h"
#include "mv/gl/program.h"
#include "mv/gl/shader_folder.h"
#include "mv/image/png.h"
#include "mv/run/copyable.h"
#include "mv/show/caught.h"
#include "mv/window/desktop.h"
#include "mv/window/keys.h"
#include "mv/window/save.h"

namespace mv {
namespace {

constexpr double panelUnits = 360;    // pixels at ordinary density
constexpr double edgeReach = 4;       // likewise: so near to the panel's edge the mouse takes it
constexpr double dividerReach = 8;    // pixels at ordinary density: so near to it the mouse takes the divider
constexpr double dividerStep = 0.02;  // of the picture's width, with [ and ]
constexpr double reloadSeconds = 0.25;
constexpr double mostMilliseconds =
    8;  // of a frame with smooth edges that are chosen by themselves: half of one at 60 a second
constexpr double leastPicture = 0.25;  // of the window's width, beside the panel
constexpr double mostOfScreen = 0.8;   // of its height, that a window takes as it opens

constexpr ImGuiWindowFlags fixedWindow = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

// The picture is as large as the command asks for, else as the original's canvas. A frame asked for by number stands still,
// so that a copied command shows the very picture it was copied from.
SessionStart startOf(const Command& command) {
    const bool sizeGiven = command.width > 0;
    return {.width = sizeGiven ? command.width : command.demo->width,
            .height = sizeGiven ? command.height : command.demo->height,
            .knobs = command.knobs,
            .changes = command.changes,
            .frame = command.firstFrame,
            .paused = command.frameGiven,
            .until = command.until};
}

// A window that reports is driven by a program, which wants the same on every machine: it has what the command line says, and nothing
// that depends on how fast the machine is or how large its screen.
bool forPeople(const Command& command) { return command.report == ReportForm::none; }

}  // namespace

DemoScreen::DemoScreen(Window& window, Gui& gui, Stage& stage, const Command& command, bool menu, bool fromMenu)
    : window_(window),
      gui_(gui),
      stage_(stage),
      info_(*command.demo),
      session_(stage, *command.demo, startOf(command)),
      report_(command.report),
      density_(command.density),
      samples_(command.samples),
      choosesSamples_(forPeople(command) && !command.samples && !command.until && info_.needs.samples == 0),
      program_(command.program),

      menu_(menu),
      fromMenu_(fromMenu),
      knobs_(gui, session_),
      study_(*command.demo, gui, stage.driver().renderer),
      steps_(window, stage, session_) {
    session_.setSamples(command.samples.value_or(0));
    const bool sizeGiven = command.width > 0;
    const int width = stage_.front().width(), height = stage_.front().height();
    if (!command.compareKnob.empty()) {
        Knob& knob = session_.demo().knob(command.compareKnob);
        knob.parse(command.compareValues[0]);
        comparison_.start(knob, command.compareValues[1]);
    }
    // A size that was asked for is meant in pixels; an original's canvas grows with the screen's density, like the panel.
    const double units = (sizeGiven ? 1 : window_.contentScale()) / window_.size().pixelsPerUnit();
    const double panel = wantedPanelPixels() / window_.size().pixelsPerUnit();
    window_.setTitle("mvgl: " + info_.name);
    const double grown = sizeGiven || !forPeople(command) ? 1 : room(width * units, height * units, panel);
    openedPixels_ = width * units * grown * window_.size().pixelsPerUnit();
    window_.show(static_cast<int>(std::lround(width * units * grown + panel)),
                 static_cast<int>(std::lround(height * units * grown)), !sizeGiven);
}

// How many times as large a picture is to open, beside a panel: so that the panel shows settings and readouts at once.
double DemoScreen::room(double width, double height, double panel) const {
    const std::optional<WorkArea> area = window_.workArea();
    if (!area) return 1;
    return std::max(1.0, std::min(mostOfScreen * area->height / height, (area->width - panel) / width));
}

// ---- What the user does

double DemoScreen::wantedPanelPixels() const {
    return std::max(panelUnits, panelWidth_) * window_.contentScale() * gui_.zoom();
}

// Leave a quarter of the window to the picture, or what it opened with, where that is less: a size of pixels that was asked for is kept.
double DemoScreen::panelPixels() const {
    const double width = window_.size().pixelWidth();
    return std::min(wantedPanelPixels(), width - std::min(leastPicture * width, openedPixels_));
}

bool DemoScreen::overPanelEdge(double x) const {
    const double edge = pictureWidth() / window_.size().pixelsPerUnit();
    return panelShown_ && !gui_.popupOpen() && pictureWidth() > 0 &&
           std::abs(x - edge) <= edgeReach * double(gui_.scale());
}

// The panel's left edge goes there, in window coordinates: not narrower than it opened, and the picture keeps its least.
void DemoScreen::widenPanel(double edge) {
    const double width = window_.size().width();
    const double pixels = (width - std::max(edge, leastPicture * width)) * window_.size().pixelsPerUnit();
    panelWidth_ = pixels / (window_.contentScale() * gui_.zoom());
}

int DemoScreen::pictureWidth() const {
    if (!panelShown_) return window_.size().pixelWidth();
    return std::max(0, window_.size().pixelWidth() - static_cast<int>(std::lround(panelPixels())));
}

bool DemoScreen::overPicture(double x) const {
    return !gui_.popupOpen() && x * window_.size().pixelsPerUnit() < pictureWidth();
}

std::optional<double> DemoScreen::dividerX() const {
    if (!comparison_.drawn() || comparison_.view() != Comparison::View::divider) return {};
    return comparison_.divider() * comparison_.sideA().picture.width / window_.size().pixelsPerUnit();
}

bool DemoScreen::overDivider(double x) const {
    const std::optional<double> divider = dividerX();
    return divider && overPicture(x) && std::abs(x - *divider) <= dividerReach * double(gui_.scale());
}

FrameInfo DemoScreen::shownFrame() const { return stage_.frame(session_.playback().frame()); }

PictureInWindow DemoScreen::pictureInWindow() const {
    return {stage_.front().height(), window_.size().pixelsPerUnit()};
}

std::optional<glm::ivec2> DemoScreen::pixelUnderMouse() const {
    const ImVec2 mouse = ImGui::GetMousePos();
    if (!ImGui::IsMousePosValid() || !overPicture(double(mouse.x))) return {};
    return glm::ivec2(vec2(mouse.x, mouse.y) * window_.size().pixelsPerUnit());
}

void DemoScreen::moveDivider(double x) {
    if (dividerX()) comparison_.moveDivider(x * window_.size().pixelsPerUnit() / comparison_.sideA().picture.width);
}

void DemoScreen::handle(const Event& event) {
    switch (event.kind) {
        case Event::Kind::key:
            return onKey(event);
        case Event::Kind::press:
            dropError_.clear();  // it has been read
            hint_ = false;
            if (overPicture(event.x)) leavePanel();
            if (event.key != GLFW_MOUSE_BUTTON_LEFT) break;
            draggingPanel_ = overPanelEdge(event.x);
            if (draggingPanel_) break;
            draggingDivider_ = overDivider(event.x);
            if (overPicture(event.x) && !draggingDivider_ &&
                !handles_.press(session_.demo(), shownFrame(), pictureInWindow().pixel(event.x, event.y),
                                handReach(gui_, pictureInWindow()))) {
                session_.pointerDown(event.x, event.y);
            } else {
                session_.pointerUp();
            }
            break;
        case Event::Kind::release:
            if (event.key != GLFW_MOUSE_BUTTON_LEFT) break;
            draggingDivider_ = draggingPanel_ = false;
            handles_.release();
            session_.pointerUp();
            break;
        case Event::Kind::move:
            if (draggingPanel_) widenPanel(event.x);
            if (draggingDivider_) moveDivider(event.x);
            if (handles_.drag(session_.demo(), shownFrame(), pictureInWindow().pixel(event.x, event.y)))
                session_.touch();
            session_.pointerMove(event.x, event.y);
            break;
        case Event::Kind::wheel:
            if (overPicture(event.x)) session_.wheel(event.notches);
            break;
        case Event::Kind::character:  // not a key: where they are differs from keyboard to keyboard
            if (gui_.typing() || !dividerX()) break;
            if (event.codePoint == '[') comparison_.moveDivider(comparison_.divider() - dividerStep);
            if (event.codePoint == ']') comparison_.moveDivider(comparison_.divider() + dividerStep);
            break;
        case Event::Kind::drop:
            return onDrop(event.file);
        case Event::Kind::keyUp:
        case Event::Kind::other:
            break;
    }
}

// The demo's knob of the file's kind gets it, or else the first for files, which says what is wrong with the file. Dropped again,
// it is read anew: somebody may have painted in it.
void DemoScreen::onDrop(const std::string& file) {
    dropError_ = "dropped file: must go to a demo with a knob that takes a picture, as texture-map has one";
    const Knob* chosen = nullptr;
    for (const Knob* knob : session_.demo().knobs()) {
        if (knob->kind() != Knob::Kind::file) continue;
        if (chosen == nullptr || (knob->takes(file) && !chosen->takes(file))) chosen = knob;
    }
    if (chosen == nullptr) return;
    knobs_.closeField();
    dropError_ = session_.set(chosen->name(), file);
    session_.touch();
}

void DemoScreen::onKey(const Event& event) {
    dropError_.clear();
    hint_ = false;
    // The field first: newer Dear ImGui may give it the keyboard back only frames after a refusal.
    if (event.key == GLFW_KEY_ESCAPE && knobs_.fieldOpen()) return knobs_.closeField();
    if (gui_.typing()) return;
    if (event.key == GLFW_KEY_F6 && panelShown_) return gui_.navigating() ? leavePanel() : enterPanel();
    if (gui_.navigating() && panelTakes(event)) return;
    bool moved = false;
    const std::optional<HandleInput::Move> move = handleMove(event.key);
    if (move && !gui_.popupOpen() &&
        handles_.key(session_.demo(), shownFrame(), *move, (event.modifiers & GLFW_MOD_SHIFT) != 0, moved)) {
        if (moved) session_.touch();
        if (*move == HandleInput::Move::next && !handles_.picks() && panelShown_)
            enterPanel();  // after the last of them
        return;
    }
    if (event.key == GLFW_KEY_TAB && panelShown_ && !gui_.popupOpen()) return enterPanel();
    if (event.key == GLFW_KEY_ESCAPE) {
        if (gui_.popupOpen()) return gui_.closePopup();
        wish_ = {fromMenu_ ? Wish::Kind::menu : Wish::Kind::quit};
        return;
    }
    const std::optional<Key> pressed = demoKey(event.key, event.scancode);
    const bool control = (event.modifiers & GLFW_MOD_CONTROL) != 0;
    if ((event.modifiers & (GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0) return;
    if (pressed && !control && session_.press(*pressed)) return;
    if (control && pressed == key('Z'))
        return (event.modifiers & GLFW_MOD_SHIFT) != 0 ? recall(future_, past_) : recall(past_, future_);
    if (event.repeat) return;
    if (pressed == key('H')) {
        panelShown_ = !panelShown_;
        hint_ = !panelShown_;
    }
    if (pressed == key('S')) save();
    if (event.key == GLFW_KEY_SPACE) session_.playback().toggle();
    if (event.key == GLFW_KEY_BACKSPACE && menu_) wish_ = {Wish::Kind::menu};
}

// The keys that the panel has while they go to it; true: the key is for it.
bool DemoScreen::panelTakes(const Event& event) {
    if (event.key == GLFW_KEY_ESCAPE) {
        if (gui_.popupOpen())
            gui_.closePopup();
        else if (!ImGui::IsAnyItemActive())  // a bar that is moved lets go of it first
            leavePanel();
        return true;
    }
    switch (event.key) {
        case GLFW_KEY_TAB:
        case GLFW_KEY_LEFT:
        case GLFW_KEY_RIGHT:
        case GLFW_KEY_UP:
        case GLFW_KEY_DOWN:
        case GLFW_KEY_SPACE:
        case GLFW_KEY_ENTER:
            return true;
        default:
            return false;
    }
}

void DemoScreen::enterPanel() {
    gui_.setNavigation(true);
    panelComes_ = 2;
}

void DemoScreen::leavePanel() {
    gui_.setNavigation(false);
    panelComes_ = 0;
}

void DemoScreen::remember() {
    if (ImGui::IsAnyMouseDown() || knobs_.sweeping()) return;
    std::vector<KnobSetting> now;
    for (const Knob* knob : session_.demo().knobs()) now.push_back({knob->name(), knob->text()});
    const auto isSame = [](const KnobSetting& a, const KnobSetting& b) { return a.text == b.text; };
    if (std::ranges::equal(now, present_, isSame)) return;
    if (!present_.empty()) {
        past_.push_back(std::move(present_));
        future_.clear();
    }
    present_ = std::move(now);
}

void DemoScreen::recall(std::vector<std::vector<KnobSetting>>& from, std::vector<std::vector<KnobSetting>>& to) {
    remember();  // of the key just before
    if (from.empty()) return;
    to.push_back(present_);
    present_ = std::move(from.back());
    from.pop_back();
    knobs_.closeField();
    for (const KnobSetting& setting : present_) session_.set(setting.name, setting.text);
    session_.touch();
}

// ---- Time

bool DemoScreen::advance(double seconds) {
    bool changed = false;
    untilReload_ -= seconds;
    if (untilReload_ <= 0) {
        untilReload_ = reloadSeconds;
        const std::vector<std::string> before = shaderErrors_;
        reloadShaders();
        changed = before != shaderErrors_;
    }
    changed |= study_.advance();
    changed |= knobs_.advance(seconds);
    if (!study_.measuring()) session_.advance(seconds);  // two that draw would spoil what one measures
    return changed || pending();
}

void DemoScreen::reloadShaders() {
    std::vector<std::string> errors;
    try {
        Reloaded reloaded = reloadChangedPrograms();
        if (reloaded.programs > 0) session_.touch();
        errors = std::move(reloaded.standing);
    } catch (const std::exception&) {
        errors = {caughtSentence("shaders")};
    }
    if (errors == shaderErrors_) return;
    shaderErrors_ = std::move(errors);
    // Beside the panel, the terminal the program was started from has it.
    for (const std::string& error : shaderErrors_) std::cerr << "error: " << error << std::endl;
    if (shaderErrors_.empty()) std::cerr << "note: the shaders of " << info_.name << " compile again" << std::endl;
}

// ---- The picture

void DemoScreen::redraw(bool whole) {
    // An error of another part of the window is not the demo's.
    for (const std::string& problem : takeErrors()) std::cerr << "window: OpenGL: " << problem << "\n";
    const auto draw = whole ? &Session::finish : &Session::draw;
    (session_.*draw)(pictureWidth(), window_.size().pixelHeight(), panelShown_ || report_ != ReportForm::none,
                     comparison_.on() ? &comparison_ : nullptr);
}

const Target* DemoScreen::shownTarget() {
    if (comparison_.drawn()) return &comparison_.sheet();
    return session_.hasPicture() ? &stage_.front() : nullptr;
}

void DemoScreen::showPicture() {
    const Target* shown = shownTarget();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, window_.size().pixelWidth(), window_.size().pixelHeight());
    glClearColor(0.2F, 0.2F, 0.2F, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    // The upper left corner stays where it is while a picture of another size is the last good one.
    if (shown) shown->blitToWindow(0, window_.size().pixelHeight() - shown->height());
}

// Smooth edges for a window that nobody has told, where they leave a frame time enough: tried with the picture that it opens with.
void DemoScreen::chooseSamples() {
    choosesSamples_ = false;
    // What the processor makes in passes has no edges of OpenGL's, and what takes so long without is not tried with.
    const double compiling = 200;  // ms that a first frame may take for it
    if (session_.passes() > 0 || comparison_.on() || !session_.error().empty() ||
        session_.lastMilliseconds() > compiling || session_.times(1).medianMs > mostMilliseconds)
        return;
    const auto measured = [&] {
        return std::ranges::count_if(session_.demo().readouts(),
                                     [](const Readout* readout) { return readout->value().has_value(); });
    };
    const auto before = measured();
    session_.setSamples(4);
    redraw();
    // Of the later ones, since the first allocates; and some readouts cannot be had of such a picture
    const double milliseconds = session_.times(3).medianMs;
    const bool isSmooth = session_.error().empty() && measured() == before && milliseconds < mostMilliseconds;
    whySamples_ = formatted("%.1f ms a frame with them, as it opened: ", milliseconds) + (isSmooth ? "on" : "off");
    if (isSmooth) return;
    session_.setSamples(0);
    redraw();
}

void DemoScreen::draw() {
    session_.setDensity(std::max({1.0, window_.contentScale(), density_}));
    if (pictureWidth() > 0 && session_.due(pictureWidth(), window_.size().pixelHeight())) {
        redraw();
        if (choosesSamples_) chooseSamples();
    }
    if (shownTarget())
        steps_.outline(std::clamp(static_cast<int>(std::lround(2 * window_.size().pixelsPerUnit())), 1, 16));
    showPicture();
    gui_.begin();
    if (const Target* shown = shownTarget(); shown && !comparison_.on()) {
        const double units = 1 / window_.size().pixelsPerUnit();
        steps_.showOutline(float(shown->width() * units), float(shown->height() * units));
    }
    // Settings that make no picture: what is shown is another's
    if (!session_.error().empty() && shownTarget()) {
        const float wide = float(pictureWidth() / window_.size().pixelsPerUnit());
        ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, {wide, float(window_.size().height())},
                                                      IM_COL32(30, 33, 38, 150));
    }
    if (panelShown_) {
        showPanel();
    } else {
        showOverlay();
    }
    handled_ = showHandles(handles_, session_.demo(), shownFrame(), pictureInWindow(),
                           overPicture(double(ImGui::GetMousePos().x)), gui_);
    showDividerHandle();
    if (draggingPanel_ || overPanelEdge(double(ImGui::GetMousePos().x)))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    remember();
    gui_.end();
}

// ---- The panel

std::vector<Message> DemoScreen::messages(bool plain) const {
    std::vector<Message> all;
    for (const std::string& error : shaderErrors_) all.push_back({error, true});
    if (!dropError_.empty()) all.push_back({dropError_, true});
    if (!session_.error().empty())
        all.push_back({plain ? inPlainWords(session_.error(), session_.demo()) : session_.error(), true});
    if (session_.error().empty()) {
        const auto notes = comparison_.on() ? comparison_.messages() : session_.notes().messages;
        for (const std::string& note : notes) all.push_back({note, false});
    }
    return all;
}

void DemoScreen::showPanel() {
    const auto units = static_cast<float>(1 / window_.size().pixelsPerUnit());
    const float left = float(pictureWidth()) * units, height = float(window_.size().height());
    ImGui::SetNextWindowPos({left, 0});
    ImGui::SetNextWindowSize({float(window_.size().width()) - left, height});
    if (panelComes_ == 2) ImGui::SetNextWindowFocus();
    if (panelComes_ > 0) {
        --panelComes_;
        showFocus();
    }
    ImGui::Begin("panel", nullptr, fixedWindow | ImGuiWindowFlags_NoScrollWithMouse);
    const std::vector<Message> shown = messages(true);
    const float below = messagesHeight(shown, ImGui::GetContentRegionAvail().x, height * 0.5F);
    // The messages stand at the bottom, always in sight; the rest scrolls above them.
    beginReachable("scroll", {0, below > 0 ? -below - ImGui::GetStyle().ItemSpacing.y : 0});
    showPanelContent();
    ImGui::EndChild();
    if (below > 0) showMessages(shown, below);
    ImGui::End();
}

// With the panel away, what went wrong is still told: over the picture's lower edge.
void DemoScreen::showOverlay() {
    const std::vector<Message> shown = messages(true);
    if (shown.empty()) return hint_ ? showHint() : void();
    const auto width = float(window_.size().width()), height = float(window_.size().height());
    const float padding = ImGui::GetStyle().WindowPadding.x;
    const float tall = messagesHeight(shown, width - 2 * padding, height * 0.5F) + 2 * padding;
    ImGui::SetNextWindowPos({0, height - tall});
    ImGui::SetNextWindowSize({width, tall});
    ImGui::Begin("overlay", nullptr, fixedWindow);
    showMessages(shown, 0);
    ImGui::End();
}

// The way back, faint in a corner until something else is done.
void DemoScreen::showHint() {
    const std::string words = std::string(isBound(session_.demo(), 'H') ? "Ctrl+H" : "H") + ": the panel again";
    const ImVec2 padding = ImGui::GetStyle().FramePadding, size = ImGui::CalcTextSize(words.c_str());
    const ImVec2 low{padding.x, float(window_.size().height()) - size.y - 3 * padding.y};
    const ImVec2 high{low.x + size.x + 2 * padding.x, low.y + size.y + 2 * padding.y};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_WindowBg, 0.7F), ImGui::GetStyle().FrameRounding);
    list.AddText({low.x + padding.x, low.y + padding.y}, ImGui::GetColorU32(ImGuiCol_Text, 0.9F), words.c_str());
    notePlace("hint", {low.x, low.y, high.x, high.y});
}

// A grip on the line between the two pictures; the mouse over it shows which way it goes.
void DemoScreen::showDividerHandle() {
    const std::optional<double> divider = dividerX();
    if (!divider) return;
    const float scale = gui_.scale(), radius = 11 * scale;
    const ImVec2 middle{static_cast<float>(*divider), float(window_.size().height()) / 2};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddCircleFilled(middle, radius, ImGui::GetColorU32(ImGuiCol_WindowBg));
    list.AddCircle(middle, radius, ImGui::GetColorU32(ImGuiCol_Text), 0, 1.5F * scale);
    for (const float side : {-1.0F, 1.0F}) {
        const float tip = middle.x + side * 7 * scale, foot = middle.x + side * 3 * scale, half = 3.5F * scale;
        // in the order that ImGui takes for the outside of a triangle
        list.AddTriangleFilled({tip, middle.y}, {foot, middle.y + side * half}, {foot, middle.y - side * half},
                               ImGui::GetColorU32(ImGuiCol_Text));
    }
    if (draggingDivider_ || overDivider(double(ImGui::GetMousePos().x))) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    }
}

void DemoScreen::showPanelContent() {
    if (menu_ && button("Back to the menu")) wish_ = {Wish::Kind::menu};
    ImGui::PushFont(gui_.titleFont());
    ImGui::TextUnformatted(info_.name.c_str());
    ImGui::PopFont();
    wrapped(info_.sentence);
    if (!info_.lookFor.empty()) wrapped(color::dim, "Look for: " + info_.lookFor);

    showFiles();
    if (session_.passes() > 0 && !comparison_.on()) showPasses(session_.passesDone(), session_.passes());

    Demo& demo = session_.demo();
    bool moved = false;
    if (info_.presets.size() > 0 && section("Presets") && showPresets(info_, demo)) {
        knobs_.closeField();
        moved = true;
    }
    if (!demo.knobs().empty() && section("Settings"))
        moved |= knobs_.show(comparison_, knobsNamed(session_.error(), demo));
    if (!demo.knobs().empty() && section("Compare")) moved |= showComparison(demo, comparison_, gui_);
    if (section("Draw by draw")) {
        if (comparison_.on()) {
            wrapped(color::dim, "Two settings are compared: each is drawn whole.");
        } else if (steps_.show(pixelUnderMouse())) {
            session_.touch();
        }
    }
    if (session_.playback().animated() && section("Time")) moved |= showTime(session_, gui_.scale());
    if (!demo.readouts().empty() && section("Readouts")) showReadouts(demo, comparison_);
    if (study_.any() && section("Error and time")) moved |= study_.show(demo);
    if (moved) session_.touch();
    if (!session_.notes().matrices.empty() && section("Matrices")) {
        if (comparison_.on()) wrapped(color::dim, "of A: " + comparison_.labelA());
        const std::string copied = showMatrices(session_.notes());
        if (!copied.empty()) window_.copyToClipboard(copied);
    }
    if (section("Picture")) showFile();
    if (section("Keys and mouse"))
        showControls(demo, session_.playback().animated(), menu_, fromMenu_, comparison_.on());
}

// Doors to the lesson's page and its shader, where the program stands beside its sources.
void DemoScreen::showFiles() {
    const std::filesystem::path shaders = shaderFolder("demo-" + info_.name);
    if (shaders.empty()) return;
    const auto open = [&](const char* label, const std::filesystem::path& file, const char* tip) {
        std::error_code missing;
        if (!std::filesystem::is_regular_file(file, missing)) return;
        if (button(label)) {
            try {
                openByDesktop(file);
            } catch (const Error& error) {
                dropError_ = error.what();
            }
        }
        tooltip(tip);
        ImGui::SameLine();
    };
    open("Lesson", shaders.parent_path() / info_.page, "opens the page that goes with it");
    const std::string name = info_.name;
    open("Edit shader", shaders / name / (name + ".frag"),
         "opens the fragment shader in your editor: a change that is saved is seen at once");
    ImGui::NewLine();
}

std::string DemoScreen::defaultName() const {
    return info_.name + "-" + std::to_string(session_.drawnFrame()) + ".png";
}

std::string DemoScreen::commandLine(const std::string& start) const {
    const Target& target = stage_.front();
    const std::optional<int> until = comparison_.on() ? std::optional<int>() : session_.until();
    // None is said where somebody asked for none: a window would choose
    std::optional<int> samples;
    if (stage_.samples() > info_.needs.samples || (samples_ && info_.needs.samples == 0 && !until))
        samples = stage_.samples();
    return copyableCommand(start, info_, session_.demo(), session_.drawnFrame(), target.width(), target.height(),
                           comparison_.on() ? comparison_.compared() : ComparedKnob{}, &stage_.timeline(), until,
                           stage_.density(), samples);
}

void DemoScreen::showSmoothEdges() {
    bool smooth = stage_.samples() > 0;
    ImGui::BeginDisabled(session_.until().has_value());
    if (ImGui::Checkbox("smooth edges", &smooth)) {
        samples_ = smooth ? 4 : 0;
        session_.setSamples(*samples_);
        whySamples_.clear();
    }
    notePlace("smooth edges");
    ImGui::EndDisabled();
    tooltip("four samples for each pixel (--multisample 4); a frame that is stopped after a draw has one");
    if (!whySamples_.empty()) wrapped(color::dim, whySamples_);
}

void DemoScreen::showFile() {
    if (info_.needs.samples == 0) showSmoothEdges();
    bool light = gui_.light();
    if (ImGui::Checkbox("light panel", &light)) gui_.setLight(light);
    notePlace("light panel");
    tooltip("dark words on a light ground, as a beamer wants them (Ctrl+L)");
    char text[96];
    const int width = stage_.front().width(), height = stage_.front().height();
    if (comparison_.on()) {
        std::snprintf(text, sizeof text, "%d x %d pixels\na frame: %.2f ms with A, %.2f ms with B", width, height,
                      comparison_.sideA().milliseconds, comparison_.sideB().milliseconds);
    } else {
        std::snprintf(text, sizeof text, "%d x %d pixels, %.2f ms a frame", width, height, session_.lastMilliseconds());
    }
    ImGui::TextUnformatted(text);
    tooltip("the last drawn frame until the driver was done with it, with what its readouts took to measure");

    const ImGuiStyle& style = ImGui::GetStyle();
    const float buttonWidth = ImGui::CalcTextSize("Save picture").x + 2 * style.FramePadding.x;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - buttonWidth - style.ItemSpacing.x);
    ImGui::InputTextWithHint("##name", defaultName().c_str(), fileName_.data(), fileName_.size());
    notePlace("file name");
    tooltip("the file's name; a file that is there is not replaced, the next free number is taken");
    ImGui::SameLine();
    if (button("Save picture", {buttonWidth, 0})) save();
    if (!saved_.empty()) wrapped(saveFailed_ ? color::error : color::dim, saved_);

    if (button("Copy command line", {ImGui::GetContentRegionAvail().x, 0})) copyCommand();
    tooltip("the command that makes this very picture, to the clipboard");
    wrapped(color::dim, commandLine(startOf(program_, info_)));
}

void DemoScreen::save() {
    try {
        if (session_.stale()) redraw(true);  // of the settings as they are now, not as they were in the last frame
        const Target* shown = shownTarget();
        if (!session_.error().empty() || !shown)
            throw Error("picture", "must be one of the present settings", session_.error());
        const auto path = freePicturePath(fileName_[0] != '\0' ? fileName_.data() : defaultName());
        writePng(path, shown->read(), comparison_.on() ? "" : commandLine(info_.name));
        saved_ = "Saved " + path.string();
        saveFailed_ = false;
    } catch (const std::exception&) {
        saved_ = caughtSentence("picture");
        saveFailed_ = true;
        std::cerr << "error: " << saved_ << std::endl;
    }
}

void DemoScreen::copyCommand() { window_.copyToClipboard(commandLine(startOf(program_, info_))); }

}  // namespace mv
