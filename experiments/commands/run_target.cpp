#include "experiments/commands/run_target.h"

namespace ariadne::experiments {

RunDirectory::Existing RunTarget::existing() const {
  if (resume) return RunDirectory::Existing::kResume;
  return overwrite ? RunDirectory::Existing::kOverwrite : RunDirectory::Existing::kRefuse;
}

void AddRunFlags(CLI::App& command, RunTarget& target) {
  auto* overwrite =
      command.add_flag("--overwrite", target.overwrite, "Replace a run that the directory holds");
  command.add_flag("--resume", target.resume, "Go on with a run that was interrupted")->excludes(overwrite);
  command.add_flag("-q,--quiet", target.quiet, "No progress on stderr");
}

void AddSetFlag(CLI::App& command, std::vector<std::string>& assignments) {
  command
      .add_option("--set", assignments, "Set an option: key=value (ariadne config --describe lists them)")
      ->allow_extra_args(false);
}

}  // namespace ariadne::experiments
