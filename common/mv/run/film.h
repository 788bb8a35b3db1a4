// A film of pictures, made by ffmpeg.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "mv/image/file.h"
#include "mv/image/picture.h"

namespace mv {

class Film {
  public:
    // Starts ffmpeg, which makes the film, mp4, webm or gif as its name ends, of pictures of that size, 60 a second. It is given
    // up if it neither takes any of a picture nor writes anything for as long as `patience`. Error: there is no ffmpeg; the file may
    // not be written.
    Film(const std::string& file, int width, int height, std::chrono::milliseconds patience = std::chrono::seconds(30));
    // Ends ffmpeg where it still runs. Should this process end without a destructor, the system does.
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    // Both: Error: ffmpeg has failed, or was given up.
    void add(const Picture& picture);
    // Puts the whole film in the place of the file.
    void finish();

  private:
    void start(std::vector<std::string> words);
    void requireProgress();
    [[noreturn]] void refuse() const;

    std::string file_;
    ScratchFolder scratch_;
    std::filesystem::path made_;
    std::chrono::milliseconds patience_;
    std::chrono::steady_clock::time_point lastMove_;
    std::uintmax_t lastSize_ = 0;
    int pipe_ = -1;
    pid_t process_ = -1;
};

}  // namespace mv
