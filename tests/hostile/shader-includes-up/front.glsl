#include "01-transforms/../../../../../../../tmp/atelier-canary/secret.txt"
