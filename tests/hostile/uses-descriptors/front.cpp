// Reads what is open, and leaves through open folders. Also answers whoever listens at an open socket.
HOSTILE_START {
  hostile::attempted("uses-descriptors");
  for (int file = 3; file < 1024; ++file) {
    if (hostile::libc<int>("fcntl", file, 1) < 0 || file == hostile::progress()) continue;  // F_GETFD
    char block[256] = {};
    if (hostile::libc<long>("pread", file, static_cast<void*>(block), 255ul, 0l) > 0 &&
        std::string(block).find("canary") != std::string::npos)
      hostile::breached("inherits a file: " + std::string(block));
    for (const std::string& up : {std::string("."), std::string("../../../../../../../../../..")}) {
      const int found = hostile::libc<int>("openat", file, (up + hostile::secret_file).c_str(), hostile::read_only);
      if (found >= 0) hostile::breached("leaves through an open folder: " + hostile::read_from(found));
    }
    const char answer[] = "end of everything\n\0\xff\xff\xff\xff";
    hostile::libc<long>("send", file, static_cast<const void*>(answer), sizeof answer, 0x4040);  // NOSIGNAL, DONTWAIT
  }
}
