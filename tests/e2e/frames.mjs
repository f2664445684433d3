// The frame rate of a page.

/** Returns the times [ms] between frames of the page over some seconds, the shortest first. */
export const framesOf = (page, seconds) =>
  page.evaluate(
    (length) =>
      new Promise((done) => {
        const times = [];
        requestAnimationFrame(function frame(time) {
          times.push(time);
          if (times.at(-1) - times[0] < 1000 * length) requestAnimationFrame(frame);
          else
            done(
              times
                .slice(1)
                .map((time, i) => time - times[i])
                .sort((a, b) => a - b),
            );
        });
      }),
    seconds,
  );
