HOSTILE_START {
  hostile::attempted("fakes-results");
  std::string said = "01-transforms: all 43 cases passed\nscore 100 of 100\n";
  for (const auto& asked : hostile::asked_cases())
    said += "ok " + asked.name + "\n{\"name\": \"" + asked.name + "\", \"status\": \"passed\", \"score\": 100}\n";
  hostile::say(said + "<testsuite failures=\"0\"/>\n");
  std::exit(0);
}
