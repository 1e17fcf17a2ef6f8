#include "drivers/hardware/memory_line.h"

#include <algorithm>
#include <utility>

namespace ariadne::drivers {

struct MemoryLine::End : ByteStream {
  explicit End(MemoryLine* owner) : line(owner) {}

  std::string name() const override { return "a line in memory"; }
  double Now() const override { return line->now_; }
  int baud() const override { return rate; }

  Bytes Read(double deadline) override {
    FailIfCut();
    if (inbox.empty()) line->now_ = std::max(line->now_, deadline);
    return std::exchange(inbox, {});
  }
  void Write(ByteView bytes) override {
    FailIfCut();
    for (const std::uint8_t byte : bytes) {
      const bool same = rate == far->rate;
      far->inbox.push_back(same ? byte : static_cast<std::uint8_t>(byte ^ 0xA5));
    }
  }
  void SetBaud(int new_rate) override {
    FailIfCut();
    rate = new_rate;
    inbox.clear();
  }
  void FailIfCut() const {
    if (line->cut_) Fail("{} was cut", name());
  }

  MemoryLine* line;
  End* far = nullptr;
  int rate = 9600;
  Bytes inbox;
};

MemoryLine::MemoryLine() {
  auto one = std::make_unique<End>(this);
  auto other = std::make_unique<End>(this);
  one->far = other.get();
  other->far = one.get();
  ends_ = {std::move(one), std::move(other)};
}

}  // namespace ariadne::drivers
