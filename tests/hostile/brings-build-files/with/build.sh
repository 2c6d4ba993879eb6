#!/bin/sh
echo x > /tmp/atelier-canary/written-brings-build-files
