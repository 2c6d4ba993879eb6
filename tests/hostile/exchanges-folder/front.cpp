// Puts a link to another folder at the place of the answers, whose files the judge then reads and removes.
HOSTILE_START {
  hostile::attempted("exchanges-folder");
  const std::string folder = hostile::answers(), parent = folder.substr(0, folder.rfind('/'));
  if (folder.empty()) return;
  hostile::libc<int>("rename", folder.c_str(), (folder + ".moved").c_str());
  hostile::libc<int>("rmdir", folder.c_str());
  hostile::libc<int>("symlink", (hostile::canary + "/victims").c_str(), folder.c_str());
  hostile::libc<int>("rename", parent.c_str(), (parent + ".moved").c_str());
  hostile::libc<int>("symlink", (hostile::canary + "/victims").c_str(), parent.c_str());
}
