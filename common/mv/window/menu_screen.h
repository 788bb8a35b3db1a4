// The launcher: a picture of every demo to choose from.
#pragma once
#include <map>
#include <string>

#include "mv/run/command_line.h"
#include "mv/show/stage.h"
#include "mv/window/gui.h"
#include "mv/window/screen.h"
#include "mv/window/thumbnail.h"

namespace mv {

// A small picture of each demo, or why there is none; made one a frame, so that the menu is there at once.
struct Cards {
    struct Card {
        Thumbnail picture;
        std::string error;
    };
    std::map<std::string, Card> made;  // by the demo's name
    std::string selected;              // the last one opened or pointed at with the arrow keys
};

class MenuScreen final : public Screen {
  public:
    // `problem`: why the demo that was to be opened is not there; "" for none.
    MenuScreen(Window& window, Gui& gui, Stage& stage, Cards& cards, std::string problem, ReportForm report);

    void handle(const Event& event) override;
    bool advance(double) override { return false; }
    bool moving() const override { return false; }
    bool pending() const override { return cards_.made.size() < catalogue().size(); }
    void draw() override;
    void report(const WindowState& state) override;

  private:
    void makeNextPicture();
    bool isFound(const DemoInfo& info) const;
    void search(const std::string& words);
    void showContent();
    void showCard(const DemoInfo& info, float width, float height, float side);
    void moveSelection(int across, int down);
    void open(const DemoInfo& info);

    Window& window_;
    Gui& gui_;
    Stage& stage_;
    Cards& cards_;
    std::string problem_;
    ReportForm report_;
    // The demos by rows, as they stood in the last frame: what the arrow keys walk over.
    std::vector<std::vector<const DemoInfo*>> rows_;
    std::string search_;  // what was typed: demos that have it are shown
    bool scrollToSelected_ = true;
    bool drawnOnce_ = false;
};

}  // namespace mv
