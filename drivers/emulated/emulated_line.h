#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>

#include "drivers/emulated/emulated_device.h"
#include "drivers/emulated/line_faults.h"
#include "drivers/hardware/byte_stream.h"

namespace ariadne::drivers {

/// The time of a host that talks over several lines: it goes on on all of them.
struct VirtualTime {
  double now = 0.0;  // [s]
};

struct EmulatedLineOptions {
  std::string name = "an emulated line";
  double chunk_time = 0.001;          // what arrives within it is read at once, as from an adapter [s]
  std::size_t buffer = 1U << 20U;     // of the host, beyond which what arrives unread is lost [B]
  std::size_t read_size = 4096;       // that one read takes at most, as from a terminal [B]
  std::uint64_t seed = 1;             // of the noise that bytes of another rate become
  std::shared_ptr<VirtualTime> time;  // of all lines of a host; none: its own
};

/// The host's end of a line to an emulated device, in virtual time: it goes on while the host reads,
/// without threads and without waiting. The device must outlive it.
class EmulatedLine : public ByteStream {
 public:
  explicit EmulatedLine(EmulatedDevice& device, const EmulatedLineOptions& options = {});

  /// Faults that will happen, in any order.
  void Inject(const LineFault& fault) { faults_.Inject(fault); }
  std::size_t pending_faults() const { return faults_.pending(); }
  /// Bytes that were lost because the host did not read.
  std::uint64_t overrun() const { return overrun_; }

  std::string name() const override { return options_.name; }
  double Now() const override { return time_->now; }

  /// Lets the device live up to a time that the host has not reached yet, because another device, to which
  /// it is coupled, is there already. The host cannot write before, as it waits for that other one.
  void CatchUp(double time) { GoTo(time); }

  Bytes Read(double deadline) override;
  void Write(ByteView bytes) override;
  void SetBaud(int baud) override;
  int baud() const override { return baud_; }

 private:
  struct Arrival {
    double time;
    std::uint8_t byte;
  };
  struct Request {
    double time;  // of its last byte
    int baud;
    Bytes bytes;
  };

  double NextTime() const;
  void GoTo(double time);
  void WaitTo(double time);
  void Collect(double time);
  void Arrive(double time, std::uint8_t byte);
  Bytes TakeArrived();

  EmulatedDevice& device_;
  EmulatedLineOptions options_;
  RandomStream noise_;
  std::shared_ptr<VirtualTime> time_;
  double told_ = 0.0;  // to the device [s]
  int baud_ = 9600;
  std::deque<Arrival> arrivals_;
  std::deque<Request> requests_;
  LineFaults faults_;
  std::uint64_t overrun_ = 0;
  double held_until_ = 0.0;
  double last_arrival_ = 0.0;
  double sent_until_ = 0.0;
};

}  // namespace ariadne::drivers
