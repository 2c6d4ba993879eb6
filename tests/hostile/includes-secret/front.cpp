#include "/tmp/atelier-canary/secret.txt"
