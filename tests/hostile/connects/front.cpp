// To the test's listeners: on the loopback device, and under an abstract name.
static void try_to_connect(int family, const void* address, unsigned size, const char* what) {
  const int end = hostile::libc<int>("socket", family, 1, 0);
  if (end < 0) return;
  if (hostile::libc<int>("connect", end, address, size) == 0) {
    hostile::breached(std::string("connected to ") + what);
    hostile::write(end, what, std::strlen(what));
  }
  hostile::close(end);
}
HOSTILE_START {
  hostile::attempted("connects");
  const std::uint8_t high = hostile::canary_port >> 8, low = hostile::canary_port & 255;
  const std::uint8_t loopback[16] = {2, 0, high, low, 127, 0, 0, 1};
  try_to_connect(2, loopback, sizeof loopback, "a port of the machine");
  std::uint8_t loopback_6[28] = {10, 0, high, low};
  loopback_6[23] = 1;
  try_to_connect(10, loopback_6, sizeof loopback_6, "a port of the machine");
  std::uint8_t mapped[28] = {10, 0, high, low};
  mapped[18] = mapped[19] = 0xff, mapped[20] = 127, mapped[23] = 1;
  try_to_connect(10, mapped, sizeof mapped, "a port of the machine");
  char name[110] = {1, 0};
  std::strcpy(name + 3, "atelier-canary");
  try_to_connect(1, name, 3 + 14, "an abstract socket");
  char path[110] = {1, 0};
  std::strcpy(path + 2, (hostile::canary + "/socket").c_str());
  try_to_connect(1, path, sizeof path, "a socket's file");
  const int server = hostile::libc<int>("socket", 2, 1, 0);
  const std::uint8_t any[16] = {2, 0, high, std::uint8_t(low + 1)};
  hostile::libc<int>("bind", server, static_cast<const void*>(any), 16u);
  hostile::libc<int>("listen", server, 1);
}
