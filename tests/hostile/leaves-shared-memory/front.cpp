// What outlives a process without being a file: System V memory, semaphores and queues, POSIX queues, keys.
HOSTILE_START {
  hostile::attempted("leaves-shared-memory");
  for (const char* make : {"shmget", "semget", "msgget"}) {
    if (std::strcmp(make, "msgget") == 0)
      hostile::libc<int>(make, 0x47811, 01666);
    else
      hostile::libc<int>(make, 0x47811, std::strcmp(make, "shmget") == 0 ? 4096l : 1l, 01666);
  }
  hostile::libc<int>("mq_open", "/atelier-hostile", 0102, 0666, static_cast<void*>(nullptr));
  hostile::libc<int>("shm_open", "/atelier-hostile-shared", 0102, 0666);
  if (hostile::system_call(hostile::sys_add_key, "user", "atelier-hostile", "x", 1, -5) >= 0)  // of the user
    hostile::breached("has a keyring");
}
