#include "../../../../../../../../tmp/atelier-canary/secret.txt"
#include <../../../../../../../../tmp/atelier-canary/secret.txt>
