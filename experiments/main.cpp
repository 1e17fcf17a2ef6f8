#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "experiments/commands/commands.h"

namespace {

int Main(int argc, char** argv) {
  CLI::App app("ariadne: 3D scans of a stop-and-go robot into one consistent map");
  app.require_subcommand(1);
  app.set_help_all_flag("--help-all", "Help of all commands");
  app.footer(
      "Example:\n  ariadne register scans/ --out results/first\n\nariadne COMMAND --help tells more.");
  int status = 0;
  ariadne::experiments::AddRegisterCommand(app, status);
  ariadne::experiments::AddRunCommand(app, status);
  ariadne::experiments::AddConvertCommand(app);
  ariadne::experiments::AddInfoCommand(app);
  ariadne::experiments::AddConfigCommand(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Main(argc, argv);
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "ariadne: not enough memory\n");
  } catch (const std::exception& e) {
    fmt::print(stderr, "ariadne: {}\n", e.what());
  }
  return 1;
}
