// The chapters that demos stand under. Lists of demos, in pages, menu and --list, have them in this order.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "mv/demo/demo.h"

namespace mv {

// The course's chapters, in its order.
inline constexpr std::array<Literal, 7> courseChapters{
    "Viewing and projection",       "Stereo and hidden surfaces", "Shadows", "Motion", "Light, colour and texture",
    "Surfaces, mirrors and stages", "Rays, clipping and pixels",
};

// The place of the demo's chapter among them, from 0; after the last for "", which a demo has that is none of the course's.
// Error: another name; it says which there are.
std::size_t chapterPlace(const DemoInfo& info);

// Demos that stand under one heading, in the order of their numbers.
struct Chapter {
    std::string name;  // "Others" for demos of no chapter
    std::vector<const DemoInfo*> demos;
};

// All demos linked into this program; no chapter is without one.
std::vector<Chapter> catalogueByChapter();

}  // namespace mv
