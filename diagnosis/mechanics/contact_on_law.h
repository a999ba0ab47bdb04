// A contact that is another law with something done to it: a burst, a bridge, an attraction.
#pragma once

#include <memory>

#include "diagnosis/mechanics/normal_contact.h"

namespace asperity {

/// Holds a copy of the law with its history; what it does not change is the law's.
class ContactOnLaw : public NormalContact {
 public:
  explicit ContactOnLaw(const NormalContact& law) : law_(law.clone()) {}
  ContactOnLaw(const ContactOnLaw& other) : law_(other.law_->clone()) {}
  double release() const override { return law_->release(); }
  void begin_step(double time_step) override { law_->begin_step(time_step); }
  void accept(double displacement) override { law_->accept(displacement); }

 protected:
  const NormalContact& law() const { return *law_; }

 private:
  std::unique_ptr<NormalContact> law_;
};

}  // namespace asperity
