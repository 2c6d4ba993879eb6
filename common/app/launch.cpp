// `main` of every step program; the build defines the step.
#include "app/shell.hpp"

int main(int count, char** arguments) {
  return atelier::run_step(count, arguments, {.name = ATELIER_STEP, .libraries = {ATELIER_STEP_LIBRARIES}});
}
