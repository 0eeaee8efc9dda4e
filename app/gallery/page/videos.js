// SPDX-License-Identifier: MIT
// Videos play while they are in view, unless a person has paused them or wants less motion. Nothing is loaded before.
{
  const still = matchMedia("(prefers-reduced-motion: reduce)");

  for (const section of document.querySelectorAll('[data-kind="video"]')) {
    const video = section.querySelector("video");
    let ours = false; // is the pause that comes our doing?
    let held = false; // has a person paused it?
    video.addEventListener("pause", () => {
      held = !ours && !video.ended;
      ours = false;
    });
    video.addEventListener("play", () => (held = false));

    const watch = new IntersectionObserver(
      ([entry]) => {
        if (entry.isIntersecting) {
          if (!held && !still.matches) video.play().catch(() => {}); // a browser may refuse: there are controls
        } else if (!video.paused) {
          ours = true;
          video.pause();
        }
      },
      { threshold: 0.6 },
    );
    watch.observe(video);

    for (const button of section.querySelectorAll("[data-seek]"))
      button.addEventListener("click", () => {
        const seek = () => (video.currentTime = Number(button.dataset.seek));
        if (video.readyState >= HTMLMediaElement.HAVE_METADATA) seek();
        else {
          video.addEventListener("loadedmetadata", seek, { once: true });
          video.load();
        }
        video.scrollIntoView({ block: "nearest" });
      });
  }
}
