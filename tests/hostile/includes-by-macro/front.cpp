#define HOSTILE_TEXT(x) #x
#define HOSTILE_NAME(x) HOSTILE_TEXT(x)
#define HOSTILE_FILE HOSTILE_NAME(/tmp/atelier-canary/secret.txt)
#include HOSTILE_FILE
