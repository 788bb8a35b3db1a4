#include "mv/demo/own_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "mv/demo/lesson.h"
#include "mv/image/file.h"
#include "mv/image/png.h"
#include "mv/paper/report.h"
#include "mv/run/copyable.h"
#include "support/temporary_folder.h"

using namespace mv;

namespace {

struct Settings {
    int before = 1;
    OwnFile<Picture> picture = {};
};
struct Gpu {};

using Taking = LessonDemo<Settings, Gpu, NothingKept>;

std::unique_ptr<Taking> taking(const Settings& initial = {}) {
    Lesson<Settings, Gpu> lesson;
    lesson.rows = {whole("before", &Settings::before, {0, 2}, "it"),
                   file("picture", &Settings::picture, "assets/postcard.png", "a picture")};
    lesson.check = [](const Settings& s) {
        if (s.before == 2) throw Error("--before", "must not be 2");
    };
    return std::make_unique<Taking>(std::make_shared<const Lesson<Settings, Gpu>>(std::move(lesson)), initial);
}

void choose(Demo& demo, const std::string& name) { demo.knob("picture").parse(name); }
OwnFile<Picture> chosen(const Demo& demo) { return settingsOf<Settings>(demo).picture; }

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

TEST(FileKnob, is_none_at_first_and_any_name_later) {
    const auto made = taking();
    Demo& demo = *made;
    Knob& knob = demo.knob("picture");
    EXPECT_FALSE(chosen(demo).isSet());
    EXPECT_TRUE(knob.isInitial());
    EXPECT_EQ(chosen(demo).version(), 0);
    EXPECT_EQ(refusalOf(demo), "");
    EXPECT_THROW((void)chosen(demo).content(), Error);
    for (const char* name : {"a.png", "with spaces, and commas.jpg", "/a/b/c", "\xC3\xB1.png", "--shot", "'\"\\"}) {
        knob.parse(name);
        EXPECT_EQ(knob.text(), name);
        EXPECT_EQ(chosen(demo).name, name);
        EXPECT_TRUE(chosen(demo).isSet());
        EXPECT_NE(refusalOf(demo), "") << "there is no such file";
    }
    knob.parse("none");
    EXPECT_TRUE(knob.isInitial());
    for (const char* name : {"", "a\nb", "\x1B[31m", "a\x7F"}) EXPECT_THROW(knob.parse(name), Error);
    EXPECT_TRUE(knob.isInitial()) << "what is refused is not taken";
    EXPECT_FALSE(knob.step(1));
    // A preset's
    EXPECT_EQ(taking({.picture = {"of-a-preset.png"}})->knob("picture").text(), "of-a-preset.png");
}

// By the flag, in sentences that end with the remedy; and the last good picture can be had again.
TEST(FileKnob, tells_what_is_wrong_with_a_file) {
    const TemporaryFolder folder;
    const auto made = taking();
    Demo& demo = *made;
    const std::string good = (folder / "good.png").string(), bad = (folder / "bad.png").string();
    writePng(good, filled(3, 200));
    choose(demo, good);
    EXPECT_EQ(refusalOf(demo), "");
    const int version = chosen(demo).version();
    choose(demo, folder.path().string() + "/missing.png");
    EXPECT_EQ(refusalOf(demo),
              "--picture: " + folder.path().string() +
                  "/missing.png: must be a file that exists and may be read, No such file or directory");
    demo.knob("before").parse("2");
    EXPECT_EQ(refusalOf(demo).rfind("--picture: ", 0), 0U) << "before what the lesson refuses";
    writeFileAtomically(bad, "no picture");
    choose(demo, bad);
    EXPECT_EQ(refusalOf(demo).rfind("--picture: " + bad + ": must be a PNG or JPEG file", 0), 0U) << refusalOf(demo);
    const auto whole = encodePng(filled(64, 1));
    writeFileAtomically(bad, std::span(whole).first(whole.size() - 9));
    EXPECT_NE(refusalOf(demo).find("must be an undamaged PNG file"), std::string::npos) << refusalOf(demo);
    writePng(bad, Picture(8193, 1));
    EXPECT_NE(refusalOf(demo).find("sides must lie in 1..8192 pixels; scale it down, 8193 x 1"), std::string::npos)
        << refusalOf(demo);
    choose(demo, folder.path().string());
    EXPECT_NE(refusalOf(demo), "") << "a folder";
    choose(demo, good);
    EXPECT_EQ(refusalOf(demo), "--before: must not be 2");
    EXPECT_EQ(chosen(demo).version(), version) << "it is read once";
    EXPECT_EQ(*chosen(demo).content(), filled(3, 200));
}

// A texture is made anew when there is something new in the file, and only then; two settings that are compared keep theirs.
TEST(FileKnob, reads_what_is_written_anew) {
    const TemporaryFolder folder;
    const std::string one = (folder / "one.png").string(), other = (folder / "other.png").string();
    writePng(one, filled(2, 10));
    writePng(other, filled(2, 20));
    const auto made = taking();
    Demo& demo = *made;
    choose(demo, one);
    const int first = chosen(demo).version();
    choose(demo, other);
    const int second = chosen(demo).version();
    EXPECT_NE(first, second);
    for (int frame = 0; frame < 3; ++frame) {
        choose(demo, one);
        EXPECT_EQ(chosen(demo).version(), first);
        choose(demo, other);
        EXPECT_EQ(chosen(demo).version(), second);
        EXPECT_EQ(*chosen(demo).content(), filled(2, 20));
    }
    const auto kept = chosen(demo).content();
    writePng(other, filled(3, 30));
    EXPECT_NE(chosen(demo).version(), second);
    EXPECT_EQ(*chosen(demo).content(), filled(3, 30));
    EXPECT_EQ(*kept, filled(2, 20)) << "who still has the old one keeps it";
    std::filesystem::remove(other);
    EXPECT_NE(refusalOf(demo), "") << "what is gone is told";
}

// The kinds that a window goes by, where a demo has knobs of two kinds.
TEST(FileKnob, takes_files_of_its_endings) {
    const auto made = taking();
    const Knob& knob = made->knob("picture");
    for (const char* name : {"a.png", "b.JPG", "c.Jpeg", ".png"}) EXPECT_TRUE(knob.takes(name)) << name;
    for (const char* name : {"", "png", "a.png.txt", "a.obj", "png.d/a"}) EXPECT_FALSE(knob.takes(name)) << name;
}

TEST(FileKnob, is_in_what_is_printed_of_a_demo) {
    static const DemoInfo info = [] {
        DemoInfo made;
        made.name = "taking";
        return made;
    }();
    const auto made = taking();
    Demo& demo = *made;
    choose(demo, "my photo's.jpg");
    EXPECT_EQ(copyableCommand("taking", info, demo, 1, 512, 512), "taking --picture 'my photo'\\''s.jpg'");
    const std::string json = knobsJson(info, demo);
    EXPECT_NE(json.find(R"("value": "my photo's.jpg")"), std::string::npos) << json;
    EXPECT_NE(json.find(R"("range": "none or a PNG or JPEG file")"), std::string::npos) << json;
    for (const std::string& text : demo.knob("picture").sweep()) {
        choose(demo, text);
        EXPECT_EQ(demo.knob("picture").text(), text);
        EXPECT_EQ(refusalOf(demo), "") << text << ", from the tree's folder";
    }
}
