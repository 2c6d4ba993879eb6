// Nobody may read or remove what is left: folders without permissions, the answers' folder among them.
HOSTILE_START {
  hostile::attempted("locked-files");
  const std::string folder = hostile::answers();
  hostile::libc<int>("mkdir", (folder + "/locked").c_str(), 0755);
  hostile::libc<int>("mkdir", (folder + "/locked/in").c_str(), 0755);
  hostile::write_file(folder + "/locked/in/file", "x");
  for (const char* name : {"/locked/in", "/locked"}) hostile::libc<int>("chmod", (folder + name).c_str(), 0);
}
static void hostile_hook() {
  hostile::libc<int>("chmod", hostile::answers().c_str(), 0);
}
