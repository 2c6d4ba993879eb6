# Atelier in a container, set up by the same launcher as everywhere else.
#
#   docker build --tag atelier .
#   docker run --rm --volume "$PWD/submission:/submission:ro" --volume "$PWD/out:/atelier/out" atelier grade /submission
#
# Without a command it says what it has. Another Debian: --build-arg DEBIAN=trixie (docs/platforms.md).
ARG DEBIAN=bookworm
FROM debian:${DEBIAN}-slim
WORKDIR /atelier
COPY . .
RUN ./atelier --yes list && rm -rf /var/lib/apt/lists/*
ENTRYPOINT ["./atelier"]
CMD ["doctor"]
