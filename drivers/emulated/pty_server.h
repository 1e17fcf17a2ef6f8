#pragma once

#include <memory>
#include <stop_token>
#include <string>

#include "drivers/emulated/emulated_device.h"

namespace ariadne::drivers {

/// A pseudo-terminal behind which an emulated device sits, so that any program can talk to it as over a
/// serial port. The rate of the device's end is what the program sets, as a line would have it. Time is the
/// system's monotonic clock, from when the server was made.
class PtyServer {
 public:
  /// The device must outlive the server.
  explicit PtyServer(EmulatedDevice& device);
  ~PtyServer();
  PtyServer(const PtyServer&) = delete;
  PtyServer& operator=(const PtyServer&) = delete;

  /// What the program opens, for example /dev/pts/5.
  const std::string& path() const { return path_; }

  /// Serves until it is told to stop, within `poll` [s].
  void Serve(const std::stop_token& stop, double poll = 0.02);

  double Now() const;

 private:
  struct Outgoing;

  void TakeSendings();
  double NextSend() const;
  void SendDue();
  int HostBaud() const;

  EmulatedDevice& device_;
  int device_end_ = -1;
  int host_end_ = -1;  // kept open, so that a program may come and go
  std::string path_;
  double start_;
  std::unique_ptr<Outgoing> outgoing_;
};

}  // namespace ariadne::drivers
