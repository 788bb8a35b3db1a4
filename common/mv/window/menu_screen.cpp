#include "mv/window/menu_screen.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "mv/demo/chapters.h"
#include "mv/gl/functions.h"
#include "mv/show/caught.h"
#include "mv/window/panel_parts.h"
#include "mv/window/window_report.h"

namespace mv {
namespace {

constexpr int pictureSide = 200;  // pixels at ordinary density
constexpr float cardPadding = 12;
constexpr int menuWidth = 1000, menuHeight = 760;

}  // namespace

MenuScreen::MenuScreen(Window& window, Gui& gui, Stage& stage, Cards& cards, std::string problem, ReportForm report)
    : window_(window), gui_(gui), stage_(stage), cards_(cards), problem_(std::move(problem)), report_(report) {
    if (cards_.selected.empty() && !catalogue().empty()) cards_.selected = catalogue().front().name;
    const double scale = window_.contentScale() / window_.size().pixelsPerUnit();
    window_.setTitle("mvgl");
    window_.show(static_cast<int>(std::lround(menuWidth * scale)), static_cast<int>(std::lround(menuHeight * scale)),
                 true);
}

void MenuScreen::open(const DemoInfo& info) {
    cards_.selected = info.name;
    wish_ = {Wish::Kind::open, &info};
}

void MenuScreen::handle(const Event& event) {
    if (event.kind == Event::Kind::character && event.codePoint >= ' ' && event.codePoint < 0x7F)
        return search(search_ + static_cast<char>(event.codePoint));
    if (event.kind != Event::Kind::key) return;
    switch (event.key) {
        case GLFW_KEY_BACKSPACE:
            if (!search_.empty()) search(search_.substr(0, search_.size() - 1));
            break;
        case GLFW_KEY_ESCAPE:
            if (!search_.empty()) return search("");
            wish_ = {Wish::Kind::quit};
            break;
        case GLFW_KEY_LEFT:
            return moveSelection(-1, 0);
        case GLFW_KEY_RIGHT:
            return moveSelection(1, 0);
        case GLFW_KEY_UP:
            return moveSelection(0, -1);
        case GLFW_KEY_DOWN:
            return moveSelection(0, 1);
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER:
            for (const DemoInfo& info : catalogue()) {
                if (info.name == cards_.selected && isFound(info) && !event.repeat) open(info);
            }
            break;
        default:
            break;
    }
}

// Its name, its sentence or its chapter has the words, in whatever letters.
bool MenuScreen::isFound(const DemoInfo& info) const {
    const auto small = [](std::string text) {
        for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        return text;
    };
    return small(info.name + " " + info.sentence + " " + info.chapter).find(small(search_)) != std::string::npos;
}

// The first one that is found is chosen, where the one before is not.
void MenuScreen::search(const std::string& words) {
    search_ = words;
    scrollToSelected_ = true;
    const DemoInfo* first = nullptr;
    for (const Chapter& chapter : catalogueByChapter()) {
        for (const DemoInfo* info : chapter.demos) {
            if (!isFound(*info)) continue;
            if (info->name == cards_.selected) return;
            if (!first) first = info;
        }
    }
    if (first) cards_.selected = first->name;
}

// Left and right go through all demos in reading order; up and down to the row above and below.
void MenuScreen::moveSelection(int across, int down) {
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        for (std::size_t column = 0; column < rows_[row].size(); ++column) {
            if (rows_[row][column]->name != cards_.selected) continue;
            auto toRow = static_cast<std::ptrdiff_t>(row) + down;
            auto toColumn = static_cast<std::ptrdiff_t>(column) + across;
            if (toColumn < 0) {
                if (--toRow >= 0) toColumn = std::ssize(rows_[static_cast<std::size_t>(toRow)]) - 1;
            } else if (across > 0 && toColumn >= std::ssize(rows_[row])) {
                ++toRow;
                toColumn = 0;
            }
            if (toRow < 0 || toRow >= std::ssize(rows_)) return;
            const auto& target = rows_[static_cast<std::size_t>(toRow)];
            toColumn = std::min(toColumn, std::ssize(target) - 1);
            cards_.selected = target[static_cast<std::size_t>(toColumn)]->name;
            scrollToSelected_ = true;
            return;
        }
    }
}

void MenuScreen::makeNextPicture() {
    for (const DemoInfo& info : catalogue()) {
        if (cards_.made.count(info.name) != 0) continue;
        Cards::Card& card = cards_.made[info.name];
        try {
            stage_.open(info, info.width, info.height);
            stage_.draw(1);
            const int side = static_cast<int>(std::lround(pictureSide * window_.contentScale()));
            card.picture = Thumbnail(window_, shrink(stage_.picture(), side, side));
        } catch (const std::exception&) {
            card.error = caughtSentence(info.name);
        }
        try {
            stage_.close();
        } catch (const std::exception&) {
            if (card.error.empty()) card.error = caughtSentence(info.name);
        }
        return;
    }
}

void MenuScreen::draw() {
    if (drawnOnce_) makeNextPicture();  // after the first frame, so that the window is not empty meanwhile
    drawnOnce_ = true;
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, window_.size().pixelWidth(), window_.size().pixelHeight());
    const ImVec4 ground = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
    glClearColor(ground.x, ground.y, ground.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);

    gui_.begin();
    const auto width = float(window_.size().width()), height = float(window_.size().height());
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({width, height});
    ImGui::Begin("menu", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoScrollWithMouse);
    std::vector<Message> messages;
    if (!problem_.empty()) messages.push_back({problem_, true});
    const float below = messagesHeight(messages, ImGui::GetContentRegionAvail().x, height * 0.5F);
    ImGui::BeginChild("scroll", {0, below > 0 ? -below - ImGui::GetStyle().ItemSpacing.y : 0}, false,
                      ImGuiWindowFlags_AlwaysVerticalScrollbar);
    showContent();
    ImGui::EndChild();
    if (below > 0) showMessages(messages, below);
    ImGui::End();
    gui_.end();
}

void MenuScreen::showContent() {
    ImGui::PushFont(gui_.titleFont());
    ImGui::TextUnformatted("mvgl");
    ImGui::PopFont();
    wrapped(color::dim,
            "Small OpenGL programs for learning computer graphics. Click one, or choose with the arrow keys "
            "and Enter; letters search; Esc quits.");
    if (!search_.empty()) ImGui::TextColored(color::note, "Search: %s", search_.c_str());
    const float scale = gui_.scale(), side = pictureSide * scale, padding = cardPadding * scale;
    const float spacing = ImGui::GetStyle().ItemSpacing.x * 1.5F;
    const float cardWidth = side + 2 * padding;
    float sentences = 0;
    for (const DemoInfo& info : catalogue()) {
        sentences = std::max(sentences, ImGui::CalcTextSize(info.sentence.c_str(), nullptr, false, side).y);
    }
    const float cardHeight = side + 3 * padding + ImGui::GetTextLineHeightWithSpacing() + sentences;
    const auto columns = static_cast<std::size_t>(
        std::max(1.0F, std::floor((ImGui::GetContentRegionAvail().x + spacing) / (cardWidth + spacing))));

    rows_.clear();
    for (const Chapter& chapter : catalogueByChapter()) {
        if (std::ranges::none_of(chapter.demos, [&](const DemoInfo* info) { return isFound(*info); })) continue;
        ImGui::Dummy({0, padding / 3});
        ImGui::TextColored(color::heading, "%s", chapter.name.c_str());
        rows_.emplace_back();
        for (const DemoInfo* info : chapter.demos) {
            if (!isFound(*info)) continue;
            if (rows_.back().size() == columns) rows_.emplace_back();
            if (!rows_.back().empty()) ImGui::SameLine(0, spacing);
            rows_.back().push_back(info);
            showCard(*info, cardWidth, cardHeight, side);
        }
    }
    if (rows_.empty()) wrapped(color::dim, "No demo has that.");
    scrollToSelected_ = false;
}

void MenuScreen::showCard(const DemoInfo& info, float width, float height, float side) {
    const float padding = cardPadding * gui_.scale();
    const bool selected = info.name == cards_.selected;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high{low.x + width, low.y + height};
    if (ImGui::InvisibleButton(info.name.c_str(), {width, height})) open(info);
    notePlace(info.name);
    const bool hovered = ImGui::IsItemHovered();
    if (selected && scrollToSelected_) ImGui::SetScrollHereY(0.5F);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = 2 * ImGui::GetStyle().FrameRounding;
    list.AddRectFilled(low, high, ImGui::GetColorU32(hovered ? ImGuiCol_HeaderHovered : ImGuiCol_Header), rounding);
    if (selected) list.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_CheckMark), rounding, 0, 2 * gui_.scale());

    const ImVec2 frame{low.x + padding, low.y + padding};
    const auto card = cards_.made.find(info.name);
    if (card != cards_.made.end() && card->second.error.empty()) {
        const Thumbnail& picture = card->second.picture;
        const auto units = static_cast<float>(1 / window_.size().pixelsPerUnit());
        const ImVec2 size{float(picture.width()) * units, float(picture.height()) * units};
        const ImVec2 at{frame.x + std::round((side - size.x) / 2), frame.y + std::round((side - size.y) / 2)};
        list.AddImage(picture.imguiId(), at, {at.x + size.x, at.y + size.y});
    } else {
        list.AddRectFilled(frame, {frame.x + side, frame.y + side}, ImGui::GetColorU32(ImGuiCol_FrameBg));
        if (card != cards_.made.end()) {
            const ImVec4 clip{frame.x, frame.y, frame.x + side, frame.y + side};
            list.AddText(nullptr, 0, {frame.x + padding / 2, frame.y + padding / 2}, ImGui::GetColorU32(color::error),
                         card->second.error.c_str(), nullptr, side - padding, &clip);
            tooltip(card->second.error);
        }
    }
    const float textTop = frame.y + side + padding * 0.75F;
    list.AddText({frame.x, textTop}, ImGui::GetColorU32(ImGuiCol_Text), info.name.c_str());
    list.AddText(nullptr, 0, {frame.x, textTop + ImGui::GetTextLineHeightWithSpacing()}, ImGui::GetColorU32(color::dim),
                 info.sentence.c_str(), nullptr, side);
}

void MenuScreen::report(const WindowState& state) {
    if (report_ == ReportForm::none) return;
    if (report_ == ReportForm::text) {
        printReport("menu, " + cards_.selected + " is chosen\n" +
                    (problem_.empty() ? "" : "error     " + problem_ + "\n") + windowText(state));
        return;
    }
    nlohmann::ordered_json json;
    json["menu"] = cards_.selected;
    json["search"] = search_;
    if (!problem_.empty()) json["error"] = problem_;
    json["window"] = windowJson(state);
    json["places"] = placesJson(gui_.places());
    printReport(json.dump(2) + "\n");
}

}  // namespace mv
