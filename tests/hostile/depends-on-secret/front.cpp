// The compiler opens the file that is named here, compares its time, and says so.
#pragma GCC dependency "/tmp/atelier-canary/secret.txt" whose time has been read
_Pragma("GCC dependency \"/tmp/atelier-canary/secret.txt\" whose time has been read")
