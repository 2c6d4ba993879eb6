// Sections that linkers and loaders read: libraries to link, an interpreter, a warning, an executable stack.
asm(".pushsection .deplibs,\"MS\",@0x6fff4c04,1\n.asciz \"/tmp/atelier-canary/plugin.so\"\n.popsection\n"
    ".pushsection .interp,\"a\"\n.asciz \"/tmp/atelier-canary/plugin.so\"\n.popsection\n"
    ".pushsection .gnu.warning\n.ascii \"\\033[31m<script>alert('atelier-hostile')</script>\"\n.popsection\n"
    ".pushsection .note.GNU-stack,\"x\",@progbits\n.popsection\n"
    ".pushsection .drectve,\"a\"\n.ascii \"-l/tmp/atelier-canary/plugin.so\"\n.popsection\n");
HOSTILE_START {
  hostile::attempted("links-more");
}
