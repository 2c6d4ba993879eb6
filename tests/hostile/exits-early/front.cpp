// From within a case, as if all were done.
HOSTILE_START {
  hostile::attempted("exits-early");
}
static void hostile_hook() {
  std::exit(0);
}
