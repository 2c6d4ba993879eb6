#include "app/thrown.hpp"

#include <cxxabi.h>
#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <typeinfo>

#include "base/printable.hpp"

namespace atelier {

namespace {

[[noreturn]] void tell_and_abort() {
  fmt::print(stderr, "error: {}\n", printable(thrown_in_words()));
  std::abort();
}

}  // namespace

std::string demangle(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> plain(abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status),
                                                     std::free);
  return status == 0 ? plain.get() : symbol;
}

std::string thrown_in_words() {
  const std::type_info* type = abi::__cxa_current_exception_type();
  if (!type) return "std::terminate was called";
  const std::string name = demangle(type->name());
  try {
    throw;
  } catch (const std::exception& error) {
    return fmt::format("{} was thrown: {}", name, error.what());
  } catch (const std::string& text) {
    return "std::string was thrown: " + text;
  } catch (const char* text) {
    return "a string was thrown: " + std::string(text ? text : "(null)");
  } catch (int number) {
    return fmt::format("int was thrown: {}", number);
  } catch (...) {
    return name + " was thrown";
  }
}

void tell_what_was_thrown_before_aborting() {
  std::set_terminate(tell_and_abort);
}

}  // namespace atelier
