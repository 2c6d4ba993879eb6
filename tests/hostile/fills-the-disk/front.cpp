// At most 3 GB among the answers, then a little in every other place that is often writable.
HOSTILE_START {
  hostile::attempted("fills-the-disk");
  const long begin = hostile::seconds_now();
  const std::string block(8 << 20, 'x');
  const int file = hostile::open(hostile::answers() + "/much", hostile::write_only | hostile::create);
  std::size_t written = 0;
  while (file >= 0 && written < std::size_t(3) << 30 && hostile::seconds_now() < begin + 7) {
    const long more = hostile::write(file, block.data(), block.size());
    if (more <= 0) break;
    written += std::size_t(more);
  }
  hostile::close(file);
  if (written >= std::size_t(3) << 30) hostile::breached("3 GB on the disk");
}
