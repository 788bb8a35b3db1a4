// Whether a demo passes: what its shader says.
#pragma once
#include <map>
#include <string>

inline std::map<std::string, std::string>& verdicts() {
    static std::map<std::string, std::string> all;
    return all;
}
