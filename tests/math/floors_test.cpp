// The library's floors look down only: a file of one floor includes its own floor's files and those of the floors below it.
// Code that opens windows and contexts stays on the floor that is made for it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#ifndef MVGL_SOURCE_DIR
#error "define MVGL_SOURCE_DIR as the root of the source tree"
#endif

namespace {

// From the ground up. A row's floors stand beside each other: neither includes the other.
const std::vector<std::vector<std::string>> storeys = {
    {"math"}, {"geometry", "image", "motion"}, {"demo"}, {"gl"}, {"host"}, {"show"}, {"run"}, {"window"}};

// The highest floor that a demo includes: it draws, and asks for neither a host nor a command line.
const std::string highestForDemos = "gl";

// A room of a floor has a folder of its own, and its files and the floor's include each other.
const std::map<std::string, std::string> rooms = {{"paper", "run"}, {"study", "run"}};
std::string floorOfRoom(const std::string& folder) { return rooms.contains(folder) ? rooms.at(folder) : folder; }

// The number of the storey that `folder` is on, from 0; -1 for no floor.
int storeyOf(const std::string& folder) {
    const std::string floor = floorOfRoom(folder);
    for (int i = 0; i < static_cast<int>(storeys.size()); ++i) {
        if (std::ranges::count(storeys[static_cast<size_t>(i)], floor)) return i;
    }
    return -1;
}

// The mistake of the line `line` of a file on `floor`, "demos" for a demo; empty where nothing is.
std::string wrongInclude(const std::string& floor, const std::string& line) {
    if (line.find("include") == std::string::npos) return "";  // most lines: a pattern takes long to say so
    std::smatch match;
    static const std::regex ours(R"(^\s*#\s*include\s*"mv/([a-z_]+)/)");
    static const std::regex lessons(R"(^\s*#\s*include\s*"shared/)");
    static const std::regex windows(R"(^\s*#\s*include\s*[<"](GLFW/|imgui))");
    static const std::regex contexts(R"(^\s*#\s*include\s*[<"](EGL/|GL/osmesa))");
    if (std::regex_search(line, lessons) && floor != "demos") return "the library knows nothing that only lessons use";
    if (std::regex_search(line, windows) && floor != "window") return "only mv/window knows GLFW and Dear ImGui";
    if (std::regex_search(line, contexts) && floor != "host") return "only mv/host knows EGL and OSMesa";
    if (!std::regex_search(line, match, ours) || floorOfRoom(match[1]) == floorOfRoom(floor)) return "";
    const int below = storeyOf(match[1]);
    if (below < 0) return "there is no such floor";
    if (floor == "demos") return below <= storeyOf(highestForDemos) ? "" : "a demo includes no floor above mv/gl";
    return below < storeyOf(floor) ? "" : "the arrow does not point down";
}

// Checks each file of ours in `folder`; `floorOf` gives the floor that one is on. Returns how many there are.
template <typename FloorOf>
int checkFolder(const std::filesystem::path& folder, FloorOf floorOf) {
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension();
        if (extension != ".h" && extension != ".cpp" && extension != ".inc") continue;
        ++files;
        const std::string floor = floorOf(std::filesystem::relative(entry.path(), folder));
        std::ifstream file(entry.path());
        EXPECT_TRUE(file) << entry.path();
        std::string line;
        for (int number = 1; std::getline(file, line); ++number) {
            const std::string wrong = wrongInclude(floor, line);
            EXPECT_EQ(wrong, "") << entry.path() << ":" << number << ": " << line;
        }
    }
    return files;
}

TEST(Floors, LookDownOnly) {
    const auto floorOf = [](const std::filesystem::path& file) { return file.begin()->string(); };
    EXPECT_GE(checkFolder(MVGL_SOURCE_DIR "/common/mv", floorOf), 100);  // an empty or wrong folder is no success
}

TEST(Floors, EachFolderIsOne) {
    for (const auto& entry : std::filesystem::directory_iterator(MVGL_SOURCE_DIR "/common/mv")) {
        if (!entry.is_directory()) continue;
        EXPECT_GE(storeyOf(entry.path().filename()), 0) << entry.path();
    }
}

TEST(Floors, DemosIncludeNothingAboveGl) {
    const auto floorOf = [](const std::filesystem::path&) { return std::string("demos"); };
    EXPECT_GE(checkFolder(MVGL_SOURCE_DIR "/demos", floorOf), 17);
}

TEST(Floors, TheSearchFindsWhatItLooksFor) {
    EXPECT_NE(wrongInclude("host", "#include \"mv/show/stage.h\""), "");
    EXPECT_NE(wrongInclude("geometry", "#include \"mv/image/picture.h\""), "");  // beside, not below
    EXPECT_NE(wrongInclude("run", " # include \"mv/window/gui.h\""), "");
    EXPECT_NE(wrongInclude("run", "#include <GLFW/glfw3.h>"), "");
    EXPECT_NE(wrongInclude("gl", "#include <EGL/egl.h>"), "");
    EXPECT_NE(wrongInclude("demos", "#include \"mv/host/context.h\""), "");
    EXPECT_NE(wrongInclude("run", "#include \"mv/cellar/wine.h\""), "");
    EXPECT_NE(wrongInclude("gl", "#include \"shared/plates.h\""), "");
    EXPECT_EQ(wrongInclude("demos", "#include \"shared/plates.h\""), "");
    EXPECT_EQ(wrongInclude("gl", "#include \"mv/gl/gl.h\""), "");
    EXPECT_EQ(wrongInclude("gl", "#include \"mv/error.h\""), "");
    EXPECT_EQ(wrongInclude("window", "#include \"mv/show/stage.h\""), "");
    EXPECT_EQ(wrongInclude("demos", "#include \"mv/gl/gl.h\""), "");
    EXPECT_EQ(wrongInclude("math", "// #include \"mv/gl/gl.h\""), "");
}

}  // namespace
