// Where and when it was compiled: paths of the machine of the one who grades.
HOSTILE_START {
  hostile::attempted("tells-names");
  hostile::say(std::string("compiled as ") + __FILE__ + " of " + __builtin_FILE() + " at " + __DATE__ + " " + __TIME__ +
               "\n");
  for (const std::string& place :
       {std::string("/tmp/atelier-canary"), std::string("/solutions/"), std::string("/tests/")})
    if (std::string(__FILE__).find(place) != std::string::npos) hostile::breached("its own name leads to " + place);
}
