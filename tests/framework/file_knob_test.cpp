#include "mv/demo/file_knob.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "mv/demo/demo.h"
#include "mv/image/file.h"
#include "mv/image/png.h"
#include "mv/paper/report.h"
#include "mv/run/copyable.h"
#include "support/temporary_folder.h"

using namespace mv;

namespace {

struct Taking : Demo {
    PictureFile picture{this, "picture", "assets/postcard.png", "a picture"};
    void init() override {}
    void draw(const Frame&) override {}
    void check() const override { picture.check(); }
};

Picture filled(int side, std::uint8_t level) {
    Picture picture(side, side);
    for (std::uint8_t& byte : picture.rgba) byte = level;
    return picture;
}

std::string refusalOf(const Demo& demo) {
    try {
        demo.check();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(PictureFile, is_none_at_first_and_any_name_later) {
    Taking demo;
    EXPECT_FALSE(demo.picture.isSet());
    EXPECT_TRUE(demo.picture.isInitial());
    EXPECT_EQ(demo.picture.version(), 0);
    EXPECT_EQ(refusalOf(demo), "");
    EXPECT_THROW((void)demo.picture.picture(), Error);
    for (const char* name : {"a.png", "with spaces, and commas.jpg", "/a/b/c", "\xC3\xB1.png", "--shot", "'\"\\"}) {
        demo.picture.parse(name);
        EXPECT_EQ(demo.picture.text(), name);
        EXPECT_TRUE(demo.picture.isSet());
        EXPECT_NE(refusalOf(demo), "") << "there is no such file";
    }
    demo.picture.parse("none");
    EXPECT_TRUE(demo.picture.isInitial());
    for (const char* name : {"", "a\nb", "\x1B[31m", "a\x7F"}) EXPECT_THROW(demo.picture.parse(name), Error);
    EXPECT_TRUE(demo.picture.isInitial()) << "what is refused is not taken";
    EXPECT_FALSE(demo.picture.step(1));
}

// By the flag, in sentences that end with the remedy; and the last good picture can be had again.
TEST(PictureFile, tells_what_is_wrong_with_a_file) {
    const TemporaryFolder folder;
    Taking demo;
    const std::string good = (folder / "good.png").string(), bad = (folder / "bad.png").string();
    writePng(good, filled(3, 200));
    demo.picture.parse(good);
    EXPECT_EQ(refusalOf(demo), "");
    const int version = demo.picture.version();
    demo.picture.parse(folder.path().string() + "/missing.png");
    EXPECT_EQ(refusalOf(demo),
              "--picture: " + folder.path().string() +
                  "/missing.png: must be a file that exists and may be read, No such file or directory");
    writeFileAtomically(bad, "no picture");
    demo.picture.parse(bad);
    EXPECT_EQ(refusalOf(demo).rfind("--picture: " + bad + ": must be a PNG or JPEG file", 0), 0U) << refusalOf(demo);
    const auto whole = encodePng(filled(64, 1));
    writeFileAtomically(bad, std::span(whole).first(whole.size() - 9));
    EXPECT_NE(refusalOf(demo).find("must be an undamaged PNG file"), std::string::npos) << refusalOf(demo);
    writePng(bad, Picture(8193, 1));
    EXPECT_NE(refusalOf(demo).find("sides must lie in 1..8192 pixels; scale it down, 8193 x 1"), std::string::npos)
        << refusalOf(demo);
    demo.picture.parse(folder.path().string());
    EXPECT_NE(refusalOf(demo), "") << "a folder";
    demo.picture.parse(good);
    EXPECT_EQ(refusalOf(demo), "");
    EXPECT_EQ(demo.picture.version(), version) << "it is read once";
    EXPECT_EQ(demo.picture.picture(), filled(3, 200));
}

// A texture is made anew when there is something new in the file, and only then; two settings that are compared keep theirs.
TEST(PictureFile, reads_what_is_written_anew) {
    const TemporaryFolder folder;
    const std::string one = (folder / "one.png").string(), other = (folder / "other.png").string();
    writePng(one, filled(2, 10));
    writePng(other, filled(2, 20));
    Taking demo;
    demo.picture.parse(one);
    const int first = demo.picture.version();
    demo.picture.parse(other);
    const int second = demo.picture.version();
    EXPECT_NE(first, second);
    for (int frame = 0; frame < 3; ++frame) {
        demo.picture.parse(one);
        EXPECT_EQ(demo.picture.version(), first);
        demo.picture.parse(other);
        EXPECT_EQ(demo.picture.version(), second);
        EXPECT_EQ(demo.picture.picture(), filled(2, 20));
    }
    writePng(other, filled(3, 30));
    EXPECT_NE(demo.picture.version(), second);
    EXPECT_EQ(demo.picture.picture(), filled(3, 30));
    std::filesystem::remove(other);
    EXPECT_NE(refusalOf(demo), "") << "what is gone is told";
}

TEST(PictureFile, is_noted_as_read_by_every_way_to_it) {
    Taking demo;
    const auto notes = [&](const auto& read) {
        demo.picture.forgetRead();
        read();
        return demo.picture.wasRead();
    };
    EXPECT_TRUE(notes([&] { (void)demo.picture.isSet(); }));
    EXPECT_TRUE(notes([&] { (void)demo.picture.text(); }));
    EXPECT_TRUE(notes([&] { (void)demo.picture.version(); }));
    EXPECT_TRUE(notes([&] { demo.picture.check(); }));
    EXPECT_FALSE(notes([&] { demo.picture.parse("x.png"); }));
}

TEST(PictureFile, is_in_what_is_printed_of_a_demo) {
    static const DemoInfo info = [] {
        DemoInfo made;
        made.name = "taking";
        return made;
    }();
    Taking demo;
    demo.picture.parse("my photo's.jpg");
    EXPECT_EQ(copyableCommand("taking", info, demo, 1, 512, 512), "taking --picture 'my photo'\\''s.jpg'");
    const std::string json = knobsJson(info, demo);
    EXPECT_NE(json.find(R"("value": "my photo's.jpg")"), std::string::npos) << json;
    EXPECT_NE(json.find(R"("range": "none or a PNG or JPEG file")"), std::string::npos) << json;
    for (const std::string& text : demo.picture.sweep()) {
        demo.picture.parse(text);
        EXPECT_EQ(demo.picture.text(), text);
        EXPECT_EQ(refusalOf(demo), "") << text << ", from the tree's folder";
    }
}
