// The programs of a folder of shaders that share their files.
#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mv/gl/program.h"

namespace mv {

// A member of a lesson's Gpu: `Programs programs{"gpu-stages"};` and later
//     const Program& program = gpu.programs.of({"patch.vert", "patch.tesc", "patch.tese", "lit.frag"});
class Programs {
  public:
    explicit Programs(std::string folder) : folder_(std::move(folder)) {}

    // The program of these files of shaders/<folder>/, one a stage, made when it is first asked for, with a context that is
    // current. It is called by its files. Error: as Program::fromFiles.
    const Program& of(const std::vector<std::string>& files) {
        const auto known = programs_.find(files);
        if (known != programs_.end()) return known->second;
        std::string name;
        std::vector<std::string> paths;
        for (const std::string& file : files) {
            name += (name.empty() ? "" : " ") + file;
            paths.push_back(folder_ + "/" + file);
        }
        return programs_.emplace(files, Program::fromFiles(name, paths)).first->second;
    }

  private:
    std::string folder_;
    std::map<std::vector<std::string>, Program> programs_;
};

}  // namespace mv
