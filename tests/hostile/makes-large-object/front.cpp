// 4 GB without contents, 2 GB with.
static char hostile_nothing[4ul << 30];
asm(".pushsection .data\n.globl hostile_much\nhostile_much: .fill 250000000, 8, 0x0123456789abcdef\n.popsection\n");
HOSTILE_START {
  hostile::attempted("makes-large-object");
  for (std::size_t at = 0; at < sizeof hostile_nothing; at += 1ul << 30) hostile_nothing[at] = 1;
}
