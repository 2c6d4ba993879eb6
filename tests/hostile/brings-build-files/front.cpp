HOSTILE_START {
  hostile::attempted("brings-build-files");
}
