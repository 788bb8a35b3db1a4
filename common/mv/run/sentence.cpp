#include "mv/run/sentence.h"

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "mv/error.h"

namespace mv {

std::string sentenceOf(const std::exception& error, const std::string& subject) {
    if (const auto* ours = dynamic_cast<const Error*>(&error)) return ours->what();
    const auto* file = dynamic_cast<const std::filesystem::filesystem_error*>(&error);
    if (file && !file->path1().empty()) {
        return Error(file->path1().string(), "must be there and may be used", file->code().message()).what();
    }
    if (const auto* system = dynamic_cast<const std::system_error*>(&error)) {
        return Error(subject, "needs what the system does not give", system->code().message()).what();
    }
    if (dynamic_cast<const std::bad_alloc*>(&error) || dynamic_cast<const std::length_error*>(&error)) {
        return Error(subject, "needs more memory than there is; a smaller --size needs less").what();
    }
    return Error(subject, "met a fault of its own, which ended it; please report the command line").what();
}

}  // namespace mv
