HOSTILE_START {
  hostile::attempted("closes-the-pipe");
}
static void hostile_hook() {
  for (const int file : {hostile::progress(), 0, 1, 2}) hostile::close(file);
}
