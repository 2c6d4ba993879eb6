#include "/dev/stdin"
#include "/proc/self/environ"
#include "/dev/zero"
