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

std::string to_string(Cause::Kind kind) {
  switch (kind) {
    case Cause::Kind::no_answer:
      return "no_answer";
    case Cause::Kind::function:
      return "function";
    case Cause::Kind::unwritten:
      return "unwritten";
    case Cause::Kind::picture:
      return "picture";
    case Cause::Kind::choice:
      return "choice";
  }
  return "picture";
}

}  // namespace atelier::judge
