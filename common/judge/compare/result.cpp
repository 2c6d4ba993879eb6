#include "judge/compare/result.hpp"

namespace atelier::judge {

std::string to_string(Status status) {
  switch (status) {
    case Status::passed:
      return "passed";
    case Status::failed:
      return "failed";
    case Status::missing:
      return "missing";
    case Status::crashed:
      return "crashed";
    case Status::timeout:
      return "timeout";
    case Status::build_failed:
      return "build_failed";
  }
  return "failed";
}

}  // namespace atelier::judge
