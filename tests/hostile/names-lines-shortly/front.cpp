# 1 "/tmp/atelier-canary/secret.txt" 1 3
static const int hostile_number = "a message that shows the line";
