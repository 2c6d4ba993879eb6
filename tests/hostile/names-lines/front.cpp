#line 1 "/tmp/atelier-canary/secret.txt"
static const int hostile_number = "a message that shows the line";
