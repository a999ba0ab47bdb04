// One law of a mode as a value, whichever law it is. Copies share the law, which nothing changes.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace asperity {

/// `Mode` names itself and has the Interface of its laws, and Held<Law>, the interface to one type of them.
template <class Mode>
class LawOf {
 public:
  template <class Law, class = std::enable_if_t<!std::is_same_v<Law, LawOf>>>
  LawOf(Law law) : law_(std::make_shared<const typename Mode::template Held<Law>>(std::move(law))) {}

  const typename Mode::Interface* operator->() const { return law_.get(); }

 private:
  std::shared_ptr<const typename Mode::Interface> law_;
};

}  // namespace asperity
