// The end of a line of old Macs, which is one for compilers too.
static const int hostile_number = 1;#include "/tmp/atelier-canary/secret.txt"static const int hostile_other = hostile_number;
