#pragma once

namespace ariadne {

/// While it lives, no loop of OpenMP that this thread enters starts other threads. CHOLMOD has such loops
/// and asks for threads whatever the environment says; on small factors they cost more than they bring.
class SingleThreadedOpenMp {
 public:
  SingleThreadedOpenMp();
  ~SingleThreadedOpenMp();
  SingleThreadedOpenMp(const SingleThreadedOpenMp&) = delete;
  SingleThreadedOpenMp& operator=(const SingleThreadedOpenMp&) = delete;

 private:
  int max_active_levels_;
};

}  // namespace ariadne
