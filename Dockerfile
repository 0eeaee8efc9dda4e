# Builds Flipbook from the same package list as the scripts.
#   docker build -t flipbook .
#   docker run --rm -v "$PWD/out:/out" flipbook compare dam_break -o /out/dam_break.mp4
FROM debian:12-slim
WORKDIR /flipbook
COPY packages.txt .ci/packages.sh ./
RUN mkdir .ci && mv packages.sh .ci/ && bash -c '. .ci/packages.sh && need_packages build run' && rm -rf /var/lib/apt/lists/*
COPY . .
RUN cmake --preset release -DFLIPBOOK_TESTS=OFF && cmake --build --preset release && cmake --install build/release --prefix /usr/local
ENTRYPOINT ["flipbook"]
