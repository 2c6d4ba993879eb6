// 100 000 files and 3000 folders within one another among the answers; the judge has to remove them. Ends after 7 s.
HOSTILE_START {
  hostile::attempted("many-files");
  const std::string folder = hostile::answers();
  const long begin = hostile::seconds_now();
  hostile::in_child([&] {
    if (hostile::libc<int>("chdir", folder.c_str()) != 0) return;
    for (int i = 0; i < 3000; ++i)
      if (hostile::libc<int>("mkdir", "deeper", 0755) != 0 || hostile::libc<int>("chdir", "deeper") != 0) break;
    hostile::libc<int>("chmod", "..", 0);
  });
  for (int i = 0; i < 100'000 && hostile::seconds_now() < begin + 7; ++i)
    if (!hostile::write_file(folder + "/" + std::to_string(i) + std::string(200, 'x'), "")) break;
}
