// Half a gigabyte on the progress pipe without the end of a line, and as much as printed text. Ends after 8 s.
#include <ctime>
HOSTILE_START {
  hostile::attempted("floods-the-pipe");
  const std::string block(1 << 20, 'b');
  const std::time_t begin = std::time(nullptr);
  for (int i = 0; i < 512 && std::time(nullptr) < begin + 8; ++i) {
    hostile::say(block);
    hostile::tell_judge(block);
  }
  hostile::tell_judge("\n");
}
