// Time on the page: the network's rate never decides how often something is drawn.

/** [s] our own steady clock. */
export const now = (): number => performance.now() / 1000;

/** Calls `draw` before each repaint while the page is visible, until the returned function is called. */
export function onFrame(draw: () => void): () => void {
  let request = requestAnimationFrame(function frame() {
    request = requestAnimationFrame(frame);
    draw();
  });
  return () => cancelAnimationFrame(request);
}

/** The time [s], a few times a second while the page is visible: what reads it is drawn again. For use in a component. */
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
