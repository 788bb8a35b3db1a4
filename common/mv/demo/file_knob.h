// A knob that is a file of the user's own: by its flag, dropped onto the window, chosen in the page.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mv/demo/knob.h"
#include "mv/demo/own_file.h"

namespace mv {

// The knob of a row `file`: what an OwnFile says of its setting holds for it.
class FileKnob : public Knob {
  public:
    // `sample` is a file of the tree, which the tests set it to.
    FileKnob(Demo* owner, Literal name, const FileKind& kind, Literal sample, Literal help)
        : Knob(owner, name, help, ""), kind_(kind), sample_(sample) {}

    // Error, with the flag before it: one is set, and is missing or of another kind.
    void check() const;
    // Whether a file of this name is of the knob's kind, by its ending alone.
    bool takes(std::string_view file) const;
    // The endings of the kind's names, as a page's field lists them: ".png,.jpg,.jpeg".
    std::string endings() const;

    std::string text() const override {
        noteRead();
        return file_;
    }
    // Error: no name, or one with control characters.
    void parse(std::string_view text) override;
    std::string initialText() const override { return none; }
    std::string range() const override { return kind_.range; }
    std::vector<std::string> sweep() const override { return {none, sample_}; }
    bool step(double) override { return false; }  // there is no next file
    bool widget(Panel& panel) override { return panel.file(*this); }

  private:
    static constexpr const char* none = "none";

    const FileKind& kind_;
    Literal sample_;
    std::string file_ = none;
};

}  // namespace mv
