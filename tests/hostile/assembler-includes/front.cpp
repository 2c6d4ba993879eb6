asm(".include \"/tmp/atelier-canary/secret.txt\"\n.print \"what the assembler prints\"\n");
