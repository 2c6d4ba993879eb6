#pragma GCC system_header
#pragma GCC plugin "/tmp/atelier-canary/plugin.so"
#pragma comment(lib, "/tmp/atelier-canary/plugin.so")
#pragma GCC pch_preprocess "/tmp/atelier-canary/secret.txt"
#pragma clang module import secret
#pragma push_macro("private")
#pragma GCC optimize("plugin=/tmp/atelier-canary/plugin.so")
_Pragma("GCC diagnostic ignored \"-Wall\"")
