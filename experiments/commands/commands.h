#pragma once

#include <CLI/CLI.hpp>

namespace ariadne::experiments {

/// Each adds one subcommand. The command's work is done in its callback, which sets the exit status of the
/// program: 0, or 1 where the work ended, but not well (a scan was not registered). Errors are thrown.
void AddRegisterCommand(CLI::App& app, int& status);
void AddOptimizeCommand(CLI::App& app, int& status);
void AddExploreCommand(CLI::App& app, int& status);
void AddRunCommand(CLI::App& app, int& status);
void AddEmulateCommand(CLI::App& app);
void AddConvertCommand(CLI::App& app);
void AddInfoCommand(CLI::App& app);
void AddConfigCommand(CLI::App& app);
void AddSimulateCommand(CLI::App& app);
void AddViewCommand(CLI::App& app);
void AddExtractCommand(CLI::App& app);
void AddMapCommand(CLI::App& app);
void AddPlanCommand(CLI::App& app);
void AddExportCommand(CLI::App& app);
void AddDevicesCommand(CLI::App& app, int& status);
void AddLogCommand(CLI::App& app);
void AddReplayCommand(CLI::App& app, int& status);
void AddCalibrateCommand(CLI::App& app);
void AddCheckCommand(CLI::App& app, int& status);

}  // namespace ariadne::experiments
