#include "mv/demo/chapters.h"

#include <algorithm>

#include "mv/error.h"

namespace mv {

std::size_t chapterPlace(const DemoInfo& info) {
    if (info.chapter.empty()) return courseChapters.size();
    const auto place = std::find(courseChapters.begin(), courseChapters.end(), info.chapter);
    if (place == courseChapters.end()) {
        std::string names;
        for (const std::string_view name : courseChapters) {
            names.append(names.empty() ? "'" : ", '").append(name).append("'");
        }
        throw Error("demo " + info.name, "must have no chapter or one of mv/demo/chapters.h (" + names + ")",
                    "'" + info.chapter + "'");
    }
    return static_cast<std::size_t>(place - courseChapters.begin());
}

std::vector<Chapter> catalogueByChapter() {
    std::vector<Chapter> chapters;
    for (const DemoInfo& info : catalogue()) {
        const std::string name = info.chapter.empty() ? "Others" : info.chapter;
        if (chapters.empty() || chapters.back().name != name) chapters.push_back({name, {}});
        chapters.back().demos.push_back(&info);
    }
    return chapters;
}

}  // namespace mv
