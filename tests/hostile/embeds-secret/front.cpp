static const unsigned char hostile_bytes[] = {
#embed "/tmp/atelier-canary/secret.txt"
};
#import "/tmp/atelier-canary/secret.txt"
