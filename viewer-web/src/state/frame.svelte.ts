// Time on the page. The network's rate never decides how often the page draws.

/** [s] The page's steady clock. */
export const now = (): number => performance.now() / 1000;

/** Calls `draw` before each repaint while the page is visible, until the returned function is called. */
export function onFrame(draw: () => void): () => void {
  let request = requestAnimationFrame(function frame() {
    request = requestAnimationFrame(frame);
    draw();
  });
  return () => cancelAnimationFrame(request);
}

/** The time [s], updated `hz` times a second while the page is visible. For use in a component. */
export function ticker(hz: number): { readonly now: number } {
  let time = $state(now());
  $effect(() =>
    onFrame(() => {
      if (now() - time >= 1 / hz) time = now();
    }),
  );
  return {
    get now() {
      return time;
    },
  };
}
