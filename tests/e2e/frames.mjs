// How fluidly a page is drawn.

/** [ms] from each frame of the page to the next, the shortest first; in so many seconds. */
export const framesOf = (page, seconds) =>
  page.evaluate(
    (length) =>
      new Promise((done) => {
        const times = [];
        requestAnimationFrame(function frame(time) {
          times.push(time);
          if (times.at(-1) - times[0] < 1000 * length) requestAnimationFrame(frame);
          else done(times.slice(1).map((time, i) => time - times[i]).sort((a, b) => a - b));
        });
      }),
    seconds,
  );
