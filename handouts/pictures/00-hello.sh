draw 00-triangle $step && single 00-triangle
