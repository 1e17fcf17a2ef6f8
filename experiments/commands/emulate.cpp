#include "experiments/studies/emulate.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"
#include "slam/io/file.h"
#include "slam/io/trajectory.h"

namespace ariadne::experiments {
namespace {

volatile std::sig_atomic_t end_requested = 0;

extern "C" void RequestEnd(int) { end_requested = 1; }

struct EmulateArguments {
  std::string world;
  std::vector<std::string> assignments;
  std::vector<std::string> faults;
  std::string ports;
  std::string truth;
};

void PrintPorts(const EmulatedPorts& ports, const std::string& file) {
  const std::string names =
      fmt::format("scanner {}\nservo {}\nmotors {}\n", ports.scanner, ports.servo, ports.motors);
  if (!file.empty()) slam::WriteFileAtomically(file, [&names](std::ostream& out) { out << names; });
  fmt::print("{}", names);
  fmt::print(
      "In another terminal:\n  ariadne explore --set robot=hardware --set hardware.scanner.port={} --set "
      "hardware.servo.port={} --set hardware.motors.port={} --out results/emulated\nCtrl-C ends.\n",
      ports.scanner, ports.servo, ports.motors);
  std::fflush(stdout);
}

/// Where the base truly was, by the clock of the devices [s].
void WriteTruth(const std::vector<drivers::TruePose>& way_world, const std::string& file) {
  std::vector<slam::StampedPose> poses;
  for (const drivers::TruePose& true_pose : way_world)
    poses.push_back({true_pose.time, slam::ToPose3(true_pose.T_map_base)});
  slam::WriteFileAtomically(file, [&poses](std::ostream& out) { slam::WriteTum(out, poses); });
}

void EmulateUntilStopped(const EmulateArguments& arguments) {
  OptionEntries entries;
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  std::vector<EmulatedFault> faults;
  for (const std::string& fault : arguments.faults) faults.push_back(ParseEmulatedFault(fault));
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, RequestEnd);
  const auto on_ready = [&arguments](const EmulatedPorts& ports) { PrintPorts(ports, arguments.ports); };
  const EmulationEnd end = Emulate(arguments.world, ReadOptions<EmulateOptions>(entries), faults, on_ready,
                                   [](double) { return end_requested == 0; });
  const slam::Pose2& at = end.T_world_base;
  fmt::print(
      "after {:.0f} s: {:.2f} m driven, {} contacts; the robot stands at ({:.3f}, {:.3f}) m, {:.3f} rad\n",
      end.time, end.path, end.collisions, at.translation.x(), at.translation.y(), at.angle);
  if (!arguments.truth.empty()) WriteTruth(end.way_world, arguments.truth);
}

}  // namespace

void AddEmulateCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "emulate", "Emulate the devices of a robot in a world, on three pseudo-terminals, in real time");
  auto arguments = std::make_shared<EmulateArguments>();
  command
      ->add_option("world", arguments->world,
                   "builtin:NAME, a floor plan (.json), a description (.yaml) or a mesh")
      ->required();
  AddSetFlag(*command, arguments->assignments);
  command->add_option("--fault", arguments->faults,
                      "DEVICE:KIND:TIME[:AMOUNT], see below; any number of times");
  command->add_option("--ports", arguments->ports, "File to which the names of the ports are written too");
  command->add_option("--truth", arguments->truth,
                      "File for where the robot truly was, in TUM form, when it ends");
  command->footer(
      "Example:\n"
      "  ariadne emulate builtin:robobench\n"
      "  ariadne emulate builtin:robobench --fault scanner:power:30:3 --fault left:slip:60:2\n"
      "Faults: DEVICE is scanner, servo or motors; KIND is drop, flip or duplicate (AMOUNT bytes), delay,\n"
      "dead or power (AMOUNT seconds); or servo:stuck:TIME:SECONDS, or left:slip:TIME:SECONDS, or right.\n"
      "It prints the ports, and how `ariadne explore` drives the robot on them; Ctrl-C ends it.");
  command->callback([arguments] { EmulateUntilStopped(*arguments); });
}

}  // namespace ariadne::experiments
