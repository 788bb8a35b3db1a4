#include "mv/run/film.h"

#include <span>
#include <utility>

#include "mv/error.h"

namespace mv {

Film::Film(const std::string& file, int width, int height, std::chrono::milliseconds patience)
    : file_(file), scratch_("movie") {
    if (!isInPath("ffmpeg")) {
        throw Error("--movie",
                    "needs ffmpeg, which is not installed (sudo apt install ffmpeg); --shot a.%04d.png writes "
                    "the pictures without");
    }
    requireWritable(file);
    const std::string extension = std::filesystem::path(file).extension().string();
    made_ = scratch_.path() / ("movie" + extension);
    std::vector<std::string> words{"ffmpeg", "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgba", "-s"};
    words.push_back(std::to_string(width) + "x" + std::to_string(height));
    for (const char* word : {"-r", "60", "-i", "-", "-vf"}) words.emplace_back(word);
    // Video has half as many colours as pixels a side, and so even sides, and says by which matrix its colours are made, which players
    // guess else; a GIF has a palette of its own
    if (extension == ".gif") {
        words.emplace_back("fps=30,split[a][b];[a]palettegen[p];[b][p]paletteuse");
    } else {
        for (const char* word :
             {"pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv", "-pix_fmt", "yuv420p",
              "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"})
            words.emplace_back(word);
    }
    words.push_back(made_.string());
    ffmpeg_.emplace("--movie", std::move(words), made_, patience);
}

void Film::add(const Picture& picture) {
    if (!ffmpeg_->give(std::as_bytes(std::span(picture.rgba)))) refuse();
}

void Film::finish() {
    if (!ffmpeg_->finish()) refuse();
    constexpr std::size_t mostBytes = std::size_t{4} << 30U;
    writeFileAtomically(file_, readFile(made_, mostBytes));
}

void Film::refuse() const { throw Error(file_, "must be a film that this ffmpeg can make; it says why above"); }

}  // namespace mv
