# Loosefit on Debian 12: docker build -t loosefit . && docker run --rm -v "$PWD:/case" loosefit run case.toml -o out
FROM debian:12 AS build
COPY tools/setup_packages.sh /source/tools/
RUN apt-get update && /source/tools/setup_packages.sh && apt-get install -y --no-install-recommends file dpkg-dev
COPY . /source
WORKDIR /source
RUN cmake --preset package && cmake --build --preset package \
    && cd build-package && cpack -G DEB && cp loosefit_*.deb /loosefit.deb

FROM debian:12
COPY --from=build /loosefit.deb /tmp/
RUN apt-get update && apt-get install -y --no-install-recommends /tmp/loosefit.deb npm ca-certificates xvfb \
    && loosefit setup && rm -rf /var/lib/apt/lists/* /tmp/loosefit.deb
WORKDIR /case
ENTRYPOINT ["loosefit"]
CMD ["--help"]
