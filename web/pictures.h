// The pictures and models that a page has handed over, which stand for files.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace mv {

// Where the pixels of that picture are to be written: red, green, blue, alpha, the upper row first. It replaces one of the same
// name. Error: sides that no picture has.
std::uint8_t* receivePicture(const std::string& name, int width, int height);

// Where the bytes of that text are to be written. It replaces one of the same name.
char* receiveText(const std::string& name, std::size_t bytes);

// The text that has come under that name. Error: none has.
const std::string& givenText(const std::filesystem::path& path);

}  // namespace mv
