#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>

#include "drivers/emulated/emulated_device.h"
#include "drivers/emulated/line_faults.h"

namespace ariadne::drivers {

/// A pseudo-terminal behind which an emulated device sits, so that any program can talk to it as over a
/// serial port. The rate of the device's end is what the program sets, as a line would have it. Time is the
/// system's monotonic clock, from when the server was made.
class PtyServer {
 public:
  /// The device must outlive the server.
  explicit PtyServer(EmulatedDevice& device);
  /// With the time of another one, whose device is coupled to this one.
  PtyServer(EmulatedDevice& device, const PtyServer& other);
  ~PtyServer();
  PtyServer(const PtyServer&) = delete;
  PtyServer& operator=(const PtyServer&) = delete;

  /// What the program opens, for example /dev/pts/5.
  const std::string& path() const { return path_; }

  /// Serves until it is told to stop, within `poll` [s].
  void Serve(const std::stop_token& stop, double poll = 0.02);

  double Now() const;

  /// Faults that will happen, in any order.
  void Inject(const LineFault& fault) { faults_.Inject(fault); }

  /// Serves several that have the same time, in turns, as long as `goes_on` says at each moment [s]. At any
  /// moment the devices live up to it in this order.
  static void ServeAll(std::span<PtyServer* const> servers, const std::function<bool(double now)>& goes_on,
                       double poll = 0.02);

  /// Lets the device live up to a time because one before it in this order needs that.
  void CatchUp(double time) { TakeSendings(time); }

 private:
  struct Outgoing;

  PtyServer(EmulatedDevice& device, double start);

  void TakeSendings(double time);
  double NextSend() const;
  void SendDue();
  Bytes PieceOf(const Sending& sending, std::size_t from, std::size_t to);
  void Receive(ByteView bytes, double time);
  int HostBaud() const;

  EmulatedDevice& device_;
  int device_end_ = -1;
  int host_end_ = -1;  // kept open, so that a program may come and go
  std::string path_;
  double start_;
  double held_until_ = 0.0;  // by a fault [s]
  LineFaults faults_;
  std::unique_ptr<Outgoing> outgoing_;
};

}  // namespace ariadne::drivers
