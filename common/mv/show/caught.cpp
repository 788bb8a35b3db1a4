#include "mv/show/caught.h"

#include <algorithm>
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

std::vector<std::string> knobsNamed(const std::string& refusal, const Demo& demo) {
    std::vector<std::string> names;
    for (auto at = refusal.find("--"); at != std::string::npos; at = refusal.find("--", at + 2)) {
        const auto end =
            std::min(refusal.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-", at), refusal.size());
        const std::string name = refusal.substr(at + 2, end - at - 2);
        const bool isKnob = std::ranges::any_of(demo.knobs(), [&](const Knob* knob) { return knob->name() == name; });
        if (isKnob && std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    return names;
}

std::string inPlainWords(const std::string& refusal, const Demo& demo) {
    const std::vector<std::string> names = knobsNamed(refusal, demo);
    const std::string start = names.empty() ? "" : "--" + names.front() + ": ";
    if (names.empty() || !refusal.starts_with(start)) return refusal;
    const Knob& refused = demo.knob(names.front());
    std::string rule = refusal.substr(start.size()), knobs;
    for (const std::string& name : names) {
        for (auto at = rule.find("--" + name); at != std::string::npos; at = rule.find("--" + name)) rule.erase(at, 2);
        knobs += (knobs.empty() ? "" : " or ") + name;
    }
    // The value at the end is said at the beginning
    const std::string value = refused.text();
    for (const std::string& last : {", " + value, ", '" + value + "'"}) {
        if (rule.ends_with(last)) rule.erase(rule.size() - last.size());
    }
    if (rule.starts_with("must "))
        return refused.name() + " is " + value + (refused.unit().empty() ? "" : " " + refused.unit()) + ", and " +
               rule + ": move " + knobs;
    return refused.name() + ": " + rule + (rule.find(": ") == std::string::npos ? ": move " + knobs : "");
}

}  // namespace mv
