// A display for drawing without a screen: an X server of our own (Xvfb), ended with this object.
#pragma once

#include <sys/types.h>

#include <string>

namespace asperity::report {

class VirtualDisplay {
 public:
  /// Starts Xvfb on a free display; without Xvfb, takes the display there is.
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

  bool available() const { return !name_.empty(); }
  bool is_own_server() const { return server_ > 0; }
  const std::string& name() const { return name_; }        ///< ":7", the value for DISPLAY
  const std::string& problem() const { return problem_; }  ///< what to do if there is none

 private:
  std::string name_, problem_;
  pid_t server_ = -1;
};

}  // namespace asperity::report
