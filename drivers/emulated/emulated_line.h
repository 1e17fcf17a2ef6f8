#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "drivers/emulated/emulated_device.h"
#include "drivers/emulated/line_fault.h"
#include "drivers/hardware/byte_stream.h"

namespace ariadne::drivers {

struct EmulatedLineOptions {
  double chunk_time = 0.001;  // what arrives within it is read at once, as from an adapter [s]
  std::uint64_t seed = 1;     // of the noise that bytes of another rate become
};

/// The host's end of a line to an emulated device, in virtual time: it goes on while the host reads,
/// without threads and without waiting. The device must outlive it.
class EmulatedLine : public ByteStream {
 public:
  explicit EmulatedLine(EmulatedDevice& device, const EmulatedLineOptions& options = {});

  /// Faults that will happen, in any order.
  void Inject(const LineFault& fault);
  std::size_t pending_faults() const { return faults_.size(); }

  std::string name() const override { return "an emulated line"; }
  double Now() const override { return now_; }
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
  void Collect(double time);
  void Arrive(double time, std::uint8_t byte);
  Bytes TakeArrived();
  bool IsDead(double time) const;
  std::vector<LineFault> FaultsOfByte(double time, bool to_device);

  EmulatedDevice& device_;
  EmulatedLineOptions options_;
  RandomStream noise_;
  double now_ = 0.0;
  int baud_ = 9600;
  std::deque<Arrival> arrivals_;
  std::deque<Request> requests_;
  std::vector<LineFault> faults_;
  double held_until_ = 0.0;
  double last_arrival_ = 0.0;
  double sent_until_ = 0.0;
};

}  // namespace ariadne::drivers
