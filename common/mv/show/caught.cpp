#include "mv/show/caught.h"

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "mv/error.h"

namespace mv {
namespace {

Error needsMemory(const std::string& subject) {
    return Error(subject, "needs more memory than there is; a smaller --size needs less");
}
Error needsSystem(const std::string& subject, const std::system_error& error) {
    return Error(subject, "needs what the system does not give", error.code().message());
}

}  // namespace

// Thrown again, it is told by its own catch clause, which needs no types at run time: the browser's module has none.
std::string caughtSentence(const std::string& subject) {
    try {
        throw;
    } catch (const Error& error) {
        return error.what();
    } catch (const std::filesystem::filesystem_error& error) {
        if (error.path1().empty()) return needsSystem(subject, error).what();
        return Error(error.path1().string(), "must be there and may be used", error.code().message()).what();
    } catch (const std::system_error& error) {
        return needsSystem(subject, error).what();
    } catch (const std::bad_alloc&) {
        return needsMemory(subject).what();
    } catch (const std::length_error&) {
        return needsMemory(subject).what();
    } catch (const std::exception&) {
        return Error(subject, "met a fault of its own, which ended it; please report the command line").what();
    }
}

}  // namespace mv
