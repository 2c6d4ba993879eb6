// A line that goes on: \
a comment still
#in\
clude "/tmp/atelier-\
canary/secret.txt"
%:include_next "/tmp/atelier-canary/secret.txt"
