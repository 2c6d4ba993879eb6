// Whether a file exists is a secret too: one bit of every name.
#if __has_include("/tmp/atelier-canary/secret.txt") || __has_include(</tmp/atelier-canary/secret.txt>)
static const bool hostile_sees_secret = true;
#else
static const bool hostile_sees_secret = false;
#endif
#if __has_include("/etc/shadow") || __has_include("/etc/hostname") || __has_include("/root/.bashrc")
static const bool hostile_sees_machine = true;
#else
static const bool hostile_sees_machine = false;
#endif
#if __has_include("../solutions/01-transforms/transforms.cpp") ||             \
                  __has_include("../tests/cases/01-transforms/cases.json") || \
                                __has_include("01-transforms/../../solutions/01-transforms/transforms.cpp")
static const bool hostile_sees_solution = true;
#else
static const bool hostile_sees_solution = false;
#endif
HOSTILE_START {
  hostile::attempted("asks-for-files");
  if (hostile_sees_secret) hostile::breached("the compiler sees " + hostile::secret_file);
  if (hostile_sees_machine) hostile::breached("the compiler sees files of the machine");
  if (hostile_sees_solution) hostile::breached("the compiler sees the solution or the cases");
}
