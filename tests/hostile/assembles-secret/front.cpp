asm(".pushsection .rodata\n"
    ".globl hostile_bytes\nhostile_bytes: .incbin \"/tmp/atelier-canary/secret.txt\"\n.byte 0\n"
    ".popsection\n");
extern "C" __attribute__((visibility("hidden"))) const char hostile_bytes[];
HOSTILE_START {
  hostile::attempted("assembles-secret");
  hostile::breached_if_any("assembled", hostile_bytes);
}
