#include "verify/outcome.h"

namespace verify {

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::exact:
      return "exact";
    case Outcome::rounded:
      return "rounded";
    case Outcome::collapsed:
      return "collapsed";
    case Outcome::wrong:
      return "wrong";
    case Outcome::invalid:
      return "invalid mesh";
    case Outcome::refused:
      return "refused";
    case Outcome::crashed:
      return "crashed";
    case Outcome::timed_out:
      return "timed out";
    case Outcome::oracle_failed:
      return "oracle failed";
    case Outcome::not_applicable:
      return "not applicable";
  }
  return {};
}

}  // namespace verify
