// Answers every case with something that is no plain file, says so on the pipe, and leaves.
static void make_special(const std::string& path, std::size_t kind) {
  switch (kind % 9) {
    case 0:
      hostile::libc<int>("symlink", hostile::secret_file.c_str(), path.c_str());
      break;
    case 1:
      hostile::libc<int>("mkfifo", path.c_str(), 0644);
      break;
    case 2:
      hostile::libc<int>("symlink", "/dev/zero", path.c_str());
      break;
    case 3:
      hostile::libc<int>("mknod", path.c_str(), 020644, 0x105ul);
      break;  // the device of /dev/zero
    case 4:
      hostile::libc<int>("link", hostile::secret_file.c_str(), path.c_str());
      break;
    case 5:
      hostile::libc<int>("mkdir", path.c_str(), 0);
      break;
    case 6:
      hostile::libc<int>("symlink", path.c_str(), path.c_str());
      break;
    case 7: {
      const int sparse = hostile::open(path, hostile::write_only | hostile::create);
      hostile::libc<int>("ftruncate", sparse, 1l << 42);
      hostile::close(sparse);
      break;
    }
    case 8: {
      hostile::write_file(path, "a file that nobody may read");
      hostile::libc<int>("chmod", path.c_str(), 0);
      break;
    }
  }
}
HOSTILE_START {
  hostile::attempted("special-files");
  const char* const endings[] = {".pixels", ".values", ".error", ".exception", ".build_error", ".stats"};
  std::size_t kind = 0;
  for (const auto& asked : hostile::asked_cases()) {
    hostile::tell_judge("begin " + asked.name + "\n");
    make_special(hostile::answers() + "/" + asked.name + endings[kind % 6], kind);
    make_special(hostile::answers() + "/" + asked.name + (asked.probe ? ".values" : ".pixels"), kind / 2);
    ++kind;
    hostile::tell_judge("end " + asked.name + "\n");
    hostile::libc<int>("usleep", 2000u);
  }
  hostile::leave(0);
}
