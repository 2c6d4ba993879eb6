HOSTILE_START {
  hostile::attempted("reads-secret");
  for (const std::string& path :
       {hostile::secret_file, "/proc/self/root" + hostile::secret_file,
        "/proc/self/cwd/../../../../../../../.." + hostile::secret_file, "/proc/1/root" + hostile::secret_file,
        "/proc/" + std::to_string(hostile::libc<int>("getppid")) + "/root" + hostile::secret_file})
    hostile::breached_if_any("read " + path, hostile::read_file(path));
  if (hostile::libc<int>("inotify_add_watch", hostile::libc<int>("inotify_init1", 0), hostile::canary.c_str(), 0xfff) >=
      0)
    hostile::breached("watches " + hostile::canary);
}
static void hostile_hook() {
  hostile::breached_if_any("read during a case", hostile::read_file(hostile::secret_file));
  hostile::throw_what_was_reached();
}
