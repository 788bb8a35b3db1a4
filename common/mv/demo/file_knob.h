// A knob that is a picture file of the user's own: by its flag, dropped onto the window, chosen in the page.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mv/demo/knob.h"
#include "mv/image/picture.h"

namespace mv {

// At first "none". The value is the file's name alone: what is in it is read when it is asked for, so that a file that is not
// there, or is no picture, is told where the demo checks its settings, and the window keeps its last picture:
//     PictureFile picture{this, "picture", "assets/postcard.png", "a picture of yours on the surface"};
//     void check() const override { picture.check(); }
//     if (imageFor.changed(picture.version())) image = picture.isSet() ? Texture(picture.picture()) : ...;
class PictureFile final : public Knob {
  public:
    static constexpr std::string_view none = "none";

    // `sample` is a file of the tree, which the tests set it to.
    PictureFile(Demo* owner, Literal name, Literal sample, Literal help);

    bool isSet() const {
        noteRead();
        return file_ != none;
    }
    // The picture in the file as it is now, as loadPicture reads it. It holds until the knob has been asked for two other ones.
    // Error: none is set; as loadPicture, with the flag before it.
    const Picture& picture() const;
    // Another number for each picture that was read; 0 where none is set. Error: as picture().
    int version() const;
    // Error: one is set, and picture() refuses it.
    void check() const;

    std::string text() const override {
        noteRead();
        return file_;
    }
    // Error: no name, or one with control characters.
    void parse(std::string_view text) override;
    std::string initialText() const override { return std::string(none); }
    std::string range() const override { return "none or a PNG or JPEG file"; }
    std::vector<std::string> sweep() const override { return {std::string(none), sample_}; }
    bool step(double) override { return false; }  // there is no next file
    bool widget(Panel& panel) override { return panel.file(*this); }

  private:
    // A picture that was read, and of which file.
    struct Read {
        std::string file, stamp;
        std::shared_ptr<const Picture> picture;
        int version;
    };
    const Read& read() const;

    std::string file_{none};
    Literal sample_;
    mutable std::vector<Read> reads_;  // the last two: a window draws two settings that are compared in turn
};

}  // namespace mv
