// A thread that writes into answers that have been given, and removes the folder under the judge.
static void* rewrite(void*) {
  const std::string folder = hostile::answers();
  for (int i = 0; i < 100'000; ++i) {
    for (const std::string& name : hostile::entries(folder, 200)) {
      const int file = hostile::open(folder + "/" + name, hostile::write_only);
      if (file < 0) continue;
      const float much[64] = {1e30f};
      hostile::libc<long>("pwrite", file, static_cast<const void*>(much), sizeof much, 16l);
      hostile::libc<int>("ftruncate", file, i % 2 ? 0l : 1l << 40);
      hostile::close(file);
    }
    hostile::libc<int>("usleep", 200u);
  }
  return nullptr;
}
HOSTILE_START {
  hostile::attempted("rewrites-answers");
  unsigned long thread = 0;
  hostile::libc<int>("pthread_create", &thread, static_cast<void*>(nullptr), &rewrite, static_cast<void*>(nullptr));
}
