#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "experiments/commands/commands.h"
#include "slam/base/error.h"

namespace {

/// CLI11 only says that a command is required.
void RequireKnownCommand(const CLI::App& app, const std::string& name) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == name) return;
    names.push_back(command->get_name());
  }
  throw CLI::ExtrasError(
      fmt::format("there is no command '{}'; there are {}", name, fmt::join(names, ", ")),
      CLI::ExitCodes::ExtrasError);
}

/// What is printed is a result too: on a full disk it must not end as a success.
void FlushOutput() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    ariadne::Fail("the output could not be written: {}", std::strerror(errno));
  }
}

int Main(int argc, char** argv) {
  CLI::App app("ariadne: 3D scans of a stop-and-go robot into one consistent map");
  app.require_subcommand(1);
  app.set_help_all_flag("--help-all", "Help of all commands");
  app.footer(
      "Example:\n  ariadne explore --out results/first\n  ariadne register scans/ --out "
      "results/second\n\nariadne COMMAND --help tells more.");
  int status = 0;
  ariadne::experiments::AddExploreCommand(app, status);
  ariadne::experiments::AddRegisterCommand(app, status);
  ariadne::experiments::AddOptimizeCommand(app, status);
  ariadne::experiments::AddRunCommand(app, status);
  ariadne::experiments::AddEmulateCommand(app);
  ariadne::experiments::AddConvertCommand(app);
  ariadne::experiments::AddInfoCommand(app);
  ariadne::experiments::AddConfigCommand(app);
  ariadne::experiments::AddSimulateCommand(app);
  ariadne::experiments::AddExtractCommand(app);
  ariadne::experiments::AddMapCommand(app);
  ariadne::experiments::AddPlanCommand(app);
  ariadne::experiments::AddExportCommand(app);
  ariadne::experiments::AddViewCommand(app);
  ariadne::experiments::AddDevicesCommand(app, status);
  ariadne::experiments::AddLogCommand(app);
  ariadne::experiments::AddReplayCommand(app, status);
  ariadne::experiments::AddCalibrateCommand(app);
  ariadne::experiments::AddCheckCommand(app, status);
  try {
    if (argc > 1 && argv[1][0] != '-') RequireKnownCommand(app, argv[1]);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    status = app.exit(e) == 0 ? 0 : 2;
  }
  FlushOutput();
  return status;
}

/// Where the terminal is gone nobody hears it, which is no reason to abort.
void Complain(const char* sentence) {
  for (const char* part : {"ariadne: ", sentence, "\n"}) std::fputs(part, stderr);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Main(argc, argv);
  } catch (const std::bad_alloc&) {
    Complain("not enough memory");
  } catch (const std::exception& e) {
    Complain(e.what());
  }
  return 1;
}
