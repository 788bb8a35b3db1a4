// A film of pictures, made by ffmpeg.
#pragma once
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "mv/image/file.h"
#include "mv/image/picture.h"
#include "mv/run/converter.h"

namespace mv {

class Film {
  public:
    // Starts ffmpeg, which makes the film, mp4, webm or gif as its name ends, of pictures of that size, 60 a second. It is given
    // up if it neither takes any of a picture nor writes anything for as long as `patience`. Error: there is no ffmpeg; the file may
    // not be written.
    Film(const std::string& file, int width, int height, std::chrono::milliseconds patience = std::chrono::seconds(30));

    // Both: Error: ffmpeg has failed, or was given up.
    void add(const Picture& picture);
    // Puts the whole film in the place of the file.
    void finish();

  private:
    [[noreturn]] void refuse() const;

    std::string file_;
    ScratchFolder scratch_;
    std::filesystem::path made_;
    std::optional<Converter> ffmpeg_;
};

}  // namespace mv
